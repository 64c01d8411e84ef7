#include "engine/total_lagrangian/observe/place_in_cell.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace pliant::total_lagrangian {

namespace {

constexpr double rounding = 1e-9;   // [h] a point on a face that is outside by that is inside
constexpr double tolerance = 1e-6;  // of places in a cell
constexpr int newton_steps = 12;

template <class T, int D>
PlaceInCell<D> on_lattice(const Body<T, D>& body, const Point<D>& x) {
  PlaceInCell<D> place;
  for (int a = 0; a < D; ++a) {
    const double at = (x[a] - body.lattice.node(a, 0)) / body.lattice.spacing;
    const double floor = std::floor(at + rounding);
    place.cell[a] = static_cast<std::int32_t>(floor);
    place.at[a] = at - floor;
  }
  return place;
}

// Newton's method for the place in a cell whose corners have moved. It finds none outside a twisted
// cell.
template <class T, int D>
std::optional<PlaceInCell<D>> in_cell(const Body<T, D>& body, const Cell<D>& cell,
                                      const Point<D>& x) {
  using Vec = Eigen::Matrix<double, D, 1>;
  const auto slots = body.corners(cell);
  std::array<Vec, (1 << D)> corner;
  for (int c = 0; c < (1 << D); ++c) {
    const Point<D> place = body.place(slots[c], body.layout.cell(slots[c]));
    corner[c] = Eigen::Map<const Vec>(place.data());
  }
  PlaceInCell<D> place{cell, {}};
  place.at.fill(0.5);
  bool is_found = false;
  for (int k = 0; k < newton_steps && !is_found; ++k) {
    Vec rest = Eigen::Map<const Vec>(x.data());
    Eigen::Matrix<double, D, D> slope = Eigen::Matrix<double, D, D>::Zero();
    for (int c = 0; c < (1 << D); ++c) {
      rest -= place.weight(c) * corner[c];
      for (int a = 0; a < D; ++a) {
        PlaceInCell<D> end = place;
        end.at[a] = c >> a & 1;  // the weight without its factor along this axis
        slope.col(a) += (c >> a & 1 ? 1 : -1) * end.weight(c) * corner[c];
      }
    }
    if (slope.determinant() == 0) return std::nullopt;
    const Vec change = slope.inverse() * rest;
    for (int a = 0; a < D; ++a) place.at[a] += change[a];
    is_found = change.norm() < tolerance;
  }
  const bool is_inside =
      std::ranges::all_of(place.at, [](double s) { return s >= -tolerance && s <= 1 + tolerance; });
  return is_found && is_inside ? std::optional(place) : std::nullopt;
}

template <int D>
double from_middle(const PlaceInCell<D>& place) {
  double largest = 0;
  for (const double s : place.at) largest = std::max(largest, std::abs(s - 0.5));
  return largest;
}

}  // namespace

template <class T, int D>
PlaceInCell<D> place_in_cell(const Body<T, D>& body, const Point<D>& x) {
  const PlaceInCell<D> regular = on_lattice<T, D>(body, x);
  if (body.fitted_nodes.empty()) return regular;
  Cell<D> lower = regular.cell, upper = regular.cell;
  for (int a = 0; a < D; ++a) {
    --lower[a];
    ++upper[a];
  }
  // Cells behind a wall may be folded, and then seem to contain x as well.
  std::optional<PlaceInCell<D>> found;
  pliant::for_each_cell<D>(lower, upper, [&](const Cell<D>& cell) {
    const std::int64_t slot = body.layout.slot(cell);
    if (slot < 0 || !(body.fraction[slot] > 0)) return;
    std::optional<PlaceInCell<D>> place;
    if (body.is_fitted(cell)) {
      place = in_cell<T, D>(body, cell, x);
    } else if (cell == regular.cell) {
      place = regular;
    }
    if (place && (!found || from_middle(*place) < from_middle(*found))) found = place;
  });
  return found.value_or(regular);
}

template PlaceInCell<2> place_in_cell<double, 2>(const Body<double, 2>&, const Point<2>&);
template PlaceInCell<3> place_in_cell<double, 3>(const Body<double, 3>&, const Point<3>&);
template PlaceInCell<2> place_in_cell<float, 2>(const Body<float, 2>&, const Point<2>&);
template PlaceInCell<3> place_in_cell<float, 3>(const Body<float, 3>&, const Point<3>&);

}  // namespace pliant::total_lagrangian
