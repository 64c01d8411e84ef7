#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/finite_elements/solver.hpp"
#include "tests/engine/case/written_case.hpp"
#include "tests/engine/output/temporary_folder.hpp"

/// Blocks of tetrahedra, in 2D of triangles, for the methods on such meshes.
namespace pliant::test {

/// A lattice of cells whose inner corners are displaced by up to `jitter` cells.
template <int D>
struct BlockMesh {
  std::array<int, D> cells;
  Point<D> lower, upper;
  double jitter = 0.2;
  double grading =
      1;  ///< exponent of the places from lower to upper: above 1, cells are small at the lower end
};

/// Writes the mesh as a legacy VTK file: each cell is divided into D! elements along its diagonal
/// (Kuhn).
template <int D>
void write(const BlockMesh<D>& mesh, const std::filesystem::path& path) {
  std::ofstream file(path);
  file.precision(17);
  Cell<D> last, strides;
  std::int64_t points = 1, all_cells = 1;
  for (int a = 0; a < D; ++a) {
    last[a] = mesh.cells[a];
    strides[a] = static_cast<std::int32_t>(points);
    points *= mesh.cells[a] + 1;
    all_cells *= mesh.cells[a];
  }
  file << "# vtk DataFile Version 3.0\nblock\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " << points
       << " double\n";
  std::vector<std::array<double, 3>> places(points);
  for_each_cell<D>({}, last, [&](const Cell<D>& cell) {
    std::int64_t number = 0;
    bool inside = true;
    for (int a = 0; a < D; ++a) {
      number += strides[a] * cell[a];
      inside = inside && cell[a] > 0 && cell[a] < mesh.cells[a];
    }
    for (int a = 0; a < D; ++a) {
      const double moved = inside ? mesh.jitter * std::sin(91. * number + 37. * a) : 0;
      const double share = std::pow((cell[a] + moved) / mesh.cells[a], mesh.grading);
      places[number][a] = mesh.lower[a] + (mesh.upper[a] - mesh.lower[a]) * share;
    }
  });
  for (const auto& x : places) file << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
  constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  constexpr int count = D == 2 ? 2 : 6;
  file << "CELLS " << count * all_cells << ' ' << count * all_cells * (D + 2) << '\n';
  for (int a = 0; a < D; ++a) --last[a];
  for_each_cell<D>({}, last, [&](const Cell<D>& cell) {
    for (int e = 0; e < count; ++e) {
      const int* const order = orders[D == 2 ? 5 * e : e];
      std::int64_t number = 0;
      for (int a = 0; a < D; ++a) number += strides[a] * cell[a];
      std::array<std::int64_t, D + 1> corner = {number};
      for (int a = 0; a < D; ++a) corner[a + 1] = number += strides[order[a]];
      const bool is_turned = D == 2 ? e == 1 : e >= 3;
      if (is_turned) std::swap(corner[D - 1], corner[D]);
      file << D + 1;
      for (const std::int64_t c : corner) file << ' ' << c;
      file << '\n';
    }
  });
  file << "CELL_TYPES " << count * all_cells << '\n';
  for (std::int64_t e = 0; e < count * all_cells; ++e) file << (D == 2 ? 5 : 10) << '\n';
}

/// A case with that mesh, which tests extend.
inline std::string meshed_block(const std::filesystem::path& mesh) {
  return tests::rubber_case("finite_elements", 3, "0.125", "1, step = \"cfl\"") + R"([[body]]
name = "block"
material = "rubber"
geometry = { shape = "mesh", file = ")" +
         mesh.string() + "\" }\n";
}

/// Reads a case with a mesh. Meshes in case files are 3D only: for triangles, the dimension and the
/// file are changed afterwards.
template <int D>
Case read_meshed(const std::string& text, const std::filesystem::path& mesh,
                 const std::vector<std::string>& settings) {
  if constexpr (D == 3) {
    return tests::read_text(text, settings);
  } else {
    std::filesystem::path solid = mesh;
    solid.replace_extension(".3d.vtk");
    write(BlockMesh<3>{{1, 1, 1}, {0, 0, 0}, {1, 1, 1}}, solid);
    Case a_case = tests::read_text(tests::with(text, mesh.string(), solid.string()), settings);
    a_case.dimension = 2;
    a_case.bodies[0].geometry.file = mesh.string();
    return a_case;
  }
}

/// A block [0, 1]^D of irregular elements.
template <int D>
BlockMesh<D> unit_block(int cells) {
  BlockMesh<D> mesh;
  mesh.cells.fill(cells);
  mesh.lower.fill(0);
  mesh.upper.fill(1);
  return mesh;
}

template <int D>
using ElementSolver = finite_elements::Solver<double, D>;

}  // namespace pliant::test
