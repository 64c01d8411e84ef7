#include "engine/point_based/regions.hpp"

namespace pliant::point_based {

template <class T, int D>
std::vector<Region> regions(State<T, D>& state, scheduler::FieldId resource, int block) {
  std::vector<Region> found;
  const auto add = [&found](auto* values, std::int64_t count) {
    using Value = std::remove_pointer_t<decltype(values)>;
    if (count == 0) return;
    found.push_back({std::as_writable_bytes(std::span(values, static_cast<std::size_t>(count))),
                     std::is_same_v<Value, T>});
  };
  const auto [owner, local] = state.blocks[block];
  Body<T, D>& body = state.bodies[owner];
  const Group group = resource_numbers[resource].group;
  const NodeBlock& range = body.blocks[local];
  body.for_each_array([&](const Declaration& field, auto components) {
    if (field.group != group) return;
    for (Buffer<T>& component : components) add(component.get() + range.first, range.count);
  });
  constexpr int stride = kernels::point_stride;
  const std::int64_t bonds = static_cast<std::int64_t>(range.count) * body.bonds;
  T* const force = body.force.get() + stride * range.first_point();
  if (group == Group::own_forces) {
    add(force, stride * range.count);
  } else if (group == Group::halo_forces) {
    add(force + stride * range.count, stride * range.halo_count);
  } else if (group == Group::constants) {
    add(body.bond.get() + range.first * body.bonds * (D + 1), bonds * (D + 1));
    add(body.neighbour.get() + range.first * body.bonds, bonds);
    add(body.halo.data() + range.first_halo, range.halo_count);
    add(body.held[local].data(), static_cast<std::int64_t>(body.held[local].size()));
  } else if (group == Group::loads) {
    add(body.pressed[local].data(), static_cast<std::int64_t>(body.pressed[local].size()));
  }
  return found;
}

template std::vector<Region> regions<double, 2>(State<double, 2>&, scheduler::FieldId, int);
template std::vector<Region> regions<double, 3>(State<double, 3>&, scheduler::FieldId, int);

}  // namespace pliant::point_based
