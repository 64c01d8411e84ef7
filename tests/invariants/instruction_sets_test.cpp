#include <gtest/gtest.h>

#include "tests/invariants/sample_runs.hpp"

namespace pliant::test {
namespace {

using kernels::Isa;

struct InstructionSets : OfSampleRuns {
  /// The particles after 20 steps with `isa`.
  Snapshot end_with(Isa isa) const {
    Solver solver(GetParam().settled(), {1, isa});
    advance(solver, 20);
    EXPECT_GE(solver.clock().remeshings, 1);
    return snapshot_of(solver, Slots::particles);
  }
};
INSTANTIATE_TEST_SUITE_P(runs, InstructionSets, testing::ValuesIn(sample_runs()), name_of);

TEST_P(InstructionSets, agree_within_rounding) {
  if (!is_supported(Isa::avx2)) GTEST_SKIP() << "this processor has no AVX2";
  const Snapshot narrow = end_with(Isa::sse2), wide = end_with(Isa::avx2);
  EXPECT_EQ(narrow.at("cell"), wide.at("cell"));
  for (const remeshed::Declaration& field : remeshed::state_fields) {
    // SSE2 has no fused multiply-add: each operation differs by 1e-16 of its terms, which are up to
    // 1e4 times their difference, and the errors of 80 stages add up.
    EXPECT_LT(relative_difference(narrow, wide, std::string(field.name)), 1e-10) << field.name;
  }
}

TEST_P(InstructionSets, with_fused_multiply_add_agree_to_the_bit) {
  if (!is_supported(Isa::avx512)) GTEST_SKIP() << "this processor has no AVX-512";
  EXPECT_EQ(differences(end_with(Isa::avx2), end_with(Isa::avx512)), none);
}

}  // namespace
}  // namespace pliant::test
