#include "kernels/remeshed/stage/gradient_sweep.hpp"

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

/// A linear field, its particles' positions, and the largest error of its gradient.
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

}  // namespace
}  // namespace pliant::kernels::test
