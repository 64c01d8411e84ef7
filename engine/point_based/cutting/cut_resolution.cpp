#include "engine/point_based/cutting/cut_resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/boundaries/rigid_motion.hpp"
#include "engine/case/blade_track.hpp"
#include "engine/case/checks/resolution.hpp"
#include "engine/lattice/point_algebra.hpp"
#include "engine/point_based/parameters.hpp"

namespace pliant::point_based {

namespace {

// Results of docs/validation/robustness.py for cut plates: with 10 spacings the mouth is 5 % too
// narrow, with 8 by 10 %. If bonds are severed at once (visibility), it is 25 % too wide with 10,
// and 9 % with 14.
double least_advance(CutRule rule) { return rule == CutRule::visibility ? 20 : 10; }

double distance(const Vector& a, const Vector& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

/// Largest distance of the blade from its start, over the ends of its edge.
double length_of(const CutCase& cut) {
  const std::vector<BladeEdge> path = edges_along_path(cut);
  const BladeEdge& start = path.front();
  double farthest = 0;
  for (const BladeEdge& edge : path) {
    farthest = std::max({farthest, distance(start.from, edge.from), distance(start.to, edge.to)});
  }
  return farthest;
}

/// Whether the blade moves along the line of its edge only, in 3D, so that it sweeps no surface.
bool moves_along_its_edge(const CutCase& cut) {
  constexpr double little = 1e-6;  // sine of the angle between the motion and the edge
  const std::vector<BladeEdge> path = edges_along_path(cut);
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const BladeEdge &edge = path[k], &next = path[k + 1];
    const Vector along = difference<3>(edge.to, edge.from);
    for (const auto& [from, to] : {std::pair{edge.from, next.from}, std::pair{edge.to, next.to}}) {
      const Vector way = difference<3>(to, from), normal = pliant::cross(along, way);
      if (dot<3>(normal, normal) > little * little * dot<3>(along, along) * dot<3>(way, way)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

void warn_of_coarse_cuts(const Case& settings, std::vector<std::string>& warnings) {
  const CutRule rule = parameters_of(settings).cut_rule;
  if (rule == CutRule::product && !settings.cuts.empty()) {
    warnings.emplace_back(
        "the cut rule \"product\" leaves up to 1 % of some bonds that a cut crosses; a complete "
        "cut "
        "may not divide the body; take point_based.cut_rule = \"transparency\" where parts matter");
  }
  for (const CutCase& cut : settings.cuts) {
    if (!moves_in_run(cut, settings)) continue;
    if (settings.dimension == 3 && length_of(cut) > 0 && moves_along_its_edge(cut)) {
      warnings.push_back(fmt::format(
          "the blade of cut `{}` moves along its own edge only, so that it cuts nothing; give a "
          "path across the edge",
          cut.name));
      continue;
    }
    const Resolution resolution = resolution_of(settings, settings.bodies[cut.body]);
    const double advance = length_of(cut) / resolution.size;
    if (!(advance < least_advance(rule))) continue;
    if (advance == 0) {
      warnings.push_back(fmt::format(
          "the blade of cut `{}` stays where it starts, so that it cuts nothing; give a "
          "path that depends on t",
          cut.name));
      continue;
    }
    warnings.push_back(fmt::format(
        "the cut `{}` advances by {:.2g} {} only, so that it opens by 5 to 25 % too little or too "
        "much; {}{}",
        cut.name, advance, resolution.units(),
        resolution.remedy(length_of(cut) / least_advance(rule)),
        rule == CutRule::visibility ? ", or point_based.cut_rule = \"transparency\"" : ""));
  }
}

}  // namespace pliant::point_based
