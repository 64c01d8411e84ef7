#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "kernels/total_lagrangian/table.hpp"
#include "tests/kernels/patch.hpp"
#include "tests/kernels/tables.hpp"

namespace pliant::kernels::test {
namespace {

constexpr double bulk_modulus = 40, kept = 0.9, gained = 0.02, time_step = 0.01;

/// A block of rubber: cells are filled if their lowest corner is an interior slot of the patch.
template <class T, int D>
struct Block {
  Block() : patch(cells(), T(0.125)), fraction(patch.slots), inverse_mass(patch.slots) {
    material.law = ElasticLaw::reduced_polynomial;
    material.polynomial.model = Model::reduced_polynomial;
    material.polynomial.order = 1;
    material.polynomial.coefficient = {T(10)};
    material.polynomial.compressibility = T(2 / bulk_modulus);
    material.shear_modulus = T(20);
    material.lame_modulus = T(bulk_modulus - 2. / 3 * 20);
    for (auto* fields : {&displacement, &velocity, &internal, &traction}) {
      for (Field<T>& field : *fields) field.assign(patch.slots, T(0));
    }
    patch.for_each_interior([&](std::int64_t p, const auto&) {
      fraction[p] = 1;
      inverse_mass[p] = 2;
    });
  }

  static std::array<int, D> cells() {
    std::array<int, D> n;
    n.fill(12);
    n[0] = 3 * slots_per_pack;
    return n;
  }

  /// d = (F - I) x
  void deform() {
    patch.for_each([&](std::int64_t p, const std::array<std::int32_t, D>& cell) {
      for (int i = 0; i < D; ++i) {
        double d = 0;
        for (int j = 0; j < D; ++j) d += slope[i][j] * cell[j] * patch.spacing;
        displacement[i][p] = static_cast<T>(d);
        largest = std::max(largest, std::abs(d));
      }
    });
  }

  /// Lets the surface of the body cut the cells of every other pack.
  void cut_cells() {
    cut.resize(patch.slots / slots_per_pack);
    cut_packs.resize(2);
    for (std::size_t k = 0; k < cut.size(); ++k) cut[k] = k % 2;
    for (int m = 0; m < (1 << D); ++m) {
      for (int lane = 0; lane < slots_per_pack; ++lane) {
        cut_packs[0].moment[m][lane] = m == 0 ? 1 : 0;
        cut_packs[1].moment[m][lane] = m == 0 ? T(1) : T(0.1 * m - 0.05 * lane);
      }
    }
  }

  /// Cells around the particles, one run for each row of cells, or if the surface cuts some of them
  /// one for each pack.
  std::vector<CellRun<D>> runs() const {
    std::vector<CellRun<D>> found;
    for (const Segment<D>& segment : patch.segments) {
      if (segment.neighbour_row[row_index<D>(1)] == 0) continue;
      CellRun<D> run = {};
      run.first = segment.first;
      run.count = segment.count;
      run.own = true;
      for (int r = 0; r < corner_rows<D>; ++r) {
        run.row[r] = segment.neighbour_row[row_index<D>(r & 1, r >> 1)];
        run.target[r] = segment.first + run.row[r] - patch.segments.front().first;
      }
      if (cut.empty()) {
        found.push_back(run);
        continue;
      }
      run.count = slots_per_pack;
      for (; run.first < segment.first + segment.count; run.first += slots_per_pack) {
        run.continues = run.first > segment.first;
        run.cut = cut[run.first / slots_per_pack] != 0;
        found.push_back(run);
        for (std::int64_t& target : run.target) target += slots_per_pack;
      }
    }
    return found;
  }

  MotionResult step(Isa isa) {
    const std::vector<CellRun<D>> cells = runs();
    Motion<T, D> motion{};
    motion.runs = cells.data();
    motion.run_count = static_cast<int>(cells.size());
    motion.first_slot = patch.segments.front().first;
    motion.slot_count =
        patch.segments.back().first + patch.segments.back().count - motion.first_slot;
    motion.spacing = patch.spacing;
    motion.hourglass = {T(0.8), T(1.2), T(0.2), T(0.4)};
    motion.examine = true;
    motion.material = material;
    motion.fraction = fraction.data();
    motion.cut = cut.data();
    motion.cut_packs = cut_packs.data();
    motion.kept = T(kept);
    motion.gained = T(gained);
    motion.time_step = T(time_step);
    motion.inverse_mass = inverse_mass.data();
    std::array<Field<T>, D> next = displacement, force;
    for (int i = 0; i < D; ++i) {
      force[i].assign(motion.slot_count, T(0));
      motion.displacement[i] = displacement[i].data();
      motion.next_displacement[i] = next[i].data();
      motion.velocity[i] = velocity[i].data();
      motion.internal[i] = internal[i].data();
      motion.traction[i] = traction[i].data();
      motion.force[i] = force[i].data();
    }
    result = TotalLagrangianTable<T, D>::of(isa).advance_motion(motion);
    displacement = next;
    return result;
  }

  static constexpr double slope[3][3] = {{0.2, 0.1, -0.05}, {-0.1, 0.1, 0.05}, {0.05, -0.1, 0.1}};
  Patch<T, D> patch;
  HyperelasticMaterial<T> material;
  Field<T> fraction, inverse_mass;
  std::vector<std::int32_t> cut;
  std::vector<CutPack<T, D>> cut_packs;
  std::array<Field<T>, D> displacement, velocity, internal, traction;
  double largest = 0;  ///< component of the displacement
  MotionResult result{};
};

/// Effect of rounding displacements on the force on a particle: strain errors of so many units of
/// d/h, times the modulus and the area of a cell.
template <class T, int D>
double rounding(const Block<T, D>& block) {
  const double h = block.patch.spacing;
  return 32 * std::numeric_limits<T>::epsilon() * block.largest / h * bulk_modulus *
         std::pow(h, D - 1);
}

template <class T>
class total_lagrangian_kernels : public testing::Test {};
TYPED_TEST_SUITE(total_lagrangian_kernels, Dimensions);

TYPED_TEST(total_lagrangian_kernels, a_homogeneous_deformation_pulls_on_faces_only) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Block<T, D> block;
  block.deform();
  block.step(Isa::sse2);
  EXPECT_EQ(block.result.non_finite, -1);
  double outside = 0;
  block.patch.for_each_interior([&](std::int64_t p, const std::array<std::int32_t, D>& cell) {
    bool inside = true;
    for (int i = 0; i < D; ++i) inside = inside && cell[i] > Patch<T, D>::margin;
    for (int i = 0; i < D; ++i) {
      if (inside) {
        EXPECT_NEAR(block.internal[i][p], 0, rounding(block));
      } else {
        outside = std::max(outside, std::abs(double(block.internal[i][p])));
      }
    }
  });
  EXPECT_GT(outside, 100 * rounding(block)) << "there is no stress at all";
}

TYPED_TEST(total_lagrangian_kernels, force_and_traction_move_a_particle) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Block<T, D> block;
  jitter(block.displacement, T(0.01), 4);
  jitter(block.velocity, T(1), 5);
  jitter(block.traction, T(1), 6);
  const Block<T, D> before = block;
  block.step(Isa::sse2);
  const double tolerance = 8 * std::numeric_limits<T>::epsilon();
  block.patch.for_each_interior([&](std::int64_t p, const auto&) {
    for (int i = 0; i < D; ++i) {
      const double force = double(block.internal[i][p]) + double(before.traction[i][p]);
      const double u = kept * double(before.velocity[i][p]) + gained * 2 * force;
      EXPECT_NEAR(block.velocity[i][p], u, tolerance);
      EXPECT_NEAR(block.displacement[i][p], before.displacement[i][p] + time_step * u, tolerance);
    }
  });
}

TYPED_TEST(total_lagrangian_kernels, instruction_sets_agree_with_the_baseline_within_rounding) {
  using T = typename TypeParam::Scalar;
  constexpr int D = TypeParam::dimension;
  Block<T, D> whole, cut;
  cut.cut_cells();
  for (const auto& [start, law] : {std::pair{&whole, ElasticLaw::reduced_polynomial},
                                   {&whole, ElasticLaw::neo_hookean},
                                   {&whole, ElasticLaw::st_venant_kirchhoff},
                                   {&cut, ElasticLaw::reduced_polynomial},
                                   {&cut, ElasticLaw::neo_hookean}}) {
    Block<T, D> baseline = *start;
    jitter(baseline.displacement, T(0.01), 4);
    jitter(baseline.velocity, T(1), 5);
    baseline.material.law = law;
    for (const Isa isa : {Isa::avx2, Isa::avx512}) {
      if (!is_supported(isa)) continue;
      Block<T, D> wide = baseline, narrow = baseline;
      wide.step(isa);
      narrow.step(Isa::sse2);
      EXPECT_NEAR(wide.result.wave_speed / narrow.result.wave_speed, 1, exact<T>);
      // A wide register may extend beyond a segment into unused slots.
      baseline.patch.for_each_interior([&](std::int64_t p, const auto&) {
        for (int i = 0; i < D; ++i) {
          EXPECT_NEAR(wide.velocity[i][p], narrow.velocity[i][p], exact<T>) << name(isa);
          EXPECT_NEAR(wide.displacement[i][p], narrow.displacement[i][p], exact<T>) << name(isa);
        }
      });
    }
  }
}

}  // namespace
}  // namespace pliant::kernels::test
