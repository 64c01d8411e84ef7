#include "kernels/remeshed/stage/gradient_sweep.hpp"

#include <cmath>
#include <functional>

#include "tests/kernels/patch.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

/// Sums over the lattice neighbours of the pack at `slot`.
template <Kernel kernel, template <class, int, int> class Sums, class P, int D, int F>
[[gnu::always_inline]] inline void sweep_stencil(const SweepFields<Scalar<P>, D, F>& fields,
                                                 const std::int64_t* neighbour_row,
                                                 std::int64_t slot, Scalar<P> spacing,
                                                 Sums<P, D, F>& sums) {
  const Separation<kernel, P, D> separation(fields.drift, slot, spacing);
  const Differences<P, F> differences(fields.field, slot);
  visit_stencil<kernel, P, D>(
      neighbour_row,
      slot, [&](const P(&offset)[D], const auto& neighbour) __attribute__((always_inline)) {
        P d[D], weighted[D], difference[F];
        separation(offset, neighbour, d, weighted);
        differences(neighbour, difference);
        sums.add(weighted, d, difference);
      });
}

/// Sums over the listed neighbours of the register of particles at `slot`.
template <Kernel kernel, template <class, int, int> class Sums, class P, int D, int F>
[[gnu::always_inline]] inline void sweep_list(const SweepFields<Scalar<P>, D, F>& fields,
                                              const NeighbourLists<D>& lists, std::int64_t slot,
                                              Scalar<P> spacing, Sums<P, D, F>& sums) {
  const Separation<kernel, P, D> separation(fields.drift, slot, spacing);
  const Differences<P, F> differences(fields.field, slot);
  visit_list<P, D>(
      lists, slot, [&](const P(&offset)[D], const auto& neighbour) __attribute__((always_inline)) {
        P d[D], weighted[D], difference[F];
        separation(offset, neighbour, d, weighted);
        differences(neighbour, difference);
        sums.add(weighted, d, difference);
      });
}

/// A linear field, the positions of its particles, and the largest error of its gradient.
template <class T, int D>
class LinearField {
  using P = xsimd::batch<T, xsimd::sse2>;

 public:
  LinearField() : patch_(cells(), T(0.05)), state_(patch_.slots), field_(patch_.slots, T(0)) {
    jitter(state_.drift, T(0.15) * patch_.spacing);
    patch_.for_each([&](std::int64_t s, const auto& cell) {
      const auto x = patch_.node(cell);
      double value = 0;
      for (int i = 0; i < D; ++i) value += slope[i] * (x[i] + state_.drift[i][s]);
      field_[s] = static_cast<T>(value);
    });
  }

  template <Kernel kernel>
  double stencil_error() {
    return error([&](const auto& fields, const Segment<D>& segment, std::int64_t slot) {
      GradientSums<P, D, 1> sums;
      sweep_stencil<kernel>(fields, segment.neighbour_row.data(), slot, patch_.spacing, sums);
      return sums;
    });
  }

  template <Kernel kernel>
  double list_error(int reach) {
    const BoxLists<D> lists(patch_, reach);
    const NeighbourLists<D> view = lists.view();
    return error([&](const auto& fields, const Segment<D>&, std::int64_t slot) {
      GradientSums<P, D, 1> sums;
      sweep_list<kernel>(fields, view, slot, patch_.spacing, sums);
      return sums;
    });
  }

 private:
  static constexpr double slope[3] = {1, -0.5, 0.25};

  static std::array<int, D> cells() {
    std::array<int, D> n;
    n.fill(10);
    n[0] = 2 * Patch<T, D>::pack;
    return n;
  }

  template <class Sweep>
  double error(const Sweep& sweep) {
    SweepFields<T, D, 1> fields;
    for (int i = 0; i < D; ++i) fields.drift[i] = state_.drift[i].data();
    fields.field[0] = field_.data();
    double worst = 0;
    for (const Segment<D>& segment : patch_.segments) {
      for (std::int64_t s = segment.first; s < segment.first + segment.count; s += lanes<P>) {
        if (!holds_interior(patch_.pack_state[s / patch_.pack])) continue;
        P gradient[1][D];
        solve(sweep(fields, segment, s), gradient);
        for (int l = 0; l < lanes<P>; ++l) {
          if (patch_.interior[s + l] == 0) continue;
          for (int i = 0; i < D; ++i) {
            worst = std::max(worst, std::abs(double(gradient[0][i].get(l)) - slope[i]));
          }
        }
      }
    }
    return worst;
  }

  Patch<T, D> patch_;
  State<T, D> state_;
  Field<T> field_;
};

template <class T>
class gradient_sweep : public testing::Test {};
TYPED_TEST_SUITE(gradient_sweep, Dimensions);

TYPED_TEST(gradient_sweep, linear_fields_are_reproduced_exactly_over_the_stencil) {
  LinearField<typename TypeParam::Scalar, TypeParam::dimension> field;
  const double tolerance = exact<typename TypeParam::Scalar>;
  EXPECT_LT(field.template stencil_error<Kernel::quartic_spline>(), tolerance);
  EXPECT_LT(field.template stencil_error<Kernel::quartic_spline_fit>(), tolerance);
  EXPECT_LT(field.template stencil_error<Kernel::compact>(), tolerance);
  EXPECT_LT(field.template stencil_error<Kernel::fourth_order>(), tolerance);
}

TYPED_TEST(gradient_sweep, linear_fields_are_reproduced_exactly_over_lists) {
  LinearField<typename TypeParam::Scalar, TypeParam::dimension> field;
  const double tolerance = exact<typename TypeParam::Scalar>;
  EXPECT_LT(field.template list_error<Kernel::quartic_spline>(3), tolerance);
  EXPECT_LT(field.template list_error<Kernel::quartic_spline_fit>(3), tolerance);
  EXPECT_LT(field.template list_error<Kernel::compact>(2), tolerance);
}

/// The gradient of H&K (RP.19) of a field f(x), over particles displaced from their nodes by up to
/// `disorder` cells, whose volumes differ by up to `unevenness`.
template <int D>
class PaperGradient {
  using P = xsimd::batch<double, xsimd::sse2>;

 public:
  using Place = std::array<double, D>;

  PaperGradient(double spacing, double disorder, double unevenness)
      : patch_(cells(), spacing), state_(patch_.slots) {
    jitter(state_.drift, disorder * spacing);
    std::array<Field<double>, 1> excess = {Field<double>(patch_.slots)};
    jitter(excess, unevenness, 2);
    for (std::int64_t s = 0; s < patch_.slots; ++s) state_.volume[s] = 1 + excess[0][s];
  }

  /// Largest error of df/dx_axis, compared with `exact`.
  template <class F, class Derivative>
  double error(F&& f, int axis, Derivative&& exact) const {
    const Field<double> field = sampled(f);
    double worst = 0;
    patch_.for_each_interior([&](std::int64_t s, const auto& cell) {
      worst = std::max(worst, std::abs(at(field, s)[axis] - exact(place(s, cell))));
    });
    return worst;
  }

  /// sum_p v_p grad f over the interior, for f that is 0 outside: the total force of a stress f.
  Place total(const std::function<double(const Place&)>& f) const {
    const Field<double> field = sampled(f);
    Place sum = {};
    patch_.for_each_interior([&](std::int64_t s, const auto&) {
      const Place gradient = at(field, s);
      for (int i = 0; i < D; ++i) sum[i] += state_.volume[s] * gradient[i];
    });
    return sum;
  }

 private:
  static std::array<int, D> cells() {
    std::array<int, D> n;
    n.fill(2 * Patch<double, D>::pack);
    return n;
  }

  Place place(std::int64_t s, const std::array<std::int32_t, D>& cell) const {
    Place x = patch_.node(cell);
    for (int i = 0; i < D; ++i) x[i] += state_.drift[i][s];
    return x;
  }

  template <class F>
  Field<double> sampled(F&& f) const {
    Field<double> field(patch_.slots, 0);
    patch_.for_each([&](std::int64_t s, const auto& cell) { field[s] = f(place(s, cell)); });
    return field;
  }

  Place at(const Field<double>& field, std::int64_t s) const {
    const std::int64_t slot = s / lanes<P> * lanes<P>;
    const Segment<D>* segment = patch_.segments.data();
    while (s >= segment->first + segment->count) ++segment;
    SweepFields<double, D, 1> fields;
    for (int i = 0; i < D; ++i) fields.drift[i] = state_.drift[i].data();
    fields.field[0] = field.data();
    const Separation<Kernel::quartic_spline, P, D> separation(fields.drift, slot, patch_.spacing);
    const VolumeWeight<Gradient::normalised, P, D> times_volume(state_.volume.data());
    const Differences<P, 1> differences(fields.field, slot);
    GradientSums<P, D, 1> sums;
    visit_stencil<Kernel::quartic_spline, P, D>(segment->neighbour_row.data(), slot,
                                                [&](const P(&offset)[D], const auto& neighbour) {
                                                  P d[D], weighted[D], difference[1];
                                                  separation(offset, neighbour, d, weighted);
                                                  times_volume(neighbour, weighted);
                                                  differences(neighbour, difference);
                                                  sums.add(weighted, d, difference);
                                                });
    P gradient[1][D];
    solve<Gradient::normalised>(sums, gradient);
    Place result;
    for (int i = 0; i < D; ++i) result[i] = gradient[0][i].get(s - slot);
    return result;
  }

  Patch<double, D> patch_;
  State<double, D> state_;
};

template <class T>
class paper_gradient : public testing::Test {};
using PaperDimensions =
    testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(paper_gradient, PaperDimensions);

constexpr auto one = [](const auto&) { return 1.; };
constexpr auto none = [](const auto&) { return 0.; };

TYPED_TEST(paper_gradient, of_a_constant_is_zero_on_any_particles) {
  const PaperGradient<TypeParam::value> gradient(0.1, 0.2, 0.3);
  for (int axis = 0; axis < TypeParam::value; ++axis) EXPECT_EQ(gradient.error(one, axis, none), 0);
}

TYPED_TEST(paper_gradient, of_a_coordinate_is_one_along_it_on_any_particles) {
  constexpr int D = TypeParam::value;
  const PaperGradient<D> gradient(0.1, 0.2, 0.3);
  for (int axis = 0; axis < D; ++axis) {
    EXPECT_LT(gradient.error([axis](const auto& x) { return x[axis]; }, axis, one), exact<double>);
  }
}

// 1/n_p is a sum for each axis: the error from asymmetric neighbours remains and does not decrease
// with the spacing. The moment matrix removes it.
TYPED_TEST(paper_gradient, of_a_coordinate_across_it_vanishes_on_the_lattice_alone) {
  constexpr int D = TypeParam::value;
  const auto across = [](double spacing, double disorder, double unevenness) {
    return PaperGradient<D>(spacing, disorder, unevenness)
        .error([](const auto& x) { return x[1]; }, 0, none);
  };
  EXPECT_LT(across(0.1, 0, 0), exact<double>);
  const double coarse = across(0.1, 0.15, 0);
  EXPECT_GT(coarse, 0.02);
  EXPECT_NEAR(across(0.025, 0.15, 0) / coarse, 1, 1e-6);
  EXPECT_GT(across(0.1, 0, 0.15), 0.01) << "volumes count as places do";
}

// The third derivative of this field is 1 everywhere: all particles have the same error.
TYPED_TEST(paper_gradient, is_of_second_order_on_the_lattice) {
  constexpr int D = TypeParam::value;
  const auto error = [](double spacing) {
    return PaperGradient<D>(spacing, 0, 0)
        .error([](const auto& x) { return x[0] * x[0] * x[0] / 6; }, 0,
               [](const auto& x) { return x[0] * x[0] / 2; });
  };
  EXPECT_GT(error(0.1), 1e-3);
  EXPECT_NEAR(std::log2(error(0.1) / error(0.05)), 2, 1e-6);
}

// Both particles of a pair get v_p v_q omega d (f_q - f_p), which is not equal and opposite: these
// forces cancel if sum_q v_q omega d = 0, as on the lattice.
TYPED_TEST(paper_gradient, conserves_momentum_on_the_lattice_alone) {
  constexpr int D = TypeParam::value;
  const auto bump = [](const std::array<double, D>& x) {
    double square = 0;
    for (int i = 0; i < D; ++i) square += std::pow(x[i] - 0.8, 2);
    return std::pow(std::max(0., 1 - square / 0.04), 2);
  };
  const auto total = [&](double disorder) {
    double square = 0;
    for (const double t : PaperGradient<D>(0.1, disorder, 0).total(bump)) square += t * t;
    return std::sqrt(square);
  };
  EXPECT_LT(total(0), exact<double>);
  EXPECT_GT(total(0.15), 1e-3);
}

}  // namespace
}  // namespace pliant::kernels::test
