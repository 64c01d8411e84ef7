#include "engine/remeshed/setup/footprint.hpp"

#include <algorithm>

#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/remeshed/remeshing/layout_search.hpp"
#include "engine/remeshed/state/field_store.hpp"

namespace pliant::remeshed {

namespace {

/// Values of a slot in the three copies of the state, the stress, and further arrays.
template <int D>
double values_of_slot(const BodyCase& body) {
  int state = 0;
  const int terms = static_cast<int>(body.prony.size());
  const int material = kernels::material_component_count<D>(body.material.model);
  for (const Declaration& f : state_fields) {
    state += f.copies * components<D>(f.rank, material, terms);
  }
  constexpr int stress = kernels::symmetric_components<D>;
  constexpr double interior = static_cast<double>(sizeof(kernels::Mark)) / sizeof(double);
  const int memory = terms > 0 ? terms + 1 : 0;  // filtered p_i, J - 1
  return state + stress + interior + (D == 3 ? 1 : 0) + memory;
}

/// Values of a slot in the copy of the state for outputs inside a step.
template <int D>
double values_of_copy(const BodyCase& body) {
  int state = 0;
  const int terms = static_cast<int>(body.prony.size());
  const int material = kernels::material_component_count<D>(body.material.model);
  for (const Declaration& f : state_fields) {
    if (is_evolving(f)) state += components<D>(f.rank, material);
  }
  return state + terms + kernels::symmetric_components<D>;
}

bool case_has_walls(const Case& a_case) {
  return std::ranges::any_of(a_case.boundaries, [](const BoundaryCase& boundary) {
    return row_of(boundary.kind).is_wall;
  });
}

template <int D>
Footprint footprint_in(const Case& a_case, const BodyCase& body) {
  const bool looks = a_case.output.every > 0 || a_case.output.measure_every > 0;
  const double copy = looks ? values_of_copy<D>(body) : 0;
  Footprint footprint;
  footprint.reach = layout_reach(case_has_walls(a_case));
  footprint.bytes_per_slot = sizeof(double) * (values_of_slot<D>(body) + copy + 1);
  footprint.bytes_per_ghost = D == 2 ? 2500 : 1300;
  footprint.bytes_per_particle = D == 2 ? 180 : 320;
  return footprint;
}

}  // namespace

Footprint footprint(const Case& a_case, const BodyCase& body) {
  return a_case.dimension == 2 ? footprint_in<2>(a_case, body) : footprint_in<3>(a_case, body);
}

}  // namespace pliant::remeshed
