#include "engine/report/references.hpp"

#include <gtest/gtest.h>
#include <pliant/error.hpp>

#include <cmath>
#include <fstream>

#include "tests/engine/output/temporary_folder.hpp"

namespace pliant::test {
namespace {

std::filesystem::path written(const TemporaryFolder& folder, const std::string& text) {
  std::ofstream(folder / "reference.csv") << text;
  return folder / "reference.csv";
}

TEST(references, columns_over_time_are_curves) {
  const TemporaryFolder folder;
  const auto curves = report::read_references(written(folder, "t,tip,mass\n0,1,2\n0.5,,3\n"));
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].name, "tip");
  EXPECT_EQ(curves[1].time, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(curves[1].value, (std::vector<double>{2, 3}));
  EXPECT_TRUE(std::isnan(curves[0].value[1])) << "an empty cell is no value";
}

TEST(references, columns_over_something_else_are_none) {
  const TemporaryFolder folder;
  EXPECT_TRUE(report::read_references(written(folder, "x,velocity\n0,1\n")).empty());
}

TEST(references, a_measurement_has_the_columns_that_begin_with_its_name) {
  EXPECT_TRUE(report::is_reference_of("pressure", "pressure"));
  EXPECT_TRUE(report::is_reference_of("pressure", "pressure_long_term"));
  EXPECT_FALSE(report::is_reference_of("pressure", "pressures"));
  EXPECT_FALSE(report::is_reference_of("momentum_x", "momentum"));
}

TEST(references, what_is_no_number_is_named_with_its_line) {
  const TemporaryFolder folder;
  const auto file = written(folder, "time,tip\n0,1\n1,high\n");
  try {
    report::read_references(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              file.string() + ":3: `high` is no number; a reference has numbers below its names");
  }
}

}  // namespace
}  // namespace pliant::test
