#include "engine/case/checks/thickness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/case/attached_walls.hpp"
#include "engine/case/checks/probes.hpp"
#include "engine/case/checks/resolution.hpp"
#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/geometry/climb.hpp"
#include "engine/geometry/is_round.hpp"
#include "engine/geometry/reentrant_corner.hpp"
#include "engine/geometry/signed_distance.hpp"

namespace pliant {

namespace {

constexpr int climbers = 8;  // a search for a maximum starts at the best probes

/// The length of a body along the axis along which it is longest.
double length_of(const BodyCase& body, int dimension) {
  const Box<3> box = bounding_box(body.geometry);
  const double step = step_of_probes(box, dimension);
  if (!std::isfinite(step)) return std::numeric_limits<double>::infinity();
  Box<3> inside;
  for (const Vector& x : middles(box, dimension, step)) {
    if (signed_distance(body.geometry, x, dimension) < 0) inside.grow(x);
  }
  double length = 0;
  for (int a = 0; a < dimension; ++a) {
    const double size = box.upper[a] - box.lower[a], cell = size / std::ceil(size / step);
    length = std::max(length, inside.upper[a] - inside.lower[a] + cell);
  }
  return length;
}

/// The largest value of a function of distances in and near a body; infinite if it exceeds the
/// length of the body, for example if only one face is free.
template <class F>
double largest(const BodyCase& body, int dimension, const F& value_at) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const Box<3> box = bounding_box(body.geometry);
  const double step = step_of_probes(box, dimension);
  if (!std::isfinite(step)) return endless;
  double length = 0, most = -endless;
  for (int a = 0; a < dimension; ++a) length += box.upper[a] - box.lower[a];
  std::vector<std::pair<double, Vector>> found;
  for (const Vector& x : middles(box, dimension, step)) found.emplace_back(value_at(x), x);
  std::ranges::sort(found, std::ranges::greater{});
  const std::size_t from = std::min<std::size_t>(climbers, found.size());
  for (std::size_t k = 0; k < from; ++k) {
    most = std::max(most, climb(value_at, found[k].second, dimension, step, length));
  }
  return most < length ? most : endless;
}

/// Adds a warning for each body that `counts` selects and whose `length` is too small in spacings.
template <class Length, class Counts>
void warn_of(const Case& a_case, std::span<const ThinBodyError> errors, const Length& length,
             const Counts& counts, std::string_view what, std::vector<std::string>& warnings) {
  const double enough = errors.back().across;
  for (const BodyCase& body : a_case.bodies) {
    if (!counts(body)) continue;
    const Resolution resolution = resolution_of(a_case, body);
    const double size = length(a_case, body), across = size / resolution.size;
    const ThinBodyError* error = error_at(errors, across);
    if (error == nullptr) continue;
    warnings.push_back(fmt::format("{} `{}` is {:.2g} {} {}: {}; {}", what, body.name, across,
                                   resolution.units(), what == "body" ? "thick" : "across",
                                   error->deviation, resolution.remedy(size / enough)));
  }
}

/// The largest error beside a part of a wall.
double error_beside(const Shape& shape, int dimension, double h, const RoundWallError& error) {
  double largest = 0;
  for (const Shape& part : shape.operands) {
    largest = std::max(largest, error_beside(part, dimension, h, error));
  }
  if (!is_round(shape)) return largest;
  const bool is_ball = shape.kind == Shape::Kind::ball && dimension == 3;
  return (is_ball ? error.ball : error.cylinder) * std::pow(h / shape.radius, 2);
}

}  // namespace

const ThinBodyError* error_at(std::span<const ThinBodyError> errors, double across) {
  constexpr double rounding = 0.01;  // including the error of the search
  const auto error = std::ranges::find_if(
      errors, [across](const ThinBodyError& one) { return across < one.across * (1 - rounding); });
  return error == errors.end() ? nullptr : &*error;
}

double thickness(const Case& a_case, const BodyCase& body) {
  const int dimension = a_case.dimension;
  const Shape open = initial_surface(a_case, body);
  return 2 * largest(body, dimension,
                     [&](const Vector& x) { return -signed_distance(open, x, dimension); });
}

// The distance from the walls, at the loaded point of the surface nearest to x. Slip walls are
// planes of symmetry and do not count.
double opening(const Case& a_case, const BodyCase& body) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const int dimension = a_case.dimension;
  std::vector<Shape> walls, loads;
  for (const BoundaryCase& boundary : a_case.boundaries) {
    const BoundaryKind& kind = row_of(boundary.kind);
    const bool slips = boundary.kind == BoundaryCase::Kind::slip_wall;
    if (kind.is_attached && !slips) walls.push_back(boundary.geometry);
    if (!kind.is_wall) loads.push_back(boundary.geometry);
  }
  double narrowest = endless;
  for (const Shape& load : loads) {
    const double free = largest(body, dimension, [&](const Vector& x) {
      const double phi = signed_distance(body.geometry, x, dimension);
      const Vector n = outward_direction(body.geometry, x, dimension);
      Vector foot = x;
      for (int a = 0; a < dimension; ++a) foot[a] -= phi * n[a];
      const double beside = signed_distance(load, foot, dimension);
      double least = beside > 0 ? -beside : endless;
      for (const Shape& wall : walls) {
        least = std::min(least, signed_distance(wall, foot, dimension));
      }
      return least;
    });
    if (free > 0) narrowest = std::min(narrowest, 2 * free);
  }
  return narrowest;
}

void warn_of_thin_bodies(const Case& a_case, std::span<const ThinBodyError> errors,
                         std::vector<std::string>& warnings,
                         const std::function<bool(const BodyCase&)>& counts) {
  warn_of(a_case, errors, thickness, counts, "body", warnings);
}

void warn_of_narrow_openings(const Case& a_case, std::span<const ThinBodyError> errors,
                             std::vector<std::string>& warnings) {
  const auto every = [](const BodyCase&) { return true; };
  warn_of(a_case, errors, opening, every, "the surface that walls leave free on body", warnings);
}

void warn_of_slender_bodies(const Case& a_case, double factor, std::vector<std::string>& warnings) {
  constexpr double unmentioned = 0.02;
  const double h = a_case.discretisation.spacing;
  for (const BodyCase& body : a_case.bodies) {
    const double length = length_of(body, a_case.dimension);
    const double thick = thickness(a_case, body);
    const double deviation = factor * std::pow(length * h / (thick * thick), 2);
    if (!std::isfinite(length) || deviation < unmentioned) continue;
    warnings.push_back(fmt::format(
        "body `{}` is {:.2g} times as long as thick: loads bend it up to {:.0f} % too little, more "
        "where they also compress it; use a finer spacing (discretisation.spacing = {:.3g} or "
        "below) or method = \"total_lagrangian\"",
        body.name, length / thick, 100 * deviation, h * std::sqrt(unmentioned / deviation)));
  }
}

void warn_of_round_walls(const Case& a_case, const RoundWallError& error,
                         std::vector<std::string>& warnings) {
  constexpr double unmentioned = 0.04;
  const double h = a_case.discretisation.spacing;
  for (const BoundaryCase& boundary : a_case.boundaries) {
    using enum BoundaryCase::Kind;
    if (boundary.kind != fixed && boundary.kind != moving_wall) continue;
    const double deviation = error_beside(boundary.geometry, a_case.dimension, h, error);
    if (deviation < unmentioned) continue;
    warnings.push_back(fmt::format(
        "the wall `{}` is round, and its radius is small: a body that it holds turns up to "
        "{:.0f} % too far about it, and moves up to {:.0f} % too far; use a finer spacing "
        "(discretisation.spacing = {:.3g} or below) or method = \"total_lagrangian\"",
        boundary.name, 100 * deviation, 50 * deviation, h * std::sqrt(unmentioned / deviation)));
  }
}

void warn_of_reentrant_corners(const Case& a_case, std::string_view deviation,
                               std::vector<std::string>& warnings) {
  for (const BodyCase& body : a_case.bodies) {
    if (contains_mesh(body.geometry)) continue;
    if (!has_reentrant_corner(initial_surface(a_case, body), body.geometry, a_case.dimension,
                              a_case.discretisation.spacing)) {
      continue;
    }
    warnings.push_back(fmt::format(
        "body `{}` has a re-entrant corner, such as that of an L or of a notch: {}; take method = "
        "\"total_lagrangian\" for bodies that keep their neighbours",
        body.name, deviation));
  }
}

}  // namespace pliant
