#include "engine/point_based/surface/sharp_edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/lattice/point_algebra.hpp"
#include "engine/point_based/nodes/faces.hpp"
#include "engine/point_based/surface/surface_lattice.hpp"

namespace pliant::test {
namespace {

using point_based::BodySurface;

/// A cube of 1 m (a square in 2D), turned by an angle about the z axis.
template <int D>
Shape turned_cube(double angle) {
  Shape cube;
  cube.kind = Shape::Kind::intersect;
  const auto up_to = [&cube](double x, double y, double distance) {
    Shape& face = cube.operands.emplace_back();
    face.kind = Shape::Kind::half_space;
    face.normal = {x, y, 0};
    face.point = {distance * x, distance * y, 0};
  };
  const double c = std::cos(angle), s = std::sin(angle);
  up_to(c, s, 1);
  up_to(-c, -s, 0);
  up_to(-s, c, 1);
  up_to(s, -c, 0);
  Shape& box = cube.operands.emplace_back();
  box.kind = Shape::Kind::box;
  box.lower = {-2, -2, 0};
  box.upper = {2, 2, 1};
  return cube;
}

template <int D>
BodySurface<D> surface_of(const Shape& shape, double spacing) {
  const point_based::SurfaceLattice<D> lattice(shape, spacing);
  BodySurface<D> surface;
  surface.spacing = spacing;
  std::map<typename point_based::SurfaceLattice<D>::Name, std::int32_t> known;
  for (const auto& facet : lattice.facets()) {
    auto& corners = surface.facet.emplace_back();
    for (int v = 0; v < D; ++v) {
      const auto number = static_cast<std::int32_t>(surface.start.size());
      const auto [at, is_new] = known.insert({facet[v].name, number});
      if (is_new) surface.start.push_back(facet[v].place);
      corners[v] = at->second;
    }
  }
  return surface;
}

template <int D>
std::array<Point<D>, D> corners_of(const BodySurface<D>& surface, std::size_t facet) {
  std::array<Point<D>, D> x;
  for (int v = 0; v < D; ++v) x[v] = surface.start[surface.facet[facet][v]];
  return x;
}

/// D times the volume that the facets enclose, if they are closed.
template <int D>
double enclosed(const BodySurface<D>& surface) {
  double sum = 0;
  for (std::size_t f = 0; f < surface.facet.size(); ++f) {
    const auto x = corners_of<D>(surface, f);
    sum += dot<D>(x[0], undeformed::area_vector<D>(x));
  }
  return sum;
}

template <int D>
void expect_facets_on_faces(double angle, double spacing) {
  SCOPED_TRACE(testing::Message() << D << "D, angle " << angle << ", spacing " << spacing);
  const Shape cube = turned_cube<D>(angle);
  BodySurface<D> surface = surface_of<D>(cube, spacing);
  point_based::sharpen_edges<D>(cube, surface);
  const point_based::Faces<D> faces(cube, spacing);
  double area = 0;
  Point<D> sum = {};
  for (std::size_t f = 0; f < surface.facet.size(); ++f) {
    const auto x = corners_of<D>(surface, f);
    const Point<D> vector = undeformed::area_vector<D>(x);
    area += norm<D>(vector);
    for (int a = 0; a < D; ++a) sum[a] += vector[a];
    Point<D> middle = {};
    for (const Point<D>& corner : x) {
      for (int a = 0; a < D; ++a) middle[a] += corner[a] / D;
    }
    EXPECT_TRUE(faces.hold(middle));
  }
  EXPECT_NEAR(norm<D>(sum), 0, 1e-9);
  EXPECT_NEAR(area, 2 * D, 2e-3 * D);  // slivers may lie upside down
  EXPECT_NEAR(enclosed(surface), D, 1e-6);
}

// Facets cut off edges and corners of bodies whose faces are at an angle to the lattice.
TEST(sharp_edges, of_a_turned_cube_have_its_faces) {
  for (const double angle : {0., 0.1, 0.35, 0.6, std::atan(1.)}) {
    for (const double spacing : {0.2, 0.125, 0.09}) {
      expect_facets_on_faces<2>(angle, spacing);
      expect_facets_on_faces<3>(angle, spacing);
    }
  }
}

TEST(sharp_edges, of_a_box_along_the_lattice_stay_bitwise_the_same) {
  Shape box;
  box.kind = Shape::Kind::box;
  box.upper = {1, 0.7, 0.43};
  BodySurface<3> surface = surface_of<3>(box, 0.11);
  const BodySurface<3> before = surface;
  point_based::sharpen_edges<3>(box, surface);
  EXPECT_EQ(surface.start, before.start);
  EXPECT_EQ(surface.facet, before.facet);
}

// The rim of half a ball is an edge between a plane and a curved face. Facets on the ball stay.
TEST(sharp_edges, of_half_a_ball_lie_on_its_rim) {
  Shape ball, below, half;
  ball.kind = Shape::Kind::ball;
  ball.radius = 1;
  below.kind = Shape::Kind::half_space;
  below.normal = {0, 0.6, 0.8};
  half.kind = Shape::Kind::intersect;
  half.operands = {ball, below};
  BodySurface<3> surface = surface_of<3>(half, 0.1);
  point_based::sharpen_edges<3>(half, surface);
  double flat = 0;
  for (std::size_t f = 0; f < surface.facet.size(); ++f) {
    const Point<3> area = undeformed::area_vector<3>(corners_of<3>(surface, f));
    const double along = 0.6 * area[1] + 0.8 * area[2];
    if (along > (1 - 1e-9) * norm<3>(area)) flat += along;
  }
  EXPECT_NEAR(flat, std::acos(-1.), 0.005 * std::acos(-1.));
}

}  // namespace
}  // namespace pliant::test
