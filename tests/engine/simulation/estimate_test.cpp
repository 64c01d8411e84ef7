#include "engine/simulation/estimate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <pliant/error.hpp>

#include "engine/case/reading/read_case.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::test {
namespace {

struct Sample {
  const char* name;
  std::vector<std::string> settings;

  friend std::ostream& operator<<(std::ostream& stream, const Sample& sample) {
    return stream << sample.name;
  }
};

const Sample samples[] = {
    {"rotating_cylinder", {"discretisation.spacing=0.02", "time.end=0.025"}},
    {"compression_hyperelastic", {"discretisation.spacing=1/64", "time.end=0.001"}},
    {"bouncing_ball", {"discretisation.spacing=0.03", "time.end=0.0025"}},
    {"liver_aspiration", {"time.end=0.02"}},
};

class Estimates : public testing::TestWithParam<Sample> {
 protected:
  Case a_case_ = read_case(std::filesystem::path(PLIANT_SOURCE_DIR) / "cases" / GetParam().name,
                           GetParam().settings);
};

TEST_P(Estimates, of_particles_and_steps_are_within_a_fifth) {
  const Estimate size = estimate(a_case_);
  const auto solver = methods().make(a_case_, {});
  EXPECT_NEAR(static_cast<double>(size.particles), static_cast<double>(solver->particles()),
              0.1 * static_cast<double>(size.particles));
  solver->advance(a_case_.time.end);
  const auto steps = static_cast<double>(solver->clock().step);
  EXPECT_NEAR(static_cast<double>(size.steps), steps, 1 + 0.2 * steps);
}

// 40/s in a run too short for waves to change it: ten steps of at most 2 % strain, where waves
// would need one.
TEST(estimate, knows_the_steps_that_strain_asks_for) {
  const std::string text = tests::with(tests::block_case, "end = 1", "end = 0.005");
  const Case slow = tests::read_text(text),
             fast = tests::read_text(text + R"(velocity = ["-40*x", 0]
)");
  const auto solver = methods().make(fast, {});
  solver->advance(fast.time.end);
  const auto steps = static_cast<double>(solver->clock().step);
  EXPECT_GT(steps, 2 * static_cast<double>(estimate(slow).steps));
  EXPECT_NEAR(static_cast<double>(estimate(fast).steps), steps, 1 + 0.1 * steps);
}

TEST_P(Estimates, of_time_exist) {
  const auto seconds = estimated_seconds(a_case_, estimate(a_case_), {}, methods());
  ASSERT_TRUE(seconds);
  EXPECT_GT(*seconds, 0);
}

INSTANTIATE_TEST_SUITE_P(cases, Estimates, testing::ValuesIn(samples),
                         [](const auto& sample) { return std::string(sample.param.name); });

// A disc of 10^8 particles: one slot for each, and a rim.
TEST(estimate, large_bodies_are_counted_on_a_coarse_lattice) {
  const Case a_case =
      read_case(std::filesystem::path(PLIANT_SOURCE_DIR) / "cases/rotating_cylinder",
                std::vector<std::string>{"discretisation.spacing=sqrt(pi)*1e-4"});
  const Estimate size = estimate(a_case);
  EXPECT_NEAR(static_cast<double>(size.particles), 1e8, 1e6);
  EXPECT_NEAR(static_cast<double>(size.slots), 1e8, 2e6);
}

// More bytes than fit in a 64-bit number.
TEST(estimate, no_spacing_is_so_fine_that_it_seems_to_fit) {
  for (const char* spacing : {"1e-8", "1e-9", "1e-12"}) {
    const Case a_case =
        read_case(std::filesystem::path(PLIANT_SOURCE_DIR) / "cases/rotating_cylinder",
                  std::vector<std::string>{fmt::format("discretisation.spacing={}", spacing)});
    EXPECT_THROW(refuse_what_does_not_fit(a_case, estimate(a_case), std::size_t{1} << 50),
                 InputError)
        << spacing;
  }
}

TEST(estimate, runs_that_do_not_fit_are_refused_with_what_to_do) {
  Case a_case;
  a_case.name = "giant";
  Estimate size;
  size.particles = 1000;
  size.bytes = 3'000'000'000;
  EXPECT_NO_THROW(refuse_what_does_not_fit(a_case, size, 3'000'000'000));
  try {
    refuse_what_does_not_fit(a_case, size, 850'000'000);
    FAIL() << "it fits";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "giant: the run needs about 3.0 GB of memory for 1000 particles, and 850 MB are "
                 "available; use a coarser discretisation.spacing, or --force to try");
  }
}

TEST(available_memory, ends_at_the_limit_of_address_space) {
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  EXPECT_GT(available_memory(), 1'000'000u);
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit limit = before;
  limit.rlim_cur = pages * sysconf(_SC_PAGESIZE) + 50'000'000;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &limit), 0);
  const std::size_t available = available_memory();
  setrlimit(RLIMIT_AS, &before);
  EXPECT_LE(available, 50'000'000u);
}

TEST(duration_text, takes_the_unit_that_people_would) {
  EXPECT_EQ(duration_text(4), "4 s");
  EXPECT_EQ(duration_text(300), "5 min");
  EXPECT_EQ(duration_text(7200), "2.0 h");
  EXPECT_EQ(duration_text(864000), "10.0 days");
}

}  // namespace
}  // namespace pliant::test
