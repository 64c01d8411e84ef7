#include "engine/point_based/cut_resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/case/blade_track.hpp"
#include "engine/point_based/parameters.hpp"

namespace pliant::point_based {

namespace {

// What docs/validation/robustness.py finds on cut plates: with 10 spacings the mouth is 5 % too
// narrow, with 8 by 10 %. Without the bonds that a cut crosses it is 25 % too wide with 10, and 9 %
// with 14.
double least_spacings(CutRule rule) { return rule == CutRule::visibility ? 20 : 10; }

double distance(const Vector& a, const Vector& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

/// How far the end of an edge goes that goes farther.
double length_of(const CutCase& cut) {
  const BladeEdge start = edge_of(cut, cut.start), end = edge_of(cut, cut.end);
  return std::max(distance(start.from, end.from), distance(start.to, end.to));
}

}  // namespace

std::string resolution_warning(const Case& settings) {
  const CutRule rule = parameters_of(settings).cut_rule;
  for (const CutCase& cut : settings.cuts) {
    if (!moves_in_run(cut, settings)) continue;
    const double spacings = length_of(cut) / settings.discretisation.spacing;
    if (!(spacings < least_spacings(rule))) continue;
    if (spacings == 0) {
      return fmt::format(
          "warning: the blade of cut `{}` ends where it starts, so that it may cut nothing; give a "
          "path that depends on t",
          cut.name);
    }
    return fmt::format(
        "warning: the cut `{}` advances by {:.2g} spacings only, so that it opens by 5 to 25 % too "
        "little or too much; use a finer spacing (discretisation.spacing below {:.3g}){}",
        cut.name, spacings, length_of(cut) / least_spacings(rule),
        rule == CutRule::visibility ? ", or point_based.cut_rule = \"transparency\"" : "");
  }
  return "";
}

}  // namespace pliant::point_based
