#include "kernels/remeshed/stage/bulk_viscosity.hpp"

#include <cmath>

#include "kernels/energy.hpp"
#include "kernels/remeshed/stage/relaxation.hpp"
#include "tests/kernels/body.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

constexpr PronyTerm<double> term = {0.3, 2};
constexpr double bulk_modulus = 50;  // K0

double after(double interval, double pressure, double start, double end) {
  const Relaxation<double> r = relaxation(term, bulk_modulus, interval);
  return r.decay * pressure + r.start * start + r.end * end;
}

// The solution of p + tau dp/dt = g K0 (J0 + r t) is g K0 (J0 + r (t - tau)) + c exp(-t/tau).
TEST(prony_term, is_exact_while_the_volume_changes_evenly) {
  const double start = 0.02, rate = -0.01, pressure = 0.4;
  for (const double a : {1e-9, 1e-3, 0.1, 1., 10., 1e6}) {
    const double t = a * term.time;
    const auto driven = [&](double s) {
      return term.ratio * bulk_modulus * (start + rate * (s - term.time));
    };
    const double exact = driven(t) + (pressure - driven(0)) * std::exp(-a);
    // Rounding of 1 - exp(-a), which small intervals amplify by 1/a.
    EXPECT_NEAR(after(t, pressure, start, start + rate * t), exact, 1e-12 * (1 + std::abs(exact)))
        << a;
  }
}

/// Error of p at t = 1 for J - 1 = sin(w t).
double error_of_an_oscillation(int steps) {
  const double w = 3, end = 1, dt = end / steps;
  double p = 0;
  for (int n = 0; n < steps; ++n)
    p = after(dt, p, std::sin(w * n * dt), std::sin(w * (n + 1) * dt));
  const double phase = w * term.time;
  const double exact =
      term.ratio * bulk_modulus / (1 + phase * phase) *
      (std::sin(w * end) - phase * std::cos(w * end) + phase * std::exp(-end / term.time));
  return p - exact;
}

TEST(prony_term, converges_at_second_order_where_the_volume_oscillates) {
  EXPECT_NEAR(error_of_an_oscillation(50) / error_of_an_oscillation(100), 4, 0.01);
}

/// A box whose particles have F = 0.95 I, the same velocity, and individual p_i.
template <class T, int D>
struct RelaxingBox : Body<T, D> {
  static constexpr int terms = 3;
  std::array<PronyTerm<T>, terms> prony = {{{T(0.1), T(0.01)}, {T(0.2), T(1)}, {T(0.3), T(100)}}};
  std::array<std::vector<T>, terms> kept;
  std::vector<T> change;
  std::array<T*, terms> kept_view;
  std::array<Relaxation<T>, terms> relaxation;

  RelaxingBox() : Body<T, D>(small_box<T, D>(), T(0.1), Model::reduced_polynomial) {
    State<T, D>& state = this->states[0];
    for (int c = 0; c < material_components<D>; ++c) {
      std::fill(state.material[c].begin(), state.material[c].end(),
                c % (D + 1) == 0 ? T(0.95) : T(0));
    }
    for (auto& u : state.velocity) std::fill(u.begin(), u.end(), T(0.3));
    for (int i = 0; i < terms; ++i) {
      kept[i].assign(this->patch.slots, 0);
      kept_view[i] = kept[i].data();
    }
    change.assign(this->patch.slots, 0);
    for (int n = 1; n < 4; ++n) this->states[n] = state;
  }

  T volume_change() const { return std::pow(T(0.95), T(D)) - 1; }

  void relax(T dt) {
    StressOfState<T, D> stress = this->stress_of(0);
    stress.viscosity = {terms, nullptr, kept_view.data()};
    baseline_table<T, D>().evaluate_stress(stress);
    fill_ghosts(0);
    constexpr double reached[] = {0.5, 0.5, 1, 1};
    for (int number = 0; number < 4; ++number) {
      for (int i = 0; i < terms; ++i) {
        relaxation[i] =
            kernels::relaxation(prony[i], this->material.bulk_modulus, reached[number] * dt);
      }
      Stage<T, D> stage = this->stage(number, number, (number + 1) % 4, dt);
      stage.viscosity = {terms, relaxation.data(), kept_view.data(), change.data()};
      // Its force would pull irregular particles back to the lattice.
      stage.velocity_dissipation = 0;
      baseline_table<T, D>().advance_stage(stage);
      fill_ghosts((number + 1) % 4);
    }
  }

  /// Around a uniform body ghosts have its stress.
  void fill_ghosts(int number) {
    std::int64_t some = 0;
    this->patch.for_each_interior([&](std::int64_t p, const auto&) { some = p; });
    for (auto& stress : this->states[number].stress) {
      const T value = stress[some];
      for (std::int64_t p = 0; p < this->patch.slots; ++p) {
        if (this->patch.interior[p] == 0) stress[p] = value;
      }
    }
  }
};

template <class T>
class bulk_viscosity : public testing::Test {};
TYPED_TEST_SUITE(bulk_viscosity, Dimensions);

// Steps much smaller and much larger than the relaxation times.
TYPED_TEST(bulk_viscosity, pressure_after_a_step_follows_the_closed_form_in_steps_of_any_length) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (const T dt : {T(1e-3), T(0.5), T(40)}) {
    RelaxingBox<T, D> box;
    const T modulus = box.material.bulk_modulus;
    T t = 0;
    for (int step = 0; step < 5; ++step, t += dt) box.relax(dt);
    T relaxed = 0;
    for (const auto& [ratio, time] : box.prony) {
      relaxed += ratio * modulus * box.volume_change() * (1 - std::exp(-t / time));
    }
    box.patch.for_each_interior([&](std::int64_t p, const auto&) {
      T sum = 0;
      for (const auto& field : box.kept) sum += field[p];
      ASSERT_NEAR(sum, relaxed, 1e3 * std::numeric_limits<T>::epsilon() * modulus);
      // With equal stretches F has no deviator.
      if constexpr (D == 3) {
        ASSERT_NEAR(box.states[0].stress[0][p], modulus * box.volume_change() - relaxed,
                    1e3 * std::numeric_limits<T>::epsilon() * modulus);
      }
    });
  }
}

TYPED_TEST(bulk_viscosity, changes_the_diagonal_of_the_stress_only_and_alike) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  RelaxingBox<T, D> box;
  box.relax(T(0.5));
  const auto relaxed = box.states[0].stress;
  baseline_table<T, D>().evaluate_stress(box.stress_of(0));
  box.patch.for_each_interior([&](std::int64_t p, const auto&) {
    T sum = 0;
    for (const auto& field : box.kept) sum += field[p];
    for (int i = 0; i < D; ++i) {
      for (int j = i; j < D; ++j) {
        const int c = symmetric_index<D>(i, j);
        ASSERT_NEAR(box.states[0].stress[c][p] - relaxed[c][p], i == j ? sum : T(0),
                    1e3 * std::numeric_limits<T>::epsilon() * box.material.bulk_modulus);
      }
    }
  });
}

// With J held, the slope of the energy is the pressure; after relaxation, the long-term modulus
// remains.
TEST(prony_term, energy_belongs_to_the_pressure) {
  const double j = 0.9, step = 1e-6, pressure = 0.7;
  const auto energy = [&](double volume_change, double p) {
    return bulk_modulus / 2 * volume_change * volume_change +
           relaxed_energy(term, bulk_modulus, p, volume_change);
  };
  const double slope =
      (energy(j - 1 + step, pressure) - energy(j - 1 - step, pressure)) / (2 * step);
  EXPECT_NEAR(-slope, -bulk_modulus * (j - 1) + pressure, 1e-7);
  EXPECT_NEAR(energy(j - 1, term.ratio * bulk_modulus * (j - 1)),
              (1 - term.ratio) * bulk_modulus / 2 * (j - 1) * (j - 1), 1e-14);
}

}  // namespace
}  // namespace pliant::kernels::test
