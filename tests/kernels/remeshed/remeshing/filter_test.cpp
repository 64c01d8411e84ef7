#include <cmath>
#include <functional>

#include "kernels/remeshed/stage/fourth_difference.hpp"
#include "tests/kernels/patch.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

template <class T, int D>
struct FilteredPatch {
  static constexpr T strength = T(0.3);

  explicit FilteredPatch(const std::function<double(const std::array<int, D>&)>& value)
      : patch(cells(), T(1)),
        inside(patch.interior.begin(), patch.interior.end()),
        field(patch.slots, 0),
        result(patch.slots, 0) {
    patch.for_each([&](std::int64_t p, const auto& cell) { field[p] = T(value(cell)); });
  }

  void filter() {
    baseline_table<T, D>().filter({patch.segments.data(), static_cast<int>(patch.segments.size()),
                                   strength, inside.data(), field.data(), result.data()});
  }

  /// Calls f for interior cells all of whose four neighbours along every axis are interior too.
  template <class F>
  void for_each_inner(F&& f) {
    patch.for_each([&](std::int64_t p, const std::array<int, D>& cell) {
      bool inner = true;
      for (int i = 0; i < D; ++i) {
        inner = inner && cell[i] >= patch.margin + 2 && cell[i] < cells()[i] - patch.margin - 2;
      }
      if (inner) f(p, cell);
    });
  }

  std::int64_t hole() const {
    std::array<int, D> cell;
    cell.fill(6);
    return patch.slot(cell);
  }

  static std::array<int, D> cells() {
    std::array<int, D> n;
    n.fill(13);
    n[0] = 2 * slots_per_pack;
    return n;
  }

  Patch<T, D> patch;
  Field<T> inside, field, result;
};

template <class T>
class filter : public testing::Test {};
TYPED_TEST_SUITE(filter, Dimensions);

TYPED_TEST(filter, damps_the_shortest_wave_of_an_axis_by_its_strength) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  for (int axis = 0; axis < D; ++axis) {
    FilteredPatch<T, D> box([&](const auto& cell) { return cell[axis] % 2 == 0 ? 1. : -1.; });
    box.filter();
    int checked = 0;
    box.for_each_inner([&](std::int64_t p, const auto&) {
      EXPECT_NEAR(box.result[p], (1 - box.strength) * box.field[p],
                  4 * std::numeric_limits<T>::epsilon());
      ++checked;
    });
    EXPECT_GT(checked, 0);
  }
}

TYPED_TEST(filter, leaves_cubics_alone) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  FilteredPatch<T, D> box([](const auto& cell) {
    double sum = 0;
    for (int i = 0; i < D; ++i) sum += std::pow(cell[i] - 8., 3) - 2 * std::pow(cell[i] - 5., 2);
    return sum;
  });
  box.filter();
  // Integers have no rounding error.
  box.for_each_inner([&](std::int64_t p, const auto&) { EXPECT_EQ(box.result[p], box.field[p]); });
}

TYPED_TEST(filter, leaves_parabolas_alone_beside_what_is_not_inside) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  FilteredPatch<T, D> box([](const auto& cell) {
    double sum = 0;
    for (int i = 0; i < D; ++i) sum += std::pow(cell[i] - 5., 2);
    return sum;
  });
  box.inside[box.hole()] = 0;
  box.filter();
  EXPECT_EQ(box.result, box.field);  // integers have no rounding error
}

TYPED_TEST(filter, keeps_the_sum_of_what_is_inside_and_all_else) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  FilteredPatch<T, D> box([](const auto& cell) { return cell[0] % 2 == 0 ? 16. : -16.; });
  box.inside[box.hole()] = 0;
  box.filter();
  double before = 0, after = 0;
  bool filtered = false;
  box.patch.for_each([&](std::int64_t p, const auto&) {
    if (box.inside[p] == 0) {
      EXPECT_EQ(box.result[p], box.field[p]);
      return;
    }
    before += box.field[p];
    after += box.result[p];
    filtered = filtered || box.result[p] != box.field[p];
  });
  EXPECT_TRUE(filtered);
  EXPECT_NEAR(after, before, 1e3 * std::numeric_limits<T>::epsilon());
}

TEST(fourth_difference, inside_is_that_of_the_fluxes_and_of_the_binomial_coefficients) {
  using P = xsimd::batch<double, xsimd::sse2>;
  constexpr int width = 8;
  std::array<Field<double>, 1> random = {Field<double>(5 * width)};
  jitter(random, 1., 4);
  const Field<double>& values = random[0];
  const Field<Mark> inside(5 * width, 1);
  const LineOffsets line = {{-2 * width, -width, width, 2 * width}};
  const Fluxes<P> all = fluxes_between<P>(&inside[2 * width], line);
  const double* centre = &values[2 * width];
  const double expected = centre[-2 * width] - 4 * centre[-width] + 6 * centre[0] -
                          4 * centre[width] + centre[2 * width];
  EXPECT_NEAR(fourth_difference<P>(centre, line, all).get(0), expected, 1e-14);
  EXPECT_NEAR(fourth_differences_inside<P>(centre, {line}).get(0), expected, 1e-14);
}

}  // namespace
}  // namespace pliant::kernels::test
