#include "engine/point_based/nodes/faces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/point_algebra.hpp"

namespace pliant::point_based {

namespace {

constexpr double nearly_half_pitch = 0.5 + 1e-9;
constexpr double on_one_face = 1e-9, on_all_faces = 1e-6;  // [h]
constexpr int most_projections = 50;                       // onto faces that are not perpendicular
constexpr std::size_t most_faces = 6;                      // near one point

/// Whether `y` is in the cell of the lattice point `x`.
template <int D>
bool is_in_cell(const Point<D>& x, const Point<D>& pitch, const Point<D>& y) {
  for (int a = 0; a < D; ++a) {
    if (std::abs(y[a] - x[a]) > nearly_half_pitch * pitch[a]) return false;
  }
  return true;
}

template <int D>
Point<D> direction_at(const Shape& face, const Point<D>& x) {
  const Vector n = outward_direction(face, padded<D>(x), D);
  Point<D> direction;
  for (int a = 0; a < D; ++a) direction[a] = n[a];
  return direction;
}

}  // namespace

template <int D>
Faces<D>::Faces(const Shape& shape, double spacing) : shape_(shape), spacing_(spacing) {
  collect(shape);
}

template <int D>
void Faces<D>::collect(const Shape& shape) {
  for (const Shape& operand : shape.operands) collect(operand);
  if (!shape.operands.empty()) return;
  if (shape.kind != Shape::Kind::box) {
    face_.push_back(shape);
    return;
  }
  for (int side = 0; side < 2 * D; ++side) {
    const Vector& corner = side % 2 == 0 ? shape.lower : shape.upper;
    if (std::isinf(corner[side / 2])) continue;
    Shape& face = face_.emplace_back();
    face.kind = Shape::Kind::half_space;
    face.point[side / 2] = corner[side / 2];
    face.normal[side / 2] = side % 2 == 0 ? -1 : 1;
  }
}

template <int D>
bool Faces<D>::hold(const Point<D>& x) const {
  return std::abs(signed_distance(shape_, padded<D>(x), D)) <= on_all_faces * spacing_;
}

template <int D>
bool Faces<D>::is_on(int face, const Point<D>& x) const {
  return std::abs(signed_distance(face_[face], padded<D>(x), D)) <= on_all_faces * spacing_;
}

template <int D>
std::vector<int> Faces<D>::through(const Point<D>& x) const {
  std::vector<int> faces;
  for (int f = 0; f < static_cast<int>(face_.size()); ++f) {
    if (is_on(f, x)) faces.push_back(f);
  }
  return faces;
}

template <int D>
std::vector<int> Faces<D>::through_or_near(const Point<D>& x) const {
  std::vector<int> faces = through(x);
  if (!faces.empty()) return faces;
  int nearest = -1;
  double shortest = spacing_ / 2;
  for (int f = 0; f < static_cast<int>(face_.size()); ++f) {
    const double distance = std::abs(signed_distance(face_[f], padded<D>(x), D));
    if (distance >= shortest || !hold(onto(x, {&f, 1}))) continue;
    shortest = distance;
    nearest = f;
  }
  if (nearest >= 0) faces.push_back(nearest);
  return faces;
}

template <int D>
bool Faces<D>::are_planes(std::span<const int> faces) const {
  return std::ranges::all_of(faces,
                             [&](int f) { return face_[f].kind == Shape::Kind::half_space; });
}

template <int D>
bool Faces<D>::meet(const Point<D>& x, std::span<const int> faces) const {
  return std::ranges::all_of(faces, [&](int f) { return is_on(f, x); }) && hold(x);
}

template <int D>
Point<D> Faces<D>::onto(Point<D> x, std::span<const int> faces) const {
  bool has_moved = true;
  for (int round = 0; round < most_projections && has_moved; ++round) {
    has_moved = false;
    for (const int f : faces) {
      const double distance = signed_distance(face_[f], padded<D>(x), D);
      if (std::abs(distance) <= on_one_face * spacing_) continue;
      has_moved = true;
      const Point<D> n = direction_at<D>(face_[f], x);
      for (int a = 0; a < D; ++a) x[a] -= distance * n[a];
    }
  }
  return x;
}

template <int D>
std::vector<int> Faces<D>::near(const Point<D>& x, const Point<D>& pitch) const {
  std::vector<int> close;
  std::vector<bool> is_within_half;  // of the pitch along the normal; others only cut the cell of x
  for (int f = 0; f < static_cast<int>(face_.size()) && close.size() < most_faces; ++f) {
    const double distance = std::abs(signed_distance(face_[f], padded<D>(x), D));
    if (distance > norm<D>(pitch)) continue;
    Point<D> along = direction_at<D>(face_[f], x);
    double side = 0;
    for (int a = 0; a < D; ++a) side += std::abs(along[a] *= pitch[a]);
    if (distance > nearly_half_pitch * side) continue;
    close.push_back(f);
    is_within_half.push_back(distance <= nearly_half_pitch * norm<D>(along));
  }
  std::vector<int> best;
  double shortest = nearly_half_pitch * norm<D>(pitch);
  for (unsigned set = 1; set < 1U << close.size(); ++set) {
    if (static_cast<std::size_t>(std::popcount(set)) < best.size()) continue;
    std::vector<int> faces;
    bool are_within_half = true;
    for (std::size_t k = 0; k < close.size(); ++k) {
      if ((set >> k & 1) == 0) continue;
      faces.push_back(close[k]);
      are_within_half = are_within_half && is_within_half[k];
    }
    if (faces.size() == 1 && !are_within_half) continue;
    const Point<D> foot = onto(x, faces);
    const double way = norm<D>(difference<D>(foot, x));
    if (faces.size() == best.size() && way >= shortest) continue;
    // Parallel faces never meet.
    if (way > nearly_half_pitch * norm<D>(pitch) || !meet(foot, faces)) continue;
    if (!are_within_half && !is_in_cell<D>(x, pitch, foot)) continue;
    best = faces;
    shortest = way;
  }
  return best;
}

template class Faces<2>;
template class Faces<3>;

}  // namespace pliant::point_based
