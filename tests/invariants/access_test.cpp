#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "engine/finite_elements/regions.hpp"
#include "engine/finite_elements/solver.hpp"
#include "engine/point_based/regions.hpp"
#include "engine/point_based/solver.hpp"
#include "engine/remeshed/regions.hpp"
#include "engine/remeshed/resources.hpp"
#include "engine/sph/solver.hpp"
#include "engine/total_lagrangian/regions.hpp"
#include "engine/total_lagrangian/solver.hpp"
#include "scheduler/access_check.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/invariants/sample_runs.hpp"

// Phases declare all that they read and write: the graph orders them by that, and in several
// processes it would tell what to send.
namespace pliant::test {
namespace {

using remeshed::Group;
using scheduler::AccessProbe;
using scheduler::BlockId;
using scheduler::FieldId;
using scheduler::FieldMemory;
using scheduler::StepGraph;
using scheduler::undeclared_accesses;
using Region = std::span<std::byte>;

/// Groups whose memory holds integers, which cannot be disturbed.
constexpr std::array integers = {Group::kinds, Group::image_sources, Group::fits,
                                 Group::contact_points, Group::neighbour_lists};

void add(Region region, bool are_numbers, FieldMemory& memory) {
  if (are_numbers) {
    memory.add(reinterpret_cast<double*>(region.data()), region.size() / sizeof(double));
  } else {
    memory.add_fixed(region.data(), region.size());
  }
}

void add(const std::vector<Region>& regions, Group group, FieldMemory& memory) {
  for (const Region region : regions) {
    if (group == Group::contact) {
      memory.add_flags(reinterpret_cast<std::uint8_t*>(region.data()), region.size());
    } else {
      add(region, std::ranges::find(integers, group) == integers.end(), memory);
    }
  }
}

/// The graphs of a remeshing number the blocks of two lattices: they are left out.
template <int D>
void add_memory(remeshed::State<double, D>& state, const StepGraph& graph, FieldId field,
                BlockId block, FieldMemory& memory) {
  const bool is_of_remeshing = std::ranges::any_of(
      graph.phases(), [](const auto& phase) { return phase.name.starts_with("remesh: "); });
  const Group group = remeshed::resource_numbers[field].group;
  const bool is_new = group >= Group::new_state && group != Group::particle_counts;
  if (!is_of_remeshing && !is_new) add(remeshed::regions(state, field, block), group, memory);
}

std::string text(const std::vector<scheduler::UndeclaredAccess>& accesses) {
  std::string lines;
  for (const auto& access : accesses) lines += text(access) + '\n';
  return lines;
}

/// What is undeclared in the last of some steps.
template <class Method>
std::string undeclared(const Case& settings, int steps) {
  return text(undeclared_accesses([&](AccessProbe& probe) {
    Method solver(settings, {.threads = 1});
    for (int step = 1; step < steps; ++step) solver.step(HUGE_VAL);
    probe.watch(solver.workers(),
                [&](const StepGraph& graph, FieldId field, BlockId block, FieldMemory& memory) {
                  add_memory(solver.state(), graph, field, block, memory);
                });
    solver.step(HUGE_VAL);
  }));
}

struct Accesses : OfSampleRuns {};
INSTANTIATE_TEST_SUITE_P(runs, Accesses, testing::ValuesIn(sample_runs()), name_of);
INSTANTIATE_TEST_SUITE_P(listed_runs, Accesses, testing::ValuesIn(listed_runs()), name_of);

TEST_P(Accesses, of_a_step_are_declared) {
  EXPECT_EQ(undeclared<Solver>(GetParam().settled(), GetParam().middle), "");
}

// A ball of a dozen particles that falls onto a contact wall.
TEST(accesses, of_a_step_in_3D_are_declared) {
  const Case settings = tests::read_text(R"toml(dimension = 3
discretisation = { spacing = 0.2 }
time = { end = 1 }
[[body]]
name = "ball"
geometry = { shape = "ball", centre = [0, 0, 0.32], radius = 0.3 }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }
velocity = [0, 0, -1]
[[boundary]]
name = "floor"
kind = "contact_wall"
geometry = { shape = "half_space", point = [0, 0, 0], normal = [0, 0, 1] }
)toml");
  EXPECT_EQ((undeclared<remeshed::Solver<double, 3>>(settings, 3)), "");
}

TEST(accesses, of_plain_sph_are_declared) {
  const Settings coarse = {"discretisation.spacing=0.1", "time.step=1e-3",
                           "sph.artificial_stress=0.3"};
  const Case settings = small_case("tensile_instability", coarse);
  EXPECT_EQ((undeclared<sph::Solver<double, 2>>(settings, 3)), "");
}

TEST(accesses, of_the_total_lagrangian_method_are_declared) {
  const Case settings = small_case("liver_aspiration", {"discretisation.spacing=4e-3"});
  const auto accesses = undeclared_accesses([&](AccessProbe& probe) {
    total_lagrangian::Solver<double, 3> solver(settings, {.threads = 1});
    for (int step = 0; step < 3; ++step) solver.step(HUGE_VAL);
    probe.watch(solver.workers(), [&](const StepGraph&, FieldId field, BlockId block,
                                      FieldMemory& memory) {
      using total_lagrangian::Group;
      const bool are_integers = total_lagrangian::resource_numbers[field].group == Group::surface;
      for (const Region region : total_lagrangian::regions(solver.state(), field, block)) {
        add(region, !are_integers, memory);
      }
    });
    solver.step(HUGE_VAL);
  });
  EXPECT_EQ(text(accesses), "");
}

TEST(accesses, of_the_point_based_method_are_declared) {
  const Case settings = tests::read_text(R"toml(dimension = 3
method = "point_based"
[discretisation]
spacing = 0.1
[time]
end = 1
[point_based]
stiffness_damping = 1e-4
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0, 0], upper = [1, 1, 1] }
material = { model = "neo_hookean", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }
velocity = ["sin(3*y)", 0, "x"]
[[boundary]]
name = "floor"
kind = "fixed"
geometry.shape = "half_space"
geometry.point = [0, 0, 0]
geometry.normal = [0, 0, 1]
[[boundary]]
name = "air"
kind = "pressure"
geometry = { shape = "half_space", point = [0, 0, 0.5], normal = [0, 0, -1] }
pressure = 1
[[cut]]
name = "blade"
from = [0.1, -0.1, 0.45]
to = [0.1, 1.1, 0.45]
path = ["20*t", 0, 0]
end = 1
)toml");
  const auto accesses = undeclared_accesses([&](AccessProbe& probe) {
    point_based::Solver<double, 3> solver(settings, {.threads = 1});
    for (int step = 0; step < 3; ++step) solver.step(HUGE_VAL);
    probe.watch(solver.workers(),
                [&](const StepGraph&, FieldId field, BlockId block, FieldMemory& memory) {
                  for (const auto& region : point_based::regions(solver.state(), field, block)) {
                    add(region.bytes, region.are_numbers, memory);
                  }
                });
    solver.step(HUGE_VAL);
  });
  EXPECT_EQ(text(accesses), "");
}

TEST(accesses, of_finite_elements_are_declared) {
  const Settings on_mesh = {"method=finite_elements",
                            "body.beam.geometry={ shape = \"mesh\", file = \"beam.msh\" }"};
  const Case settings = small_case("cantilever", on_mesh);
  const auto accesses = undeclared_accesses([&](AccessProbe& probe) {
    finite_elements::Solver<double, 3> solver(settings, {.threads = 1});
    for (int step = 0; step < 3; ++step) solver.step(HUGE_VAL);
    probe.watch(
        solver.workers(), [&](const StepGraph&, FieldId field, BlockId block, FieldMemory& memory) {
          for (const auto& region : finite_elements::regions(solver.state(), field, block)) {
            add(region.bytes, region.are_numbers, memory);
          }
        });
    solver.step(HUGE_VAL);
  });
  EXPECT_EQ(text(accesses), "");
}

}  // namespace
}  // namespace pliant::test
