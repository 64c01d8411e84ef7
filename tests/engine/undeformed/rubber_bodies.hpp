#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/engine/finite_elements/meshed_block.hpp"
#include "tests/engine/point_based/whole_runs.hpp"

/// Cases of boxes of rubber, for all methods on the undeformed body.
namespace pliant::test {

struct UndeformedSetting {
  std::string method;
  int dimension;
};

inline std::string name_of(const UndeformedSetting& s) {
  return fmt::format("{}_{}D", s.method, s.dimension);
}

inline std::vector<UndeformedSetting> undeformed_settings() {
  return {{"total_lagrangian", 2},
          {"total_lagrangian", 3},
          {"point_based", 2},
          {"point_based", 3},
          {"finite_elements", 3}};
}

struct RubberBodies : testing::TestWithParam<UndeformedSetting> {
  TemporaryFolder folder;
  const std::string& method = GetParam().method;
  const int dimension = GetParam().dimension;

  /// A run until `end`; Young's modulus 100 Pa, Poisson's ratio 0.3, density 1 kg/m^3.
  std::string start_of(double spacing, double end) const {
    return fmt::format(R"(method = "{}"
dimension = {}
discretisation = {{ spacing = {} }}
time = {{ end = {}, step = "cfl" }}
[material.rubber]
model = "reduced_polynomial"
density = 1
coefficients = [19.2307692307692]
compressibility = 0.024
)",
                       method, dimension, spacing, end);
  }
  /// "[x, y]", or "[x, y, z]" in 3D.
  std::string list(double x, double y, double z = 0) const {
    return dimension == 2 ? fmt::format("[{}, {}]", x, y) : fmt::format("[{}, {}, {}]", x, y, z);
  }
  /// A box from (x, y) to (x + width, y + height), `depth` deep in 3D; `spacing` is for meshes.
  std::string box_of(const std::string& name, double x, double y, double width, double height,
                     double depth, double spacing) const {
    const std::string begin = fmt::format("[[body]]\nname = \"{}\"\nmaterial = \"rubber\"\n", name);
    if (method != "finite_elements") {
      return begin + fmt::format("geometry = {{ shape = \"box\", lower = {}, upper = {} }}\n",
                                 list(x, y, 0), list(x + width, y + height, depth));
    }
    const auto cells = [spacing](double length) {
      return static_cast<int>(std::lround(length / spacing));
    };
    const BlockMesh<3> mesh{
        {cells(width), cells(height), cells(depth)}, {x, y, 0}, {x + width, y + height, depth}};
    write(mesh, folder / (name + ".vtk"));
    return begin + fmt::format("geometry = {{ shape = \"mesh\", file = \"{}\" }}\n",
                               (folder / (name + ".vtk")).string());
  }
};

}  // namespace pliant::test
