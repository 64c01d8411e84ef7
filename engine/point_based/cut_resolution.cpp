#include "engine/point_based/cut_resolution.hpp"

#include <fmt/format.h>

#include <cmath>

#include "engine/case/blade_track.hpp"
#include "engine/point_based/parameters.hpp"

namespace pliant::point_based {

namespace {

// What docs/validation/robustness.py finds on cut plates: with 10 spacings the mouth is 5 % too
// narrow, with 8 by 10 %. Without the bonds that a cut crosses it is 25 % too wide with 10, and 9 %
// with 14.
double least_spacings(CutRule rule) { return rule == CutRule::visibility ? 20 : 10; }

double length_of(const CutCase& cut) {
  const Vector start = edge_of(cut, cut.start).from, end = edge_of(cut, cut.end).from;
  return std::hypot(end[0] - start[0], end[1] - start[1], end[2] - start[2]);
}

}  // namespace

std::string resolution_warning(const Case& settings) {
  const CutRule rule = parameters_of(settings).cut_rule;
  for (const CutCase& cut : settings.cuts) {
    if (!moves_in_run(cut, settings)) continue;
    const double spacings = length_of(cut) / settings.discretisation.spacing;
    if (!(spacings < least_spacings(rule))) continue;
    return fmt::format(
        "warning: the cut `{}` advances by {:.2g} spacings only, so that it opens by 5 to 25 % too "
        "little or too much; use a finer spacing (discretisation.spacing below {:.3g}){}",
        cut.name, spacings, length_of(cut) / least_spacings(rule),
        rule == CutRule::visibility ? ", or point_based.cut_rule = \"transparency\"" : "");
  }
  return "";
}

}  // namespace pliant::point_based
