#include "engine/point_based/cut_resolution.hpp"

#include <gtest/gtest.h>

#include "engine/simulation/methods.hpp"

namespace pliant::test {
namespace {

std::string said_of(const std::string& spacing, const std::string& rule) {
  const std::vector<std::string> settings = {"discretisation.spacing=" + spacing,
                                             "point_based.cut_rule=" + rule};
  return point_based::resolution_warning(read_case(PLIANT_SOURCE_DIR "/cases/edge_cut", settings));
}

// Fracture theory gives the opening; the blade goes from x = -0.05 to 0.5. With a spacing of 1/15
// the plate opens by 10 % too little, with 1/20 by 5 %; by visibility with 1/27 by 9 % too much.
TEST(resolution, of_a_cut_by_few_spacings_is_said_to_be_too_coarse) {
  EXPECT_NE(said_of("1/15", "transparency").find("the cut `blade` advances by 8.2 spacings"),
            std::string::npos);
  EXPECT_EQ(said_of("1/20", "transparency"), "");
  EXPECT_NE(said_of("1/27", "visibility").find("cut_rule = \"transparency\""), std::string::npos);
}

}  // namespace
}  // namespace pliant::test
