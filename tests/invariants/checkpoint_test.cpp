#include <gtest/gtest.h>

#include "engine/remeshed/solver.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/invariants/sample_runs.hpp"

namespace pliant::test {
namespace {

struct Checkpoints : OfSampleRuns {
  TemporaryFolder folder;
};
INSTANTIATE_TEST_SUITE_P(runs, Checkpoints, testing::ValuesIn(sample_runs()), name_of);
INSTANTIATE_TEST_SUITE_P(listed_runs, Checkpoints, testing::ValuesIn(listed_runs()), name_of);

// Right after a remeshing, right before one, and between.
TEST_P(Checkpoints, a_restored_solver_goes_on_to_the_same_bits) {
  for (const int steps : {5, 9, 12, GetParam().middle}) {
    Solver solver(GetParam().settled(), {1, kernels::widest_supported()});
    advance(solver, steps);
    ArchiveWriter writer(folder / "solver.h5");
    solver.save(writer);
    writer.commit();
    Solver restored(GetParam().settled(), {2, kernels::widest_supported()});
    restored.restore(ArchiveReader(folder / "solver.h5"));
    EXPECT_EQ(differences(snapshot_of(solver), snapshot_of(restored)), none);
    for (Solver* each : {&solver, &restored}) {
      advance(*each, GetParam().steps - steps);
      EXPECT_GE(each->clock().remeshings, 3);
    }
    Snapshot end = snapshot_of(solver), restored_end = snapshot_of(restored);
    end["measurements"] = solver.measure();
    restored_end["measurements"] = restored.measure();
    EXPECT_EQ(differences(end, restored_end), none) << "from step " << steps;
  }
}

}  // namespace
}  // namespace pliant::test
