#include "engine/simulation/watch.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/case/checks/stability.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/simulation/methods.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/method/free_flight.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

// Shows a watch bodies of other speeds, as if their energy and momentum had changed.
struct Watching : testing::Test {
  Case flying(double speed, const std::string& checks = "", double density = 2) const {
    Case settings = tests::read_text(tests::block_case + "velocity = [" + fmt::format("{}", speed) +
                                     ", 0]\n[checks]\n" + checks);
    settings.time.step = 0.1;
    settings.bodies[0].material.density = density;
    return settings;
  }

  std::string seen(double speed, const std::string& checks = "", double density = 2) {
    const Case settings = flying(1, checks), other = flying(speed, checks, density);
    FreeFlight before(settings, {}), after(other, {});
    Watch watch(settings);
    watch.begin(before);
    const std::string warning = watch.observe(after, true);
    report = watch.report();
    return warning;
  }

  SummaryChecks report;
};

TEST_F(Watching, says_nothing_where_nothing_changes) {
  EXPECT_EQ(seen(1), "");
  EXPECT_TRUE(report.energy_is_known);
  EXPECT_EQ(report.created, 0);
  EXPECT_EQ(report.mass.share, 0);
}

TEST_F(Watching, warns_of_energy_that_no_work_explains) {
  EXPECT_EQ(seen(1.02), "");
  EXPECT_NEAR(report.energy.share, 1.02 * 1.02 - 1, 1e-12);
  const std::string warning = seen(1.2);
  EXPECT_NE(warning.find("energy was created without work: 0.44 of"), warning.npos) << warning;
  EXPECT_NE(warning.find("the momentum has changed"), warning.npos) << warning;
}

TEST_F(Watching, names_the_method_for_remeshed_bodies_that_stay_in_contact) {
  Case settings = flying(1);
  FreeFlight before(settings, {}), after(flying(1.2), {});
  settings.contacts.emplace_back();
  Watch watch(settings);
  watch.begin(before);
  const std::string warning = watch.observe(after, true);
  EXPECT_NE(warning.find("method = \"total_lagrangian\" where bodies stay in contact"),
            warning.npos)
      << warning;
}

// Created energy must not hide itself: the share is relative to the energy without it.
TEST_F(Watching, sees_what_was_created_against_what_there_was) {
  EXPECT_EQ(seen(std::sqrt(1.049), "momentum = \"off\""), "");
  EXPECT_NE(seen(std::sqrt(1.051), "momentum = \"off\""), "");
}

// There is no energy to compare with; strains of 1e-4 are not noticed.
TEST_F(Watching, sees_bodies_that_start_to_move_by_themselves) {
  const Case settings = flying(0);
  const double wave = fastest_wave(settings);
  const auto from_rest = [&](double speed) {
    const Case other = flying(speed);
    FreeFlight before(settings, {}), after(other, {});
    Watch watch(settings);
    watch.begin(before);
    return watch.observe(after, true);
  };
  EXPECT_EQ(from_rest(0).find("at rest"), std::string::npos);
  EXPECT_EQ(from_rest(1.4e-4 * wave).find("at rest"), std::string::npos);
  EXPECT_NE(from_rest(1.5e-4 * wave).find("bodies at rest got an energy of"), std::string::npos);
}

TEST_F(Watching, says_at_the_end_how_much_energy_was_lost) {
  const std::string off = "momentum = \"off\"";
  EXPECT_EQ(seen(0.98, off), "");
  EXPECT_LT(report.created, 0);
  const std::string warning = seen(0.5, off);
  EXPECT_NE(warning.find("0.75 of the largest energy or work is lost"), warning.npos) << warning;
  EXPECT_EQ(seen(0.5, off + "\nenergy = \"off\""), "");
}

// Energy taken by friction is in the budget, so that only the rest is lost.
TEST_F(Watching, says_so_where_there_is_friction_too) {
  const std::string off = "momentum = \"off\"\n";
  const Case settings = flying(1, off + R"([[boundary]]
name = "floor"
kind = "contact_wall"
friction = 0.3
geometry = { shape = "half_space", point = [0, -1], normal = [0, 1] }
)");
  const Case fast = flying(1, off), slow = flying(0.5, off);
  FreeFlight before(fast, {}), after(slow, {});
  Watch watch(settings);
  watch.begin(before);
  const std::string warning = watch.observe(after, true);
  EXPECT_NE(warning.find("0.75 of the largest energy or work is lost"), warning.npos) << warning;
}

TEST_F(Watching, watches_the_angular_momentum_of_a_body_that_turns) {
  const auto turning = [](const std::string& speed) {
    Case settings = tests::read_text(tests::block_case + "rotation = { centre = [0.5, 1], " +
                                     "angular_velocity = " + speed + " }\n");
    settings.time.step = 0.1;
    return settings;
  };
  const Case fast = turning("1"), slow = turning("0.9");
  FreeFlight before(fast, {}), after(slow, {});
  Watch watch(fast);
  watch.begin(before);
  const std::string warning = watch.observe(after, true);
  EXPECT_NE(warning.find("the angular momentum has changed"), warning.npos) << warning;
  // The box is 10 x 20 particles: 1/200 less of the rotation than if it were filled uniformly.
  EXPECT_NEAR(watch.report().angular_momentum.share, 0.1, 0.001);
  EXPECT_LT(watch.report().momentum.share, 1e-12);
}

// Such a run, from rest, ends within its first step or after a few.
TEST_F(Watching, sees_no_energy_created_in_a_run_of_a_step) {
  for (const std::string method : {"point_based", "total_lagrangian"}) {
    const std::string model = method == "point_based" ? "neo_hookean" : "linear";
    const Case settings =
        tests::read_text("method = \"" + method + "\"\ngravity = [0, -10]\n" +
                         tests::with(tests::block_case, "\"linear\"", "\"" + model + "\""));
    for (const double steps : {0.1, 0.5, 1., 1.5, 2.5, 20.3}) {
      const auto solver = methods().make(settings, {});
      Watch short_watch(settings);
      short_watch.begin(*solver);
      solver->advance(steps * solver->time_step());
      const auto after = solver->positions(0);
      EXPECT_EQ(short_watch.observe(*solver, true), "") << method << " after " << steps;
      EXPECT_LT(short_watch.report().energy.share, 0.01) << method << " after " << steps;
      EXPECT_EQ(solver->positions(0), after);
    }
  }
}

TEST_F(Watching, ends_a_run_that_is_no_longer_credible) {
  EXPECT_THROW(seen(3), StepFailure);
  EXPECT_THROW(seen(1.2, "energy = \"stop\""), StepFailure);
  EXPECT_EQ(seen(3, "energy = \"off\"\nmomentum = \"off\""), "");
}

TEST_F(Watching, says_when_the_energy_is_not_a_number) {
  const double density = std::numeric_limits<double>::quiet_NaN();
  const std::string warning = seen(1, "", density);
  EXPECT_NE(warning.find("the energy of the bodies is not a number"), warning.npos) << warning;
  EXPECT_THROW(seen(1, "energy = \"stop\"", density), StepFailure);
  EXPECT_EQ(seen(1, "energy = \"off\"", density), "");
}

TEST_F(Watching, watches_the_mass) {
  const std::string off = "energy = \"off\"\nmomentum = \"off\"\n";
  const std::string warning = seen(1, off, 1.8);
  EXPECT_NE(warning.find("the mass has changed by a share of 0.1"), warning.npos) << warning;
  EXPECT_THROW(seen(1, off + "mass = \"stop\"", 1.8), StepFailure);
}

TEST_F(Watching, warns_again_only_when_it_has_become_twice_as_bad) {
  const Case settings = flying(1, "momentum = \"off\"");
  FreeFlight at_start(settings, {});
  Watch watch(settings);
  watch.begin(at_start);
  std::vector<bool> warned;
  for (const double speed : {1.04, 1.05, 1.1}) {
    const Case other = flying(speed);
    FreeFlight later(other, {});
    warned.push_back(!watch.observe(later, true).empty());
  }
  EXPECT_EQ(warned, (std::vector<bool>{true, false, true}));
}

TEST_F(Watching, continues_from_a_checkpoint) {
  const Case settings = flying(1), other = flying(1.02);
  FreeFlight before(settings, {}), after(other, {});
  Watch watch(settings), restored(settings);
  watch.begin(before);
  watch.observe(after, true);
  const TemporaryFolder folder;
  {
    ArchiveWriter archive(folder / "watch.h5");
    watch.put(archive);
    archive.commit();
  }
  restored.get(ArchiveReader(folder / "watch.h5"));
  restored.observe(after, true);
  EXPECT_EQ(restored.report().energy.share, watch.report().energy.share);
  EXPECT_EQ(restored.report().created, watch.report().created);
}

}  // namespace
}  // namespace pliant::test
