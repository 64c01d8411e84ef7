#include "engine/remeshed/observe/field_views.hpp"

#include "engine/method/field_views.hpp"

namespace pliant::remeshed {

namespace {

template <class T, int D>
auto is_interior(const Body<T, D>& body) {
  return [&kind = body.population.kind](std::int64_t slot) { return kind[slot] == Kind::interior; };
}

}  // namespace

template <class T, int D>
std::vector<SlotRun> slot_runs(const Body<T, D>& body) {
  return runs_of_particles<D>(body.population.layout, is_interior(body));
}

// The displacement in the list of fields is that at the last remeshing, and so has another name
// here: the displacement of frames includes the drift.
template <class T, int D>
std::vector<FieldView> field_views(const Body<T, D>& body) {
  const std::int64_t slots = body.population.layout.slots();
  std::vector<FieldView> views;
  for (const Declaration& field : state_fields) {
    const auto& components = body.stage[0][field.field];
    if (components.empty()) continue;
    const bool is_displacement = field.field == Field::displacement;
    views.push_back(field_view<T>(is_displacement ? "displacement_at_remeshing" : field.name,
                                  field.unit, components, slots));
  }
  const Declaration& stress = field_list[Field::stress];
  views.push_back(field_view<T>(stress.name, stress.unit, body.stress, slots));
  return views;
}

template <class T, int D>
std::vector<std::array<double, 3>> present_positions(const Body<T, D>& body) {
  return positions_of_particles<D>(
      body.population.layout, is_interior(body),
      [&body](std::int64_t slot, const Cell<D>& cell) { return body.position(slot, cell); });
}

template std::vector<SlotRun> slot_runs<double, 2>(const Body<double, 2>&);
template std::vector<FieldView> field_views<double, 2>(const Body<double, 2>&);
template std::vector<std::array<double, 3>> present_positions<double, 2>(const Body<double, 2>&);
template std::vector<SlotRun> slot_runs<double, 3>(const Body<double, 3>&);
template std::vector<FieldView> field_views<double, 3>(const Body<double, 3>&);
template std::vector<std::array<double, 3>> present_positions<double, 3>(const Body<double, 3>&);
template std::vector<SlotRun> slot_runs<float, 2>(const Body<float, 2>&);
template std::vector<FieldView> field_views<float, 2>(const Body<float, 2>&);
template std::vector<std::array<double, 3>> present_positions<float, 2>(const Body<float, 2>&);
template std::vector<SlotRun> slot_runs<float, 3>(const Body<float, 3>&);
template std::vector<FieldView> field_views<float, 3>(const Body<float, 3>&);
template std::vector<std::array<double, 3>> present_positions<float, 3>(const Body<float, 3>&);

}  // namespace pliant::remeshed
