#include "engine/report/scalars.hpp"

#include <gtest/gtest.h>
#include <pliant/error.hpp>

#include <array>
#include <cmath>

namespace pliant::test {
namespace {

const std::vector<StoredField> fields = {{"body", 0, true, 4},
                                         {"density", 0, false, 8},
                                         {"stress", 6, false, 8},
                                         {"velocity", 3, false, 8}};

TEST(scalars, velocity_and_stress_come_before_the_rest_and_numbers_of_bodies_are_left_out) {
  const auto scalars = report::default_scalars(fields);
  ASSERT_EQ(scalars.size(), 3u);
  EXPECT_EQ(scalars[0].name, "velocity");
  EXPECT_EQ(scalars[1].name, "von_mises_stress");
  EXPECT_EQ(scalars[2].name, "density");
}

// Uniaxial tension s gives s, pure shear t gives sqrt(3) t, and pressure 0.
TEST(scalars, von_mises_stress_is_that_of_textbooks) {
  const auto scalar = report::scalar_named("von_mises_stress", fields);
  EXPECT_FLOAT_EQ(report::value_of(scalar, std::array{-3.F, 0.F, 0.F, 0.F, 0.F, 0.F}.data()), 3);
  EXPECT_FLOAT_EQ(report::value_of(scalar, std::array{0.F, 0.F, 0.F, 0.F, 2.F, 0.F}.data()),
                  2 * std::sqrt(3.F));
  EXPECT_FLOAT_EQ(report::value_of(scalar, std::array{5.F, 5.F, 5.F, 0.F, 0.F, 0.F}.data()), 0);
}

TEST(scalars, a_vector_is_shown_by_magnitude_or_component) {
  const std::array velocity = {3.F, -4.F, 12.F};
  EXPECT_FLOAT_EQ(report::value_of(report::scalar_named("velocity", fields), velocity.data()), 13);
  EXPECT_FLOAT_EQ(report::value_of(report::scalar_named("velocity_y", fields), velocity.data()),
                  -4);
}

TEST(scalars, an_unknown_name_is_answered_with_those_that_there_are) {
  try {
    report::scalar_named("speed", fields);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "--field speed: the result has no such field; choose one of density, "
                 "von_mises_stress, velocity, velocity_x");
  }
}

}  // namespace
}  // namespace pliant::test
