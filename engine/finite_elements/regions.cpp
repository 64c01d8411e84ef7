#include "engine/finite_elements/regions.hpp"

#include "engine/finite_elements/fields.hpp"

namespace pliant::finite_elements {

namespace {

/// The group of the point-based method that has the same arrays as a group of this one.
point_based::Group group_of_nodes(Group group) {
  using Nodes = point_based::Group;
  switch (group) {
    case Group::displacement:
      return Nodes::displacement;
    case Group::velocity:
      return Nodes::velocity;
    case Group::constants:
      return Nodes::constants;
    case Group::loads:
      return Nodes::loads;
    case Group::own_sums:
      return Nodes::own_forces;
    case Group::halo_sums:
      return Nodes::halo_forces;
    default:
      return Nodes::results;
  }
}

}  // namespace

template <class T, int D>
std::vector<point_based::Region> regions(State<T, D>& state, scheduler::FieldId resource,
                                         int block) {
  const Group group = resource_numbers[resource].group;
  std::vector<point_based::Region> found = point_based::regions<T, D>(
      state, point_based::resource_numbers({group_of_nodes(group)}), block);
  const auto add = [&found](auto* values, std::int64_t count) {
    using Value = std::remove_pointer_t<decltype(values)>;
    found.push_back({std::as_writable_bytes(std::span(values, static_cast<std::size_t>(count))),
                     std::is_same_v<Value, T>});
  };
  const auto [owner, local] = state.blocks[block];
  Elements<T, D>& elements = state.elements[owner];
  const ElementRange& range = elements.blocks[local];
  if (group == Group::constants) {
    add(elements.corner.get() + range.first * (D + 1), range.count * (D + 1));
    add(elements.shape.get() + range.first * kernels::element_values<D>,
        range.count * kernels::element_values<D>);
  } else if (group == Group::pressures && elements.averages()) {
    const point_based::NodeBlock& nodes = state.bodies[owner].blocks[local];
    add(elements.pressure.get() + nodes.first, nodes.count);
  }
  return found;
}

template std::vector<point_based::Region> regions<double, 2>(State<double, 2>&, scheduler::FieldId,
                                                             int);
template std::vector<point_based::Region> regions<double, 3>(State<double, 3>&, scheduler::FieldId,
                                                             int);

}  // namespace pliant::finite_elements
