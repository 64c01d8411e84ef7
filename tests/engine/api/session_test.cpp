#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <pliant/pliant.hpp>
#include <string>

#include "tests/engine/api/one_thread.hpp"
#include "tests/engine/output/temporary_folder.hpp"

// Blades, loads and time budgets through the library.
namespace pliant {
namespace {

using Place = std::array<double, 3>;

/// A free block of 1 m x 0.8 m that flies to the right at 2 m/s, with a blade that callers move.
CaseFile flying_block(const std::string& method = "point_based") {
  CaseFile block;
  block.set("method", method).set("discretisation.spacing", 0.1).set("time.end", 10);
  block.set("material.rubber", R"({ model = "reduced_polynomial", density = 1000,
                                    coefficients = [5000], compressibility = 2e-5 })");
  block.add("body", "block").set("body.block.material", "rubber");
  block.set("body.block.geometry", R"({ shape = "box", lower = [0, 0], upper = [1, 0.8] })");
  block.set("body.block.velocity", {2, 0});
  block.add("boundary", "top").set("boundary.top.kind", "pressure");
  block.set("boundary.top.pressure", 0);
  block.set("boundary.top.geometry",
            R"({ shape = "half_space", point = [0, 0.6], normal = [0, -1] })");
  if (method != "point_based") return block;
  block.set("time.cfl", 0.3);  // one step for each move of a blade, every 5 ms
  block.add("cut", "scalpel").set("cut.scalpel.from", {0, 0}).set("cut.scalpel.path", {0, 0});
  block.set("cut.scalpel.start", 9).set("cut.scalpel.end", 10);
  block.add("measurement", "parts").set("measurement.parts.kind", "connected_parts");
  block.add("measurement", "largest").set("measurement.largest.kind", "largest_part_volume");
  return block;
}

/// Moves the blade upwards along the moving block, in frames `first` to `last`.
void cut(Simulation& simulation, int first, int last) {
  for (int frame = first; frame < last; ++frame) {
    const Place at = {0.75 + 2 * simulation.time(), -0.05 + 0.1 * frame, 0};
    simulation.move_blade("scalpel", at, at);
    simulation.advance(simulation.time() + 0.005);
  }
}

TEST(Session, a_blade_cuts_the_tissue_where_it_is_at_present) {
  Simulation simulation(flying_block(), one_thread());
  simulation.advance(0.2);  // by then the block has left its initial place
  cut(simulation, 0, 10);
  EXPECT_EQ(2, simulation.measurement("parts"));
  EXPECT_NEAR(0.8 * 0.75, simulation.measurement("largest"), 1e-6);
}

TEST(Session, a_blade_that_was_lifted_leaves_what_lies_between_two_cuts_whole) {
  Simulation simulation(flying_block(), one_thread());
  cut(simulation, 0, 4);
  simulation.lift_blade("scalpel");
  cut(simulation, 7, 10);
  EXPECT_EQ(1, simulation.measurement("parts"));
  simulation.lift_blade("scalpel");
  cut(simulation, 3, 8);
  EXPECT_EQ(2, simulation.measurement("parts"));
}

TEST(Session, tells_the_force_of_a_blade) {
  CaseFile block = flying_block();
  block.set("cut.scalpel.resistance", 10);
  Simulation simulation(block, one_thread());
  EXPECT_EQ(0, simulation.blade_force("scalpel")[1]);
  double largest = 0;
  for (int frame = 0; frame < 10; ++frame) {
    cut(simulation, frame, frame + 1);
    largest = std::max(largest, simulation.blade_force("scalpel")[1]);
  }
  EXPECT_NEAR(10, largest, 0.1);
  EXPECT_THROW(simulation.blade_force("knife"), InputError);
}

TEST(Session, that_is_played_again_gives_the_same_bits) {
  for (const std::string method : {"point_based", "remeshed"}) {
    Simulation simulation(flying_block(method), one_thread());
    simulation.step();
    simulation.step();
    simulation.advance(0.013);
    simulation.set_pressure("top", 400);
    for (int frame = 1; frame < 5; ++frame) simulation.advance(0.013 + 0.01 * frame, 1e-9);
    if (method == "point_based") cut(simulation, 0, 8);
    const test::TemporaryFolder folder;
    write_inputs(folder / "session.csv", simulation.session());
    SimulationOptions options;
    options.threads = 2;
    Simulation again(flying_block(method), options);
    again.play(read_inputs(folder / "session.csv"));
    EXPECT_EQ(simulation.time(), again.time()) << method;
    EXPECT_EQ(simulation.positions(0), again.positions(0)) << method;
  }
}

TEST(Session, continues_in_the_middle_of_a_cut_to_the_same_bits) {
  const test::TemporaryFolder folder;
  Simulation whole(flying_block(), one_thread()), restored(flying_block(), one_thread());
  cut(whole, 0, 4);
  const Place next = {0.75 + 2 * whole.time(), 0.35, 0};
  whole.move_blade("scalpel", next, next);  // the next step has not seen this yet
  whole.save(folder / "state.h5");
  restored.restore(folder / "state.h5");
  EXPECT_TRUE(restored.session().empty());
  for (Simulation* simulation : {&whole, &restored}) cut(*simulation, 5, 10);
  EXPECT_EQ(whole.positions(0), restored.positions(0));
  EXPECT_EQ(2, restored.measurement("parts"));
}

TEST(Session, inputs_wait_for_their_time) {
  Simulation at_hand(flying_block(), one_thread()), waiting(flying_block(), one_thread());
  waiting.enter({.kind = Input::Kind::pressure, .time = 0.02, .name = "top", .value = 500});
  waiting.enter({.kind = Input::Kind::pressure, .time = 0.01, .name = "top", .value = 300});
  waiting.advance(0.04);
  at_hand.advance(0.01);
  at_hand.set_pressure("top", 300);
  at_hand.advance(0.02);
  at_hand.set_pressure("top", 500);
  at_hand.advance(0.04);
  EXPECT_EQ(at_hand.positions(0), waiting.positions(0));
}

TEST(Session, an_advance_that_has_no_time_takes_one_step_and_tells_what_it_put_off) {
  Simulation simulation(flying_block(), one_thread());
  const Progress late = simulation.advance(0.1, 0);
  EXPECT_EQ(1, late.steps);
  EXPECT_EQ(0.1 - simulation.time(), late.lag);
  EXPECT_GT(late.lag, 0);
  const Progress whole = simulation.advance(0.1, 1e6);
  EXPECT_GT(whole.steps, 1);
  EXPECT_EQ(0, whole.lag);
  EXPECT_GT(whole.wall_time, 0);
  EXPECT_EQ(0.1, simulation.time());
}

std::string complaint_about(const std::string& text) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "session.csv") << text;
  try {
    read_inputs(folder / "session.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Session, a_bad_row_is_refused_with_its_line) {
  const std::string header = "time,input,name,x1,y1,z1,x2,y2,z2\n";
  const auto holds = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(holds(complaint_about("t,what\n"), "session.csv:1: not a session"));
  EXPECT_TRUE(holds(complaint_about(header + "0,press,top,1\n"), ":2: unknown input `press`"));
  EXPECT_TRUE(holds(complaint_about(header + "0,pressure,top,much\n"),
                    ":2: column 4 must be a number, got `much`"));
  EXPECT_TRUE(holds(complaint_about(header + "0,lift,\n"), ":2: `lift` lacks a name"));
  EXPECT_TRUE(holds(complaint_about(header + "1,lift,a\n0,lift,a\n"),
                    ":3: t = 0 comes after t = 1; sort the rows by time"));
}

TEST(Session, inputs_that_a_case_cannot_take_are_refused) {
  Simulation simulation(flying_block(), one_thread());
  EXPECT_THROW(simulation.move_blade("knife", {}, {}), InputError);
  EXPECT_THROW(simulation.enter({.kind = Input::Kind::lift, .time = 1, .name = "knife"}),
               InputError);
  EXPECT_TRUE(simulation.session().empty());
}

TEST(Session, what_would_never_come_is_refused) {
  constexpr double never = HUGE_VAL, nothing = NAN;
  Simulation simulation(flying_block(), one_thread());
  EXPECT_THROW(simulation.advance(nothing), InputError);
  EXPECT_THROW(simulation.advance(never), InputError);
  EXPECT_THROW(simulation.advance(0.1, nothing), InputError);
  EXPECT_EQ(simulation.advance(never, 0).steps, 1);
  EXPECT_THROW(simulation.set_pressure("top", nothing), InputError);
  EXPECT_THROW(simulation.move_blade("scalpel", {0, never, 0}, {}), InputError);
  EXPECT_THROW(simulation.enter({.kind = Input::Kind::lift, .time = nothing, .name = "scalpel"}),
               InputError);
}

}  // namespace
}  // namespace pliant
