#include "engine/total_lagrangian/observe/field_views.hpp"

#include "engine/method/field_views.hpp"

namespace pliant::total_lagrangian {

namespace {

template <class T, int D>
auto has_mass(const Body<T, D>& body) {
  return [&body](std::int64_t slot) { return body.is_particle(slot); };
}

}  // namespace

template <class T, int D>
std::vector<SlotRun> slot_runs(const Body<T, D>& body) {
  return runs_of_particles<D>(body.layout, has_mass(body));
}

template <class T, int D>
std::vector<std::array<double, 3>> present_positions(const Body<T, D>& body) {
  return positions_of_particles<D>(body.layout, has_mass(body),
                                   [&body](std::int64_t slot, const Cell<D>& cell) {
                                     Point<D> x = body.place(slot, cell);
                                     for (int a = 0; a < D; ++a) x[a] += body.displacement[a][slot];
                                     return x;
                                   });
}

template std::vector<SlotRun> slot_runs<double, 2>(const Body<double, 2>&);
template std::vector<std::array<double, 3>> present_positions<double, 2>(const Body<double, 2>&);
template std::vector<SlotRun> slot_runs<double, 3>(const Body<double, 3>&);
template std::vector<std::array<double, 3>> present_positions<double, 3>(const Body<double, 3>&);
template std::vector<SlotRun> slot_runs<float, 2>(const Body<float, 2>&);
template std::vector<std::array<double, 3>> present_positions<float, 2>(const Body<float, 2>&);
template std::vector<SlotRun> slot_runs<float, 3>(const Body<float, 3>&);
template std::vector<std::array<double, 3>> present_positions<float, 3>(const Body<float, 3>&);

}  // namespace pliant::total_lagrangian
