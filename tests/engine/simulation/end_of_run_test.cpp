#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "engine/simulation/methods.hpp"
#include "engine/simulation/watch.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/undeformed/loads.hpp"

// What the watch says at the end of a run: of the loads, the material, the damping and the
// precision.
namespace pliant::test {
namespace {

// What the watch says of a case that has run until this time.
std::string said_after(double time, const std::string& text) {
  const auto run = methods().make(tests::read_text(text), {});
  Watch watch(run->settings());
  watch.begin(*run);
  run->advance(time);
  return watch.observe(*run, true);
}

// A block squeezed by a fifth in this time between slip walls, which the waves cross in 0.1 s.
std::string said_of_a_block_squeezed_in(double time, const std::string& method) {
  const std::string text = fmt::format(
      "method = \"{0}\"\n{1}[time]\nend = {2}\n[material.gel]\nmodel = \"reduced_polynomial\"\n"
      "coefficients = [19.23]\ncompressibility = 0.024\ndensity = 1\n[[body]]\nname = \"block\"\n"
      "material = \"gel\"\ngeometry = {{ shape = \"box\", lower = [0, 0], upper = [1, 1] }}\n"
      "[[boundary]]\nname = \"floor\"\nkind = \"slip_wall\"\n"
      "geometry = {{ shape = \"half_space\", point = [0, 0], normal = [0, 1] }}\n"
      "[[boundary]]\nname = \"plate\"\nkind = \"slip_wall\"\ndisplacement = [0, \"-0.2*t/{2}\"]\n"
      "geometry = {{ shape = \"half_space\", point = [0, 1], normal = [0, -1] }}\n",
      method, "dimension = 2\ndiscretisation = { spacing = 0.125 }\n", time);
  return said_after(time, text);
}

TEST(watch, names_the_method_for_slow_loads_of_remeshed_bodies) {
  const std::string warning = said_of_a_block_squeezed_in(2, "remeshed");
  EXPECT_NE(warning.find("a strain of about 0.2"), warning.npos) << warning;
  EXPECT_NE(warning.find("method = \"total_lagrangian\""), warning.npos) << warning;
  EXPECT_EQ(said_of_a_block_squeezed_in(0.5, "remeshed"), "");
  EXPECT_EQ(said_of_a_block_squeezed_in(2, "total_lagrangian"), "");
}

TEST(watch, tells_of_linear_materials_that_are_neo_hookean_at_large_strains) {
  const auto said = [](const std::string& method, double part) {
    return said_after(
        1, fmt::format("method = \"{}\"\ndimension = 2\ndiscretisation = {{ spacing = 0.125 }}\n"
                       "time = {{ end = 1 }}\n[[body]]\nname = \"block\"\nmaterial = {{ model = "
                       "\"linear\", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }}\n"
                       "geometry = {{ shape = \"box\", lower = [0, 0], upper = [1, 1] }}\n"
                       "[[boundary]]\nname = \"floor\"\nkind = \"slip_wall\"\ngeometry = {{ shape "
                       "= \"half_space\", point = [0, 0], normal = [0, 1] }}\n"
                       "[[boundary]]\nname = \"plate\"\nkind = \"slip_wall\"\ndisplacement = "
                       "[0, \"-{}*t\"]\ngeometry = {{ shape = \"half_space\", point = [0, 1], "
                       "normal = [0, -1] }}\n",
                       method, part));
  };
  EXPECT_NE(said("total_lagrangian", 0.2).find("by up to 13 %"), std::string::npos)
      << said("total_lagrangian", 0.2);
  EXPECT_NE(said("point_based", 0.2).find("linear materials are neo-Hookean"), std::string::npos);
  EXPECT_EQ(said("total_lagrangian", 0.05), "");
}

// A cantilever that sinks under its weight for this time; its slowest period is 12 s.
std::string said_of_a_cantilever_after(double time, const std::string& damping) {
  const std::string text = fmt::format(
      "method = \"total_lagrangian\"\ntime.end = {}\ngravity = [0, -0.2]\n"
      "discretisation = {{ spacing = 0.2, damping = {} }}\n[[body]]\nname = \"beam\"\n"
      "geometry = {{ shape = \"box\", lower = [0, 0], upper = [4, 0.8] }}\nmaterial = {{ model = "
      "\"neo_hookean\", youngs_modulus = 100, poissons_ratio = 0.3, density = 1 }}\n"
      "[[boundary]]\nname = \"clamp\"\nkind = \"fixed\"\n"
      "geometry = {{ shape = \"half_space\", point = [0, 0], normal = [1, 0] }}\n",
      time, damping);
  return said_after(time, text);
}

TEST(watch, tells_of_damping_that_acts_in_the_end) {
  const std::string warning = said_of_a_cantilever_after(3, "\"adaptive\"");
  EXPECT_NE(warning.find("in the end the bodies still move"), warning.npos) << warning;
  const std::string late = said_of_a_cantilever_after(10, "\"adaptive\"");  // 4 % are missing
  EXPECT_NE(late.find("in the end the bodies still move"), late.npos) << late;
  EXPECT_EQ(said_of_a_cantilever_after(20, "\"adaptive\""), "");
  EXPECT_EQ(said_of_a_cantilever_after(3, "1"), "");
}

TEST(watch, tells_of_strains_that_single_precision_does_not_resolve) {
  const auto said = [](double weight, const std::string& method, const std::string& precision) {
    return said_after(
        1,
        fmt::format("method = \"{}\"\nprecision = \"{}\"\ntime.end = 1\ngravity = [0, -{}]\n"
                    "discretisation = {{ spacing = 0.05, damping = 4 }}\n[[body]]\nname = "
                    "\"block\"\ngeometry = {{ shape = \"box\", lower = [0, 0], upper = [1, 1] }}\n"
                    "material = {{ model = \"neo_hookean\", youngs_modulus = 100, poissons_ratio "
                    "= 0.3, density = 1 }}\n",
                    method, precision, weight) +
            half_space("floor", "kind = \"fixed\"", "[0, 0]", "[0, 1]"));
  };
  const std::string warning = said(2e-5, "total_lagrangian", "single");
  EXPECT_NE(warning.find("too small for single precision"), warning.npos) << warning;
  EXPECT_EQ(said(2e-5, "total_lagrangian", "double"), "");
  EXPECT_EQ(said(2e-3, "point_based", "single"), "");
  EXPECT_NE(said(2e-2, "remeshed", "single").find("several times too large"), std::string::npos);
}

}  // namespace
}  // namespace pliant::test
