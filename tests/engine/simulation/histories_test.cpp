#include "engine/simulation/histories.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/case/vocabulary/measurement_kinds.hpp"
#include "engine/simulation/schedule.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

using Quantity = MeasurementCase::Kind;

/// A mass, the mass relative to its start, a tip, and the period of the tip.
struct MeasuredHistories : testing::Test {
  Case settings;
  static constexpr double period = 0.8;
  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

  MeasuredHistories() {
    const auto add = [&](const char* name, Quantity kind, bool relative, int of) {
      MeasurementCase m;
      m.name = name;
      m.kind = kind;
      m.relative = relative;
      m.of = of;
      settings.measurements.push_back(m);
    };
    add("mass", Quantity::mass, false, -1);
    add("mass_ratio", Quantity::mass, true, -1);
    add("period", Quantity::period, false, 3);  // before the measurement that it reads
    add("tip", Quantity::point_displacement, false, -1);
  }

  static void extend(Histories& record, int from, int to) {
    for (int i = from; i < to; ++i) {
      const double t = 0.01 * i, mass = 4 + t;
      record.add(t, {mass, mass, nothing, std::cos(2 * std::acos(-1.0) * t / period)});
    }
  }
};

TEST_F(MeasuredHistories, complete_what_depends_on_the_past) {
  Histories record(settings);
  EXPECT_TRUE(record.empty());
  extend(record, 0, 20);
  EXPECT_TRUE(std::isnan(record.last(2))) << "before the first crossing";
  extend(record, 20, 151);
  EXPECT_EQ(record.last_time(), 1.5);
  EXPECT_EQ(record.last(0), 5.5);
  EXPECT_EQ(record.last(1), 5.5 / 4);
  EXPECT_NEAR(record.last(2), period, 1e-4);  // error of a chord: 0.07 w^2 dt^3
}

TEST_F(MeasuredHistories, know_extremes_values_at_times_and_sums) {
  const auto add = [&](const char* name, Quantity kind) -> MeasurementCase& {
    MeasurementCase& m = settings.measurements.emplace_back();
    m.name = name;
    m.kind = kind;
    m.of = 3;
    return m;
  };
  add("lowest", Quantity::smallest);
  add("highest", Quantity::largest);
  add("then", Quantity::value_at_time).time = 0.105;
  add("late", Quantity::value_at_time).time = 9;
  MeasurementCase& sum = add("sum", Quantity::weighted_sum);
  sum.of = -1;
  sum.terms = {0, 3};
  sum.factors = {2, -3};
  Histories record(settings);
  for (int i = 0; i <= 20; ++i) {
    const double x = i - 8;  // a parabola, and missing values
    const double tip = i == 3 ? nothing : x * x;
    record.add(0.01 * i, {5, 5, nothing, tip, nothing, nothing, nothing, nothing, nothing});
  }
  EXPECT_EQ(record.last(4), 0);
  EXPECT_EQ(record.last(5), 144);
  EXPECT_NEAR(record.last(6), (4 + 9) / 2., 1e-12);
  EXPECT_TRUE(std::isnan(record.last(7)));
  EXPECT_EQ(record.why_missing(7), "the samples do not reach the time");
  EXPECT_EQ(record.last(8), 2 * 5 - 3 * 144);
}

TEST_F(MeasuredHistories, go_on_alike_after_a_checkpoint) {
  const TemporaryFolder folder;
  Histories whole(settings), restored(settings);
  extend(whole, 0, 70);
  ArchiveWriter writer(folder / "histories.h5");
  whole.put(writer);
  writer.commit();
  restored.get(ArchiveReader(folder / "histories.h5"));
  for (Histories* each : {&whole, &restored}) extend(*each, 70, 151);
  for (std::size_t m = 0; m < settings.measurements.size(); ++m) {
    EXPECT_EQ(restored.last(m), whole.last(m)) << settings.measurements[m].name;
  }
}

TEST_F(MeasuredHistories, say_why_there_is_no_value) {
  Histories record(settings);
  record.add(0, {0, 0, nothing, nothing});
  EXPECT_EQ(record.why_missing(0), "");
  EXPECT_EQ(record.why_missing(1), "the value at the start is zero");
  EXPECT_EQ(record.why_missing(2),
            "measurement `tip` has none: no particles that started around the point remain");
  EXPECT_EQ(record.why_missing(3), "no particles that started around the point remain");
  record.add(1, {0, 0, nothing, 1});
  EXPECT_EQ(record.why_missing(2), "the measurement crosses its mean level less than twice");
}

TEST_F(MeasuredHistories, forces_are_what_impulses_change_by) {
  settings.measurements.resize(2);
  settings.measurements[0].kind = Quantity::wall_force;
  settings.measurements[1] = settings.measurements[0];
  settings.measurements[1].kind = Quantity::contact_force;
  Histories record(settings);
  record.add(0, {3, 0});
  EXPECT_EQ(record.last(0), 0);
  record.add(0.5, {4, -1});
  EXPECT_EQ(record.last(0), 2);
  EXPECT_EQ(record.last(1), -2);
}

TEST_F(MeasuredHistories, values_have_the_units_of_what_is_measured) {
  MeasurementCase m;
  m.kind = Quantity::momentum;
  Case plane, space;
  space.dimension = 3;
  EXPECT_EQ(unit_of(plane, m), "kg m/s/m");
  EXPECT_EQ(unit_of(space, m), "kg m/s");
  m.relative = true;
  EXPECT_EQ(unit_of(plane, m), "1");
  m.relative = false;
  m.kind = Quantity::point_value;
  for (const auto& [field, unit] :
       {std::pair{"pressure", "Pa"}, std::pair{"stress_xy", "Pa"}, std::pair{"density", "kg/m^3"},
        std::pair{"velocity_x", "m/s"}, std::pair{"displacement_y", "m"}}) {
    m.field = field;
    EXPECT_EQ(unit_of(plane, m), unit) << field;
  }
  MeasurementCase force;
  m.of = 0;
  m.kind = Quantity::peak_moving_average;
  for (const Quantity kind : {Quantity::wall_force, Quantity::contact_force}) {
    force.kind = kind;
    space.measurements = {force};
    EXPECT_EQ(unit_of(space, m), "N") << "a mean has the unit of what it is the mean of";
  }
  m.kind = Quantity::last_time_above;
  EXPECT_EQ(unit_of(space, m), "s");
}

TEST(schedule, follows_from_the_time_alone_where_it_passes_several_instants) {
  Schedule all(0.1), from_the_middle(0.1);
  from_the_middle.passed(0.47);
  for (const double time : {0.05, 0.12, 0.47, 0.49, 0.5, 0.93}) {
    const bool passed = all.passed(time);
    EXPECT_EQ(passed, time != 0.05 && time != 0.49) << time;
    if (time > 0.47) {
      EXPECT_EQ(from_the_middle.passed(time), passed) << time;
    }
  }
  EXPECT_FALSE(Schedule(0).passed(1e9));
}

TEST(samples, matter_to_means_and_histories) {
  const std::string block = R"(dimension = 2
discretisation = { spacing = 0.1 }
time = { end = 2 }
[[body]]
name = "block"
material = { model = "linear", density = 1, youngs_modulus = 100, poissons_ratio = 0.3 }
geometry = { shape = "box", lower = [0, 0], upper = [1, 1] }
[[measurement]]
name = "mass"
kind = "mass"
)";
  EXPECT_FALSE(depends_on_samples(tests::read_text(block)));
  EXPECT_TRUE(depends_on_samples(tests::read_text(block + R"([[measurement]]
name = "most"
kind = "largest"
of = "mass"
)")));
  EXPECT_TRUE(depends_on_samples(tests::read_text(block + R"([[boundary]]
name = "floor"
kind = "fixed"
geometry = { shape = "half_space", point = [0, 0], normal = [0, 1] }
[[measurement]]
name = "force"
kind = "wall_force"
boundary = "floor"
)")));
}

}  // namespace
}  // namespace pliant::test
