#include "engine/simulation/examine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/finite_elements/solver.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/method/decompositions.hpp"
#include "engine/point_based/solver.hpp"

namespace pliant {

namespace {

/// By the theorem of Gauss.
template <int D>
double enclosed_volume(const point_based::BodySurface<D>& surface) {
  double sum = 0;
  for (const auto& facet : surface.facet) {
    std::array<Point<D>, D> corner;
    Point<D> middle = {};
    for (int v = 0; v < D; ++v) {
      corner[v] = surface.start[facet[v]];
      for (int a = 0; a < D; ++a) middle[a] += corner[v][a] / D;
    }
    const Point<D> area = undeformed::area_vector<D>(corner);
    for (int a = 0; a < D; ++a) sum += area[a] * middle[a] / D;
  }
  return sum;
}

/// The largest eigenvalue over the least; 0 of no matrix.
template <int D>
double condition_of(const point_based::Body<double, D>& body, std::int64_t slot) {
  Eigen::Matrix<double, D, D> moment;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      moment(i, j) = body.moment[kernels::symmetric_index<D>(i, j)][slot];
    }
  }
  const auto values = eigenvalues<D>(moment);
  const double most = values[D - 1];
  return most > 0 ? most / std::max(values[0], 1e-16 * most) : 0;
}

template <int D>
ExaminedBody examine_body(const point_based::Body<double, D>& body) {
  ExaminedBody found;
  found.name = body.name;
  found.nodes = body.particles;
  found.volume = body.volume_at_rest;
  found.enclosed_volume = enclosed_volume<D>(body.surface);
  body.for_each_node([&](std::int64_t slot) {
    const double condition = condition_of<D>(body, slot);
    if (condition <= found.condition) return;
    found.condition = condition;
    found.worst = padded<D>(body.start[slot]);
  });
  for (const auto& of_block : body.degenerate) {
    found.degenerate += static_cast<std::int64_t>(of_block.size());
  }
  return found;
}

template <class Solver>
Examined examine_with(Case a_case) {
  a_case.precision = Precision::binary64;
  const Solver solver(a_case, {.threads = 1});
  Examined found;
  for (const auto& body : solver.state().bodies) found.bodies.push_back(examine_body(body));
  found.time_step = solver.time_step();
  return found;
}

}  // namespace

std::string ExaminedBody::text() const {
  std::string line =
      fmt::format("nodes: {} in body \"{}\", their volumes {:+.2g} % off the enclosed volume",
                  nodes, name, 100 * volume_error());
  if (condition > 0) {
    line += fmt::format(", worst condition of neighbours {:.3g} at ({:.4g}, {:.4g}, {:.4g})",
                        condition, worst[0], worst[1], worst[2]);
  }
  if (degenerate > 0) {
    line += fmt::format(", {} with neighbours on a plane or a line only", degenerate);
  }
  return line;
}

std::optional<Examined> examine(const Case& a_case) {
  if (a_case.method == "point_based") {
    return a_case.dimension == 2 ? examine_with<point_based::Solver<double, 2>>(a_case)
                                 : examine_with<point_based::Solver<double, 3>>(a_case);
  }
  if (a_case.method == "finite_elements") {
    return examine_with<finite_elements::Solver<double, 3>>(a_case);
  }
  return std::nullopt;
}

}  // namespace pliant
