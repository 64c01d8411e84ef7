#include <cmath>
#include <utility>

#include "engine/point_based/cut_faces/cut_cells.hpp"
#include "engine/point_based/cutting/body_cuts.hpp"
#include "engine/point_based/observe/opened_surface.hpp"
#include "engine/point_based/parameters.hpp"
#include "engine/point_based/surface/surface.hpp"

// Set-up of cuts.
namespace pliant::point_based {

namespace {

constexpr double advance_over_resolution = 0.125;  // least advance of a blade in one move
constexpr double longest_over_resolution = 1;      // largest one along a path that may bend
constexpr double inside_over_resolution = 1e-6;

/// Bonds to all candidates, as slots.
template <class T, int D>
BondRows rows_of(const BondChoice<D>& choice, const Body<T, D>& body) {
  BondRows rows;
  rows.first = {0};
  for (std::int64_t slot = 0; slot < body.slots; ++slot) {
    if (body.number[slot] >= 0) {
      for (const auto& candidate : choice.candidates[body.number[slot]]) {
        rows.neighbour.push_back(static_cast<std::int32_t>(choice.slot_of[candidate.node]));
      }
    }
    rows.first.push_back(static_cast<std::int64_t>(rows.neighbour.size()));
  }
  return rows;
}

template <class T, int D>
std::vector<std::int32_t> first_slots(const Body<T, D>& body) {
  std::vector<std::int32_t> first;
  first.reserve(body.blocks.size());
  for (const NodeBlock& block : body.blocks)
    first.push_back(static_cast<std::int32_t>(block.first));
  return first;
}

template <class T, int D>
std::vector<double> sizes_of(const Body<T, D>& body) {
  std::vector<double> sizes(body.slots, body.resolution);
  body.for_each_node([&](std::int64_t slot) {
    sizes[slot] = std::pow(body.mass[slot] / body.material.density, 1. / D);
  });
  return sizes;
}

}  // namespace

template <class T, int D>
BodyCuts<T, D>::BodyCuts(const Case& settings, int body_number, BondChoice<D> choice,
                         const Body<T, D>& body)
    : choice_(std::move(choice)),
      least_advance_(advance_over_resolution * body.resolution),
      longest_advance_(longest_over_resolution * body.resolution),
      bonds_(body.start, sizes_of(body), rows_of(choice_, body), parameters_of(settings).cut_rule,
             inside_of<D>(body.source->geometry, inside_over_resolution * body.resolution),
             first_slots(body)),
      blocks_(body.blocks.size()),
      surface_spacing_(settings.discretisation.spacing) {
  for (std::size_t c = 0; c < settings.cuts.size(); ++c) {
    if (settings.cuts[c].body == body_number) {
      blades_.push_back({.number = c,
                         .source = settings.cuts[c],
                         .station = {},
                         .resistance = BladeResistance<T, D>(settings.cuts[c]),
                         .target = {},
                         .puncture = {},
                         .outside = {}});
      const double threshold = settings.cuts[c].puncture_force;
      if (threshold > 0) blades_.back().puncture.emplace(body, threshold);
    }
  }
  const std::optional<double> friction = parameters_of(settings).cut_contact;
  if (friction || !body.bladed.empty()) {
    tissue_.emplace(body, inside_of<D>(body.source->geometry, 0));
  }
  if (friction) faces_.emplace(body, *friction);
}

template <class T, int D>
BodyCuts<T, D>::~BodyCuts() = default;

template <class T, int D>
const OpenedSurface<D>& BodyCuts<T, D>::opened_surface(const Body<T, D>& body) {
  if (!opened_surface_) {
    opened_surface_ = std::make_unique<OpenedSurface<D>>(
        body, surface_spacing_, [this](const MaterialPoint<D>& x) { return bonds_.is_inside(x); });
  }
  opened_surface_->follow(bonds_.cuts());
  return *opened_surface_;
}

template <class T, int D>
const CutCells<D>& BodyCuts<T, D>::cut_cells(const Body<T, D>& body) {
  if (!cut_cells_) cut_cells_ = std::make_unique<CutCells<D>>(body, surface_spacing_);
  cut_cells_->follow(bonds_.cuts());
  return *cut_cells_;
}

template BodyCuts<double, 2>::BodyCuts(const Case&, int, BondChoice<2>, const Body<double, 2>&);
template BodyCuts<double, 3>::BodyCuts(const Case&, int, BondChoice<3>, const Body<double, 3>&);
template BodyCuts<float, 2>::BodyCuts(const Case&, int, BondChoice<2>, const Body<float, 2>&);
template BodyCuts<float, 3>::BodyCuts(const Case&, int, BondChoice<3>, const Body<float, 3>&);
template BodyCuts<double, 2>::~BodyCuts();
template const OpenedSurface<2>& BodyCuts<double, 2>::opened_surface(const Body<double, 2>&);
template const CutCells<2>& BodyCuts<double, 2>::cut_cells(const Body<double, 2>&);
template BodyCuts<double, 3>::~BodyCuts();
template const OpenedSurface<3>& BodyCuts<double, 3>::opened_surface(const Body<double, 3>&);
template const CutCells<3>& BodyCuts<double, 3>::cut_cells(const Body<double, 3>&);
template BodyCuts<float, 2>::~BodyCuts();
template const OpenedSurface<2>& BodyCuts<float, 2>::opened_surface(const Body<float, 2>&);
template const CutCells<2>& BodyCuts<float, 2>::cut_cells(const Body<float, 2>&);
template BodyCuts<float, 3>::~BodyCuts();
template const OpenedSurface<3>& BodyCuts<float, 3>::opened_surface(const Body<float, 3>&);
template const CutCells<3>& BodyCuts<float, 3>::cut_cells(const Body<float, 3>&);

}  // namespace pliant::point_based
