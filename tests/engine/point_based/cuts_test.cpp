#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/point_based/cutting/cut_surface.hpp"
#include "tests/engine/output/temporary_folder.hpp"
#include "tests/engine/point_based/blocks.hpp"
#include "tests/engine/point_based/whole_runs.hpp"

namespace pliant::test {
namespace {

const std::string parts = R"([[measurement]]
name = "parts"
kind = "connected_parts"
[[measurement]]
name = "largest"
kind = "largest_part_volume"
)";

/// A blade that sweeps the plane z = `height` in two steps of 1e-9 s.
std::string sudden_cut(const std::string& height) {
  return R"toml([[cut]]
name = "blade"
from = [-0.1, -0.1, )toml" +
         height + "]\nto = [-0.1, 1.1, " + height + "]\npath = [\"6e8*t\", 0, 0]\nend = 2e-9\n";
}

const std::vector<std::string> tiny_steps = {"time.step=1e-9"};

template <int D>
PointSolver<D> solver_of(const std::string& text, const std::vector<std::string>& more = {}) {
  return PointSolver<D>(tests::read_text(text, more), {1, kernels::widest_supported()});
}

TEST(cuts, through_a_body_leave_two_parts_with_its_volume) {
  auto solver = solver_of<3>(free_points(3) + sudden_cut("0.3125") + parts, tiny_steps);
  EXPECT_EQ(solver.measure(0), 1);
  for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
  EXPECT_EQ(solver.measure(0), 2);
  EXPECT_NEAR(solver.measure(1), 1 - 0.3125, 1e-9);
}

TEST(cuts, in_a_plane_body_work_alike) {
  const std::string blade = R"toml([[cut]]
name = "blade"
from = [0.4375, -0.1]
path = [0, "6e8*t"]
end = 2e-9
)toml";
  auto solver = solver_of<2>(free_points(2) + blade + parts, tiny_steps);
  for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
  EXPECT_EQ(solver.measure(0), 2);
  EXPECT_NEAR(solver.measure(1), 1 - 0.4375, 1e-9);
}

// At 0.5 the cut goes through nodes, at 0.4 and 0.03 between them.
TEST(cuts, leave_parts_that_end_at_them) {
  for (const double x : {0.5, 0.4, 0.03}) {
    const std::string blade = fmt::format(
        "[[cut]]\nname = \"blade\"\nfrom = [{}, -0.1]\npath = [0, \"6e8*t\"]\nend = 2e-9\n", x);
    auto solver = solver_of<2>(free_points(2) + blade + parts, tiny_steps);
    for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
    EXPECT_EQ(solver.measure(0), 2);
    EXPECT_NEAR(solver.measure(1), 1 - x, 0.005) << x;
  }
  for (const char* height : {"0.5", "0.3"}) {
    auto solver = solver_of<3>(free_points(3) + sudden_cut(height) + parts, tiny_steps);
    for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
    EXPECT_NEAR(solver.measure(1), 1 - std::stod(height), 0.005) << height;
  }
}

// The blade starts in the body between two steps, and turns once around in four steps.
TEST(cuts, begin_where_the_blade_starts_and_follow_its_path) {
  const std::string blade = R"toml([[cut]]
name = "blade"
from = [0.81, 0.52]
path = ["0.3*(cos(2*pi*(t - 4e-10)/4e-9) - 1)", "0.3*sin(2*pi*(t - 4e-10)/4e-9)"]
start = 4e-10
end = 4.4e-9
)toml";
  auto solver = solver_of<2>(free_points(2) + blade + parts, tiny_steps);
  for (int step = 0; step < 8; ++step) solver.step(HUGE_VAL);
  const auto& cut = solver.state().cuts[0]->surfaces()[0];
  EXPECT_NEAR(cut.points().front()[0], 0.81, 1e-12);
  EXPECT_NEAR(cut.points().back()[1], 0.52, 1e-12);
  EXPECT_EQ(solver.measure(0), 2);
  EXPECT_NEAR(solver.measure(1), 1 - std::numbers::pi * 0.09, 0.01);
}

// Once a frame the caller gives the place of the blade, and lifts it behind the body. The expected
// volume follows from the plane that the blade sweeps.
TEST(cuts, by_a_caller_divide_a_body_as_those_of_a_case_do) {
  const auto text = [](const std::string& path) {
    return free_points(3) + "[[cut]]\nname = \"blade\"\nfrom = [0.43, -0.1, -0.1]\n" +
           "to = [0.47, -0.1, 1.1]\n" + path + parts;
  };
  const std::vector<std::string> damped = {"point_based.damping=2"};
  auto by_case = solver_of<3>(text("path = [\"0.1*t\", \"2*t\", 0]\nend = 0.6\n"), damped);
  advance_until(by_case, 0.7);
  auto by_caller = solver_of<3>(text("path = [0, 0, 0]\nstart = 99\nend = 100\n"), damped);
  for (int frame = 0; frame <= 36; ++frame) {
    const double t = frame / 60., x = 0.1 * t, y = -0.1 + 2 * t;
    by_caller.put_blade(0, {0.43 + x, y, -0.1}, {0.47 + x, y, 1.1});
    advance_until(by_caller, t + 1. / 60);
  }
  by_caller.lift_blade(0);
  advance_until(by_caller, 0.7);
  for (auto* solver : {&by_case, &by_caller}) {
    EXPECT_EQ(solver->measure(0), 2);
    EXPECT_NEAR(solver->measure(1), 0.52, 0.001);
  }
}

// The node nearest to a point beside a cut may be on the other side.
TEST(cuts, between_a_point_and_its_nearest_node_do_not_move_the_point_with_that_node) {
  const std::string blade = R"toml([[cut]]
name = "blade"
from = [0.47, -0.1]
path = [0, "6e8*t"]
end = 2e-9
)toml";
  const auto point = [](const std::string& name, const std::string& x) {
    return "[[measurement]]\nname = \"" + name + "\"\nkind = \"point_displacement\"\npoint = [" +
           x + ", 0.5]\naxis = \"x\"\n";
  };
  auto solver = solver_of<2>(
      free_points(2) + blade + point("left", "0.46") + point("right", "0.48"), tiny_steps);
  for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
  auto& body = solver.state().bodies[0];
  body.for_each_node([&](std::int64_t slot) {
    body.displacement[0][slot] = body.start[slot][0] < 0.47 ? -0.1 : 0.2;
  });
  EXPECT_NEAR(solver.measure(0), -0.1, 1e-12);
  EXPECT_NEAR(solver.measure(1), 0.2, 1e-12);
}

/// Affine with a small wave.
void shear_and_bend(point_based::Body<double, 3>& body) {
  Eigen::Matrix3d f;
  f << 1.3, 0.2, 0, 0, 0.9, 0.1, 0, 0, 0.95;
  body.for_each_node([&](std::int64_t slot) {
    for (int i = 0; i < 3; ++i) {
      double d = -body.start[slot][i] + 0.01 * std::sin(9 * body.start[slot][(i + 1) % 3]);
      for (int j = 0; j < 3; ++j) d += f(i, j) * body.start[slot][j];
      body.displacement[i][slot] = d;
    }
  });
}

// The energy of the stabilisation may still change.
TEST(cuts, do_not_inject_energy) {
  auto solver = solver_of<3>(free_points(3) + sudden_cut("0.4375"), tiny_steps);
  shear_and_bend(solver.state().bodies[0]);
  const double before = solver.integrals().strain_energy;
  for (int step = 0; step < 3; ++step) solver.step(HUGE_VAL);
  EXPECT_NEAR(solver.integrals().strain_energy, before, 1e-3 * before);
  double last = solver.integrals().strain_energy;
  for (int step = 0; step < 100; ++step) solver.step(HUGE_VAL);
  EXPECT_LE(solver.integrals().strain_energy, last * (1 + 1e-9));
}

std::string slow_cut(const std::string& velocity) {
  return free_points(3) + "velocity = " + velocity + "\n" + R"toml([[cut]]
name = "blade"
from = [-0.1, -0.1, 0.45]
to = [-0.1, 1.1, 0.45]
path = ["2.5*(t - 0.05)", 0, 0]
start = 0.05
end = 0.55
)toml" + parts;
}

TEST(cuts, in_a_moving_body_keep_its_momenta) {
  auto solver = solver_of<3>(slow_cut(R"toml(["3*y + sin(4*x)", "1 - 3*x", "2*cos(3*y)"])toml"));
  const BodyIntegrals start = solver.integrals();
  advance_until(solver, 0.7);
  const BodyIntegrals end = solver.integrals();
  EXPECT_EQ(solver.measure(0), 2);
  const double momentum = 5;  // a bound on the integral of rho abs(u)
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(end.momentum[axis], start.momentum[axis], 1e-14 * momentum);
    EXPECT_NEAR(end.angular_momentum[axis], start.angular_momentum[axis], 1e-13 * momentum);
  }
  const double energy = start.kinetic_energy + start.strain_energy;
  // Relaxation dissipates some energy, and nothing adds any.
  EXPECT_LT(end.kinetic_energy + end.strain_energy, energy * (1 + 1e-3));
  EXPECT_GT(end.kinetic_energy + end.strain_energy, energy * (1 - 0.05));
}

TEST(cuts, continue_after_a_restart_to_the_same_bytes) {
  const TemporaryFolder folder;
  const Case settings =
      tests::read_text(slow_cut(R"(["2*z", 0, 0])"), {"time.end=0.6", "output.every=0.25"});
  const FileContent through = result_of(settings, folder / "run", 1);
  EXPECT_EQ(result_of(settings, folder / "run", 2, true), through);
}

// A cut above the lowest layer leaves nodes whose neighbours are in one plane.
TEST(cuts, that_leave_a_single_layer_leave_a_sheet_that_feels_no_rotation) {
  auto solver = solver_of<3>(free_points(3) + sudden_cut("0.0625"), tiny_steps);
  for (int step = 0; step < 4; ++step) solver.step(HUGE_VAL);
  auto& body = solver.state().bodies[0];
  std::size_t degenerate = 0;
  for (const auto& list : body.degenerate) degenerate += list.size();
  EXPECT_EQ(degenerate, 9 * 9);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (const double stretch : {1., 1.1}) {
    body.for_each_node([&](std::int64_t slot) {
      for (int i = 0; i < 3; ++i) {
        body.displacement[i][slot] = -body.start[slot][i];
        for (int j = 0; j < 3; ++j) {
          body.displacement[i][slot] += stretch * turn(i, j) * body.start[slot][j];
        }
        body.velocity[i][slot] = 0;
      }
    });
    solver.step(HUGE_VAL);
    double largest = 0;
    body.for_each_node([&](std::int64_t slot) {
      if (body.start[slot][2] > 0.01) return;
      for (int i = 0; i < 3; ++i) {
        largest = std::max(largest, std::abs(body.velocity[i][slot]) * body.mass[slot] / 1e-9);
      }
    });
    if (stretch == 1) {
      EXPECT_LT(largest, 1e-11);
    } else {
      EXPECT_GT(largest, 1e-3);
    }
  }
}

TEST(cuts, of_no_length_or_no_time_are_refused) {
  const std::string start = free_points(3) + "[[cut]]\nname = \"blade\"\npath = [1, 0, 0]\n";
  EXPECT_NE(tests::complaint(start + "from = [0, 0, 1]\nto = [0, 0, 1]\nend = 1\n")
                .find("the edge of cut \"blade\" has no length"),
            std::string::npos);
  EXPECT_NE(tests::complaint(start + "from = [0, 0, 1]\nto = [0, 1, 1]\nstart = 2\nend = 1\n")
                .find("cut \"blade\" ends at 1, and starts at 2"),
            std::string::npos);
}

TEST(cuts, with_an_edge_in_2d_are_refused) {
  const std::string start =
      free_points(2) + "[[cut]]\nname = \"blade\"\npath = [\"t\", 0]\nend = 1\nfrom = [0, 1]\n";
  EXPECT_NE(tests::complaint(start + "to = [1, 1]\n").find("\"blade\" is a point in 2D"),
            std::string::npos);
  EXPECT_NO_THROW(tests::read_text(start + "to = [0, 1]\n"));
}

// A caller may move the blade anywhere.
TEST(cuts, that_wait_for_a_caller_are_not_asked_where_they_start) {
  const std::string blade = free_points(3) +
                            "[[cut]]\nname = \"blade\"\npath = [1, 0, 0]\n"
                            "from = [0, 0, 1]\nto = [0, 1, 1]\nend = 3\n";
  for (const std::string start : {"1", "2"}) {  // the run ends at 1
    EXPECT_NO_THROW(tests::read_text(blade + "start = " + start + "\n")) << start;
  }
  EXPECT_NE(tests::complaint(blade + "start = 0.5\n").find("the path of cut \"blade\""),
            std::string::npos);
}

}  // namespace
}  // namespace pliant::test
