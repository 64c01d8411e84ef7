#include "engine/total_lagrangian/regions.hpp"

namespace pliant::total_lagrangian {

template <class T, int D>
std::vector<std::span<std::byte>> regions(State<T, D>& state, scheduler::FieldId resource,
                                          int block) {
  std::vector<std::span<std::byte>> found;
  const auto add = [&found](auto* values, std::size_t count) {
    if (count > 0) found.push_back(std::as_writable_bytes(std::span(values, count)));
  };
  const auto [owner, local] = state.blocks[block];
  Body<T, D>& body = state.bodies[owner];
  const Group group = resource_numbers[resource].group;
  const Block<D>& range = body.layout.blocks()[local];
  body.for_each_array([&](const Declaration& field, auto components) {
    if (field.group != group) return;
    for (Buffer<T>& component : components) {
      for (int s = 0; s < range.segment_count; ++s) {
        const kernels::Segment<D>& segment = body.layout.segments_of(range)[s];
        add(component.get() + segment.first, segment.count);
      }
    }
  });
  const int first = body.first_patch[local], count = body.first_patch[local + 1] - first;
  if (group == Group::constants) {
    add(body.cells[local].fitted.data(), body.cells[local].fitted.size());
  }
  if (group == Group::patch_forces) add(body.patch_force.data() + first, count);
  if (group == Group::surface) {
    add(body.patches.data() + first, count);
    add(body.held[local].data(), body.held[local].size());
    NodalLoads& loads = body.nodal_loads[local];
    add(loads.slot.data(), loads.slot.size());
    add(loads.begin.data(), loads.begin.size());
    add(loads.patch.data(), loads.patch.size());
    add(loads.weight.data(), loads.weight.size());
  }
  return found;
}

template std::vector<std::span<std::byte>> regions<double, 2>(State<double, 2>&, scheduler::FieldId,
                                                              int);
template std::vector<std::span<std::byte>> regions<double, 3>(State<double, 3>&, scheduler::FieldId,
                                                              int);
template std::vector<std::span<std::byte>> regions<float, 2>(State<float, 2>&, scheduler::FieldId,
                                                             int);
template std::vector<std::span<std::byte>> regions<float, 3>(State<float, 3>&, scheduler::FieldId,
                                                             int);

}  // namespace pliant::total_lagrangian
