#include "engine/remeshed/ghosts/ghost_fill.hpp"

#include <algorithm>
#include <cmath>

#include "engine/remeshed/contact/contact_edges.hpp"
#include "engine/remeshed/ghosts/fit_coefficient.hpp"
#include "engine/remeshed/ghosts/fit_evaluator.hpp"
#include "engine/remeshed/ghosts/lasting_correction.hpp"
#include "engine/remeshed/ghosts/present_foot.hpp"
#include "engine/remeshed/ghosts/record_loads.hpp"
#include "engine/remeshed/ghosts/rigid_velocity.hpp"
#include "engine/remeshed/ghosts/rim_ghosts.hpp"
#include "engine/remeshed/ghosts/wall_site.hpp"
#include "kernels/remeshed/ghosts/wall_friction.hpp"

namespace pliant::remeshed {

namespace {

/// The part of the outgoing characteristic in the velocity of a free surface, (RP.83). With all of
/// it, clamped plates gain energy. In 3D, and with materials that carry F, ghosts instead drop its
/// lasting part, (RP.50). Bodies without walls are remeshed before anything grows.
template <class T, int D>
T share_of_characteristic(const Body<T, D>& body, const Boundaries<D>& boundaries) {
  return removes_lasting_correction(body, boundaries) || !boundaries.have_attached_walls()
             ? T(1)
             : T(0.42);
}

/// Computes the first `count` ghosts of a block from their fits to the present records.
template <class T, int D>
struct GhostFill {
  const Body<T, D>& body;
  BlockGhosts<T, D>& ghosts;
  std::size_t count;
  int stage;
  FieldStore<T, D>& state;
  std::array<T*, kernels::symmetric_components<D>> stress;
  const kernels::RemeshedTable<T, D>& table;
  T share;  ///< share of the outgoing characteristic

  void fill_surfaces(const BoundaryValues<D>& values) const {
    const kernels::Impedance<T> impedance = surface_impedance();
    kernels::FreeSurfaceGhosts<T, D> work = {};
    work.lists = ghosts.sums(0, count, body, nullptr);
    work.constrained_sum = ghosts.constrained_sum.data();
    work.surface_sum = ghosts.surface_sum.data();
    work.slot = ghosts.slot.data();
    work.wall = ghosts.wall.data();
    work.active = ghosts.active.data();
    work.pressure = ghosts.pressure.data();
    work.pressures = values.pressure.data();
    work.pressure_impedance = impedance.pressure_wave;
    work.shear_impedance = impedance.shear_wave;
    for (int a = 0; a < D; ++a) work.velocity[a] = state.get(Field::velocity, a);
    work.stress = stress;
    work.correction = ghosts.correction.empty() ? nullptr : ghosts.correction.front().data();
    table.fill_free_surfaces(work);
  }

  void average_surfaces(const BoundaryValues<D>& values) const {
    FitEvaluator<T, D> fits(body, ghosts, table);
    for (std::size_t g = 0; g < count; ++g) {
      if (ghosts.wall[g] >= 0) continue;
      const int p = ghosts.pressure[g];
      const kernels::GhostFits<T, D> of_ghost = fits.of(g);
      const T pressure = p == several_loads ? -load_on_ghost<T, D>(body, ghosts, of_ghost, g,
                                                                   LoadPlace<T, D>(foot(g)), values)
                                                   .normal
                         : p < 0 ? T(0)
                                 : static_cast<T>(values.pressure_at(p, foot(g)));
      set(g, kernels::averaged_surface_ghost<T, D>(of_ghost.linear, pressure));
    }
  }

  // Those that are no uniform pressure.
  void fill_loads(const Surroundings<D>& around) const {
    const Boundaries<D>& boundaries = around.boundaries;
    const bool are_by_place = boundaries.have_loads_by_place();
    const kernels::Impedance<T> impedance = surface_impedance();
    FitEvaluator<T, D> present(body, ghosts, table);
    for (std::size_t g = 0; g < count; ++g) {
      const int p = ghosts.pressure[g];
      if (p == no_load || (p >= 0 && boundaries.is_uniform_pressure(p))) continue;
      const kernels::GhostFits<T, D> fits = present.of(g);
      const auto at_foot =
          load_on_ghost<T, D>(body, ghosts, fits, g, LoadPlace<T, D>(foot(g)), around.values);
      if (!are_by_place) {
        fill_loaded(g, fits, at_foot, at_foot, impedance);
        continue;
      }
      const LoadPlace<T, D> place(body, ghosts, g, fits, foot(g));
      fill_loaded(g, fits, load_on_ghost(body, ghosts, fits, g, place, around.values), at_foot,
                  impedance);
    }
  }

  void fill_beside_edges(const Surroundings<D>& around) const {
    const kernels::Impedance<T> impedance(body.material);
    FitEvaluator<T, D> present(body, ghosts, table);
    for (std::size_t g = 0; g < count; ++g) {
      const std::int32_t edge = ghosts.edge[g];
      if (ghosts.wall[g] >= 0 || edge == no_edge) continue;
      if (body.population.kind[edge] != Kind::wall_ghost) continue;
      const auto load = load_beside_edge<T, D>(body, ghosts, g, foot(g), around.values);
      fill_loaded(g, present.of(g), load, load, impedance);
    }
  }

  void turn_rigidly() const {
    for (std::size_t g = 0; g < count; ++g) {
      if (ghosts.wall[g] >= 0 || ghosts.active[g] == 0) continue;
      const auto u = rigid_velocity<T, D>(body, stage, ghosts, g);
      for (int a = 0; a < D; ++a) state.get(Field::velocity, a)[ghosts.slot[g]] = u[a];
      ghosts.correction[g] = {};
    }
  }

  void fill_in_contact() const {
    const kernels::Impedance<T> impedance(body.material);
    FitEvaluator<T, D> present(body, ghosts, table);
    for (std::size_t k = 0; k < ghosts.contact_points.ghost.size(); ++k) {
      const std::size_t g = ghosts.contact_points.ghost[k];
      if (g >= count) continue;
      const kernels::GhostFits<T, D> fits = present.of(g);
      const auto load = load_of(fits, ghosts.contact_points.traction[k]);
      fill_loaded(g, fits, load, load, impedance);
    }
  }

  void fill_walls(const Surroundings<D>& around, bool averaged, WallWork<T, D>* work) const {
    const bool alone = removes_lasting_correction(body, around.boundaries);
    const kernels::Impedance<T> impedance(body.material);
    FitEvaluator<T, D> present(body, ghosts, table);
    for (std::size_t g = 0; g < count; ++g) {
      if (ghosts.wall[g] < 0 || ghosts.active[g] == 0) continue;
      const kernels::GhostFits<T, D> fits = present.of(g);
      const kernels::WallSite<T, D> site = wall_site<T, D>(body, ghosts, g, around);
      if (work != nullptr) work->add(g, fits, site);
      if (averaged) {
        set(g, kernels::averaged_wall_ghost<T, D>(fits.linear, site.velocity));
        continue;
      }
      auto ghost = kernels::friction_wall_ghost<T, D>(fits, site, impedance);
      if (alone) let_shear_waves_out_alone(g, fits, site, impedance, ghost);
      set(g, ghost);
    }
  }

 private:
  Point<D> foot(std::size_t g) const { return present_foot(body, ghosts, g, stage); }

  /// Adds the velocity of outgoing shear waves without its lasting part, (RP.95).
  void let_shear_waves_out_alone(std::size_t g, const kernels::GhostFits<T, D>& fits,
                                 const kernels::WallSite<T, D>& site,
                                 const kernels::Impedance<T>& impedance,
                                 kernels::GhostState<T, D>& ghost) const {
    const bool slides = kernels::slides_along<T, D>(fits, site, impedance);
    T jump = 0;  // jump of the normal velocity, which (RP.46) sets
    for (int a = 0; a < D; ++a) jump += site.n[a] * (ghost.velocity[a] - fits.surface.velocity(a));
    for (int a = 0; a < D; ++a) {
      const T outgoing =
          slides ? ghost.velocity[a] - fits.surface.velocity(a) - jump * site.n[a] : T(0);
      ghosts.correction[g][a] = outgoing - ghosts.lasting[g][a];
      if (slides) ghost.velocity[a] -= ghosts.lasting[g][a];
    }
  }

  /// (RP.50) divides by this impedance.
  kernels::Impedance<T> surface_impedance() const {
    const kernels::Impedance<T> of_material(body.material);
    return {of_material.pressure_wave / share, of_material.shear_wave / share};
  }

  static kernels::SurfaceLoad<T, D> load_of(const kernels::GhostFits<T, D>& fits,
                                            const std::array<T, D>& traction) {
    const auto n = kernels::unit_normal<T, D>(fits.linear);
    kernels::SurfaceLoad<T, D> load{n, 0, traction};
    for (int a = 0; a < D; ++a) load.normal += load.shear[a] * n[a];
    for (int a = 0; a < D; ++a) load.shear[a] -= load.normal * n[a];
    return load;
  }

  void fill_loaded(std::size_t g, const kernels::GhostFits<T, D>& fits,
                   const kernels::SurfaceLoad<T, D>& load,
                   const kernels::SurfaceLoad<T, D>& at_foot,
                   const kernels::Impedance<T>& impedance) const {
    const auto ghost = kernels::loaded_surface_ghost<T, D>(fits, load, at_foot, impedance);
    set(g, ghost);
    for (int a = 0; a < D; ++a) {
      ghosts.correction[g][a] = ghost.velocity[a] - fits.linear.velocity(a);
    }
  }

  // If a slot has two ghosts, only one of them is active.
  void set(std::size_t g, const kernels::GhostState<T, D>& ghost) const {
    if (ghosts.active[g] == 0) return;
    const std::int64_t slot = ghosts.slot[g];
    for (int a = 0; a < D; ++a) state.get(Field::velocity, a)[slot] = ghost.velocity[a];
    for (std::size_t c = 0; c < ghost.stress.size(); ++c) stress[c][slot] = ghost.stress[c];
  }
};

}  // namespace

template <class T, int D>
void fill_ghosts(Body<T, D>& body, int block, int stage, int parity, WhichGhosts which,
                 const Surroundings<D>& around, GhostTreatment treatment,
                 const kernels::RemeshedTable<T, D>& table, WallWork<T, D>* work) {
  const BoundaryValues<D>& values = around.values;
  follow_edges(body, block);
  BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  const std::size_t count = which == WhichGhosts::all ? ghosts.slot.size() : ghosts.reached_count;
  const GhostFill<T, D> fill{body,
                             ghosts,
                             count,
                             stage,
                             body.stage[buffer_of(stage)],
                             body.stress_view(parity),
                             table,
                             share_of_characteristic(body, around.boundaries)};
  if (treatment == GhostTreatment::averaged) {
    fill.average_surfaces(values);
  } else {
    fill.fill_surfaces(values);
    fill.fill_loads(around);
    fill.fill_beside_edges(around);
    fill.fill_in_contact();
    if (removes_lasting_correction(body, around.boundaries))
      remove_lasting_correction(ghosts, count, fill.state);
    if (treatment == GhostTreatment::linear) {
      fill_rim_ghosts(body, ghosts, count, around, fill.state);
    } else {
      fill.turn_rigidly();
    }
  }
  fill.fill_walls(around, treatment == GhostTreatment::averaged, work);
}

template <class T, int D>
void fill_conserved(Body<T, D>& body, int block) {
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  const std::vector<std::int32_t>& slot_of_record = body.population.slot_of_record;
  FieldStore<T, D>& state = body.stage[0];
  const T volume = static_cast<T>(std::pow(body.lattice.spacing, D));
  T* mass = state.get(Field::mass);
  T* v = state.get(Field::volume);
  thread_local std::vector<T*> fields;
  thread_local std::vector<T> sums;
  fields.clear();
  for (const Field f : {Field::material, Field::memory_pressure}) {
    for (Buffer<T>& component : state[f]) fields.push_back(component.get());
  }
  std::array<T*, D> carried, drift;
  for (int a = 0; a < D; ++a) {
    carried[a] = state.get(Field::displacement, a);
    drift[a] = state.get(Field::drift, a);
  }
  for (std::size_t g = 0; g < ghosts.slot.size(); ++g) {
    if (ghosts.active[g] == 0) continue;
    T density = 0;
    std::array<T, D> displacement = {};
    sums.assign(fields.size(), T(0));
    for (std::int64_t k = ghosts.begin[g]; k < ghosts.begin[g + 1]; ++k) {
      const T c = fit_coefficient<T, D>(ghosts, g, k, ghosts.terms[g].linear);
      const std::int64_t q = slot_of_record[kernels::record_of(ghosts.pairs[k])];
      density += c * (mass[q] / v[q]);
      for (int a = 0; a < D; ++a) displacement[a] += c * (carried[a][q] + drift[a][q]);
      for (std::size_t f = 0; f < fields.size(); ++f) sums[f] += c * fields[f][q];
    }
    const std::int64_t slot = ghosts.slot[g];
    mass[slot] = volume * density;
    v[slot] = volume;
    for (int a = 0; a < D; ++a) carried[a][slot] = displacement[a] - drift[a][slot];
    for (std::size_t f = 0; f < fields.size(); ++f) fields[f][slot] = sums[f];
  }
}

template void fill_ghosts<double, 2>(Body<double, 2>&, int, int, int, WhichGhosts,
                                     const Surroundings<2>&, GhostTreatment,
                                     const kernels::RemeshedTable<double, 2>&,
                                     WallWork<double, 2>*);
template void fill_conserved<double, 2>(Body<double, 2>&, int);
template void fill_ghosts<float, 2>(Body<float, 2>&, int, int, int, WhichGhosts,
                                    const Surroundings<2>&, GhostTreatment,
                                    const kernels::RemeshedTable<float, 2>&, WallWork<float, 2>*);
template void fill_conserved<float, 2>(Body<float, 2>&, int);
template void fill_ghosts<double, 3>(Body<double, 3>&, int, int, int, WhichGhosts,
                                     const Surroundings<3>&, GhostTreatment,
                                     const kernels::RemeshedTable<double, 3>&,
                                     WallWork<double, 3>*);
template void fill_conserved<double, 3>(Body<double, 3>&, int);
template void fill_ghosts<float, 3>(Body<float, 3>&, int, int, int, WhichGhosts,
                                    const Surroundings<3>&, GhostTreatment,
                                    const kernels::RemeshedTable<float, 3>&, WallWork<float, 3>*);
template void fill_conserved<float, 3>(Body<float, 3>&, int);

}  // namespace pliant::remeshed
