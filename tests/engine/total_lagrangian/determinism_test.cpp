#include <gtest/gtest.h>

#include <cstring>

#include "engine/simulation/run.hpp"
#include "tests/engine/output/file_content.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/total_lagrangian/blocks.hpp"

// The bits of a result depend on the case alone.
namespace pliant::test {
namespace {

Case aspiration(const std::vector<std::string>& more = {}) {
  std::vector<std::string> settings = {"discretisation.spacing=2.5e-3", "time.end=0.4",
                                       "time.step=2e-3", "output.every=0.1",
                                       "output.measure_every=0.05"};
  settings.insert(settings.end(), more.begin(), more.end());
  return read_case(PLIANT_SOURCE_DIR "/cases/liver_aspiration", settings);
}

FileContent result_of(const Case& settings, const std::filesystem::path& folder, int threads,
                      bool resume = false) {
  RunOptions options;
  options.folder = folder;
  options.quiet = true;
  options.isa = kernels::widest_supported();
  options.threads = threads;
  options.resume = resume;
  EXPECT_EQ(run_case(settings, options), RunEnd::done);
  return content_of(folder / "result.h5");
}

TEST(total_lagrangian, bytes_do_not_depend_on_the_number_of_threads) {
  const TemporaryFolder folder;
  const Case settings = aspiration({"total_lagrangian.damping=adaptive"});
  const FileContent one = result_of(settings, folder / "1", 1);
  for (const int threads : {2, 7}) {
    EXPECT_EQ(result_of(settings, folder / std::to_string(threads), threads), one) << threads;
  }
}

TEST(total_lagrangian, bytes_do_not_depend_on_a_restart) {
  const TemporaryFolder folder;
  const Case settings = aspiration({"total_lagrangian.damping=adaptive"});
  const FileContent through = result_of(settings, folder / "through", 1);
  // The last checkpoint is before the end: the continued run writes the end once more.
  EXPECT_EQ(result_of(settings, folder / "through", 2, true), through);
}

// Fitted cells have memory too.
TEST(total_lagrangian, nor_do_those_of_viscous_tissue) {
  const TemporaryFolder folder;
  const std::string series = "={ratios=[0.3,0.2],times=[0.05,0.2]}";
  const Case settings =
      aspiration({"material.liver.prony" + series, "material.liver.prony_shear" + series});
  const FileContent one = result_of(settings, folder / "1", 1);
  EXPECT_EQ(result_of(settings, folder / "3", 3), one);
  EXPECT_EQ(result_of(settings, folder / "1", 2, true), one);
}

TEST(total_lagrangian, wide_instruction_sets_agree_to_the_bit) {
  if (!kernels::is_supported(kernels::Isa::avx512)) GTEST_SKIP() << "no AVX-512 here";
  const Case settings = aspiration();
  LagrangianSolver<3> wide(settings, {1, kernels::Isa::avx512});
  LagrangianSolver<3> narrow(settings, {1, kernels::Isa::avx2});
  for (int step = 0; step < 20; ++step) {
    wide.step(HUGE_VAL);
    narrow.step(HUGE_VAL);
  }
  const auto& a = wide.state().bodies[0];
  const auto& b = narrow.state().bodies[0];
  for (int c = 0; c < 3; ++c) {
    const std::size_t bytes = a.layout.slots() * sizeof(double);
    EXPECT_EQ(std::memcmp(a.displacement[c].get(), b.displacement[c].get(), bytes), 0) << c;
  }
  EXPECT_GT(*std::max_element(a.displacement[2].get(), a.displacement[2].get() + a.layout.slots()),
            0);
}

TEST(total_lagrangian, any_legal_order_of_a_step_gives_the_same_bits) {
  std::vector<double> first;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    LagrangianSolver<3> solver(aspiration(), {1, kernels::widest_supported()});
    for (int step = 0; step < 3; ++step) solver.step(HUGE_VAL);
    solver.workers().execute([&] { solver.step_graph().run_serially(seed); });
    const auto& body = solver.state().bodies[0];
    const std::vector<double> end(body.end_displacement[2].get(),
                                  body.end_displacement[2].get() + body.layout.slots());
    if (seed == 0) first = end;
    EXPECT_EQ(end, first) << seed;
  }
}

}  // namespace
}  // namespace pliant::test
