#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "engine/finite_elements/regions.hpp"
#include "engine/finite_elements/solver.hpp"
#include "engine/point_based/regions.hpp"
#include "engine/point_based/solver.hpp"
#include "engine/remeshed/setup/regions.hpp"
#include "engine/remeshed/state/resources.hpp"
#include "engine/sph/solver.hpp"
#include "engine/total_lagrangian/regions.hpp"
#include "engine/total_lagrangian/solver.hpp"
#include "scheduler/access_check.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/invariants/sample_runs.hpp"

// Phases declare all that they read and write: this orders the graph, and in several processes
// would determine what to send.
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

/// Groups whose memory holds integers, which cannot be perturbed.
constexpr std::array integers = {
    Group::kinds,           Group::image_sources, Group::fits,     Group::contact_points,
    Group::neighbour_lists, Group::new_kinds,     Group::new_fits, Group::used,
    Group::surface_packs,   Group::record_numbers};

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

bool has_phase(const StepGraph& graph, std::string_view name) {
  return std::ranges::any_of(graph.phases(),
                             [name](const auto& phase) { return phase.name == name; });
}

/// Whether a group belongs to the new lattice of a remeshing.
bool is_new(Group group) { return group >= Group::new_state && group != Group::particle_counts; }

/// Memory of the graphs of steps, whose blocks are those of the present lattice.
template <int D>
void add_memory(remeshed::State<double, D>& state, const StepGraph& graph, FieldId field,
                BlockId block, FieldMemory& memory) {
  const bool is_of_remeshing =
      has_phase(graph, "remesh: layout") || has_phase(graph, "remesh: kinds");
  const Group group = remeshed::resource_numbers[field].group;
  if (!is_of_remeshing && !is_new(group)) {
    add(remeshed::regions(state, field, block), group, memory);
  }
}

/// Memory of the two graphs of a remeshing. The blocks of the second graph are those of the new
/// lattice, to which the old blocks are assigned round-robin. The stages of a step have no meaning
/// then, and the second graph has taken the lists of ghosts.
template <int D>
void add_memory_of_remeshing(remeshed::State<double, D>& state, const StepGraph& graph,
                             FieldId field, BlockId block, FieldMemory& memory) {
  const auto [group, copy, part] = remeshed::resource_numbers[field];
  const bool is_second = has_phase(graph, "remesh: kinds");
  if (!is_second && !has_phase(graph, "remesh: layout")) return;
  if (is_new(group)) {
    if (is_second) add(remeshed::regions(state, field, block), group, memory);
    return;
  }
  constexpr std::array old_state = {Group::kinds,    Group::drift,     Group::velocity,
                                    Group::material, Group::constants, Group::memory};
  const bool is_gone = is_second && std::ranges::find(old_state, group) == old_state.end();
  if (copy != 0 || is_gone) return;
  int old_blocks = 0;
  for (const auto& body : state.bodies) {
    old_blocks += static_cast<int>(body.population.layout.blocks().size());
  }
  for (int b = block; b < old_blocks; b += graph.blocks().count()) {
    add(remeshed::regions(state, field, b), group, memory);
  }
}

std::string text(const std::vector<scheduler::UndeclaredAccess>& accesses) {
  std::string lines;
  for (const auto& access : accesses) lines += text(access) + '\n';
  return lines;
}

/// Undeclared accesses in the last of `steps` steps.
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

/// Number of steps to the end of the first remeshing after the start.
int steps_to_remeshing(const Case& settings) {
  Solver solver(settings, {.threads = 1});
  int steps = 0;
  for (const auto start = solver.remeshings(); solver.remeshings() == start; ++steps) {
    solver.step(HUGE_VAL);
  }
  return steps;
}

struct Accesses : OfSampleRuns {};
INSTANTIATE_TEST_SUITE_P(runs, Accesses, testing::ValuesIn(sample_runs()), name_of);
INSTANTIATE_TEST_SUITE_P(listed_runs, Accesses, testing::ValuesIn(listed_runs()), name_of);

TEST_P(Accesses, of_a_step_are_declared) {
  EXPECT_EQ(undeclared<Solver>(GetParam().settled(), GetParam().middle), "");
}

/// Free surfaces, walls, periods and contact, with a few blocks each and a remeshing in the second
/// step.
std::vector<SampleRun> remeshed_runs() {
  const Settings disc = {"discretisation.spacing=0.1", "time.step=1e-3", "remeshing.every=2",
                         "remeshing.filter=0.2"};
  const Settings block = {"discretisation.spacing=1/8", "time.step=1e-4", "remeshing.every=2"};
  const Settings cell = {"discretisation.spacing=1/16", "remeshing.every=2"};
  const Settings ball = {
      "dimension=2",
      "discretisation.spacing=0.05",
      "time.step=5e-4",
      "remeshing.every=2",
      "body.ball.geometry={ shape = \"disc\", centre = [0, 0.28], radius = 0.28 }",
      "body.ball.velocity=[0, -1]",
      "boundary.wall.geometry={ shape = \"half_space\", point = [0, 0], normal = [0, 1] }",
      "measurement.height.point=[0, 0.25]",
      "measurement.height.direction=[0, 1]"};
  const Settings discs = {"discretisation.spacing=0.1", "time.step=2e-3", "remeshing.every=2"};
  return {{"disc", "rotating_cylinder", disc, 0},
          {"compression", "compression_hyperelastic", block, 0},
          {"periodic", "periodic_square", cell, 0},
          {"contact_wall", "bouncing_ball", ball, 0},
          {"two_discs", "two_discs", discs, 0}};
}

struct RemeshingAccesses : OfSampleRuns {};
INSTANTIATE_TEST_SUITE_P(runs, RemeshingAccesses, testing::ValuesIn(remeshed_runs()), name_of);

TEST_P(RemeshingAccesses, are_declared) {
  const Case settings = GetParam().settled();
  const int steps = steps_to_remeshing(settings);
  const auto accesses = undeclared_accesses([&](AccessProbe& probe) {
    Solver solver(settings, {.threads = 1});
    for (int step = 1; step < steps; ++step) solver.step(HUGE_VAL);
    probe.watch(solver.workers(),
                [&](const StepGraph& graph, FieldId field, BlockId block, FieldMemory& memory) {
                  add_memory_of_remeshing(solver.state(), graph, field, block, memory);
                });
    solver.step(HUGE_VAL);
  });
  EXPECT_EQ(text(accesses), "");
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
material = { model = "reduced_polynomial", coefficients = [20], compressibility = 0.02, density = 2, prony_shear = { ratios = [0.5], times = [0.01] } }
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
