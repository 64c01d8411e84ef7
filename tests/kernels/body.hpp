#pragma once

#include "tests/kernels/patch.hpp"

namespace pliant::kernels::test {

inline constexpr Model every_model[] = {Model::linear, Model::linear_logarithmic,
                                        Model::reduced_polynomial, Model::neo_hookean,
                                        Model::st_venant_kirchhoff};

/// A patch with a random but valid state: positions, velocity, density and stress vary between
/// particles by some per cent.
template <class T, int D>
struct Body {
  Body(std::array<int, D> cells, T spacing, Model model)
      : patch(cells, spacing), mass(patch.slots), states(4, State<T, D>(patch.slots)) {
    material.model = model;
    material.density = T(1.5);
    material.bulk_modulus = T(80);
    material.shear_modulus = T(30);
    material.order = 3;
    material.coefficient = {T(10), T(4), T(2), 0, 0};
    material.compressibility = T(0.025);
    State<T, D>& state = states[0];
    jitter(state.drift, T(0.1) * spacing, 1);
    jitter(state.velocity, T(0.5), 2);
    std::mt19937 random(3);
    std::uniform_real_distribution<T> small(T(-0.05), T(0.05));
    const T cell_volume = std::pow(spacing, T(D));
    for (std::int64_t s = 0; s < patch.slots; ++s) {
      mass[s] = material.density * cell_volume;
      state.volume[s] = cell_volume * (1 + small(random));
      const bool deformation = carries_deformation(model);
      for (int c = 0; c < material_components<D>; ++c) {
        const T unit = c % (D + 1) == 0 ? T(1) : T(0);
        state.material[c][s] = deformation ? unit + small(random) : 10 * small(random);
      }
      for (auto& field : state.stress) field[s] = 20 * small(random);
    }
    for (int n = 1; n < 4; ++n) states[n] = states[0];
  }

  /// The arguments of one stage from the current to the next state, by their indices in `states`.
  Stage<T, D> stage(int number, int current, int next, T time_step) {
    Stage<T, D> arguments{};
    arguments.segments = patch.segments.data();
    arguments.segment_count = static_cast<int>(patch.segments.size());
    arguments.spacing = patch.spacing;
    arguments.time_step = time_step;
    arguments.velocity_dissipation = velocity_dissipation;
    arguments.restoring_rate = restoring_rate;
    arguments.stress_dissipation = stress_dissipation;
    arguments.relaxes_shear = relaxes_shear;
    arguments.stage = number;
    arguments.kernel = kernel;
    arguments.gradient = gradient_kind;
    arguments.material = material;
    arguments.pack_state = patch.pack_state.data();
    arguments.interior = patch.interior.data();
    arguments.neighbours = neighbours;
    arguments.mass = mass.data();
    arguments.current = std::as_const(states[current]).evolving();
    arguments.stress = std::as_const(states[current]).stress_fields();
    arguments.start = states[0].evolving();
    arguments.second = std::as_const(states[1]).evolving();
    arguments.third = std::as_const(states[2]).evolving();
    arguments.next = states[next].evolving();
    // Two copies suffice for the drift.
    arguments.current.drift = std::as_const(states[number % 2]).evolving().drift;
    arguments.next.drift = states[(number + 1) % 2].evolving().drift;
    arguments.next_stress = states[next].stress_fields();
    return arguments;
  }

  /// One whole step, with constant velocity and stress of ghosts; returns the result of the last
  /// stage. states[0] is the new state.
  StageResult step(const RemeshedTable<T, D>& table, T time_step) {
    const StressOfState<T, D> stress = stress_of(0);
    table.evaluate_stress(stress);
    for (int n = 1; n < 4; ++n) {
      states[n].velocity = states[0].velocity;
      states[n].stress = states[0].stress;
    }
    StageResult result{};
    for (int number = 0; number < 4; ++number) {
      result = table.advance_stage(stage(number, number, (number + 1) % 4, time_step));
    }
    states[3].drift = states[1].drift;
    return result;
  }

  StressOfState<T, D> stress_of(int number) {
    return {patch.segments.data(),
            static_cast<int>(patch.segments.size()),
            material,
            patch.pack_state.data(),
            patch.interior.data(),
            mass.data(),
            std::as_const(states[number]).evolving(),
            states[number].stress_fields()};
  }

  Patch<T, D> patch;
  Material<T> material;
  Kernel kernel = Kernel::quartic_spline_fit;
  Gradient gradient_kind = Gradient::moment_matrix;
  T velocity_dissipation = T(0.7), stress_dissipation = T(0.3), restoring_rate = T(0.9);
  bool relaxes_shear = true;
  const NeighbourLists<D>* neighbours = nullptr;
  Field<T> mass;
  std::vector<State<T, D>> states;  ///< Q0, Q2, Q3, Q4 of (RP.21)
};

/// A box of at least 10 cells in every direction.
template <class T, int D>
std::array<int, D> small_box() {
  std::array<int, D> cells;
  cells.fill(10);
  cells[0] = 4 * slots_per_pack;
  return cells;
}

}  // namespace pliant::kernels::test
