#pragma once

#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/shape_keys.hpp"
#include "engine/case/vocabulary/words.hpp"

namespace pliant {

template <class Visitor>
void wall_rotation_keys(Visitor& visit, WallRotation& rotation) {
  visit("centre", rotation.centre,
        {.meaning = "point of the axis at t = 0; it moves with the wall", .unit = "m"});
  if (visit.dimension() == 3) {
    visit("axis", Direction{rotation.axis},
          {.meaning = "direction of the axis, in 3D; in 2D it is z",
           .example = "[0, 0, 1]",
           .required = true});
  }
  visit("angle", rotation.angle,
        {.meaning = "angle since t = 0, counter-clockwise seen against the axis, a formula of t",
         .unit = "rad",
         .example = R"toml("pi/6*t")toml",
         .required = true,
         .variables = "t"});
}

template <class Visitor>
void boundary_keys(Visitor& visit, BoundaryCase& boundary) {
  visit("name", Name{boundary.name},
        {.meaning = "name, to which measurements and --set refer",
         .example = R"("upper")",
         .required = true});
  const bool known = visit(
      "kind", boundary.kind,
      {.meaning = "kind of boundary", .example = R"("fixed")", .required = true, .decides = true});
  visit("geometry", boundary.geometry,
        {.meaning = "solid of the wall at t = 0, or region in which the load acts",
         .example = R"({ shape = "half_space", point = [0, 0], normal = [0, 1] })",
         .required = true});
  if (!known) return;
  const BoundaryKind& row = row_of(boundary.kind);
  if (row.friction != Use::no) {
    visit("friction", WallFriction{boundary},
          {.meaning = "friction between wall and bodies: a word, or the coefficient of Coulomb "
                      "friction (TL.12)",
           .example = R"("no_slip")",
           .limits = not_negative,
           .remedy = "give a coefficient, as in friction = 0.3"});
  }
  if (row.motion != Use::no) {
    visit("velocity", boundary.velocity,
          {.meaning = "velocity of the wall, numbers or formulas of t",
           .unit = "m/s",
           .example = "[0, -25]",
           .variables = "t"});
    visit("displacement", boundary.displacement,
          {.meaning = "displacement of the wall since t = 0, instead of its velocity",
           .unit = "m",
           .example = R"toml([0, "-0.1*t"])toml",
           .variables = "t"});
  }
  if (row.rotation != Use::no) {
    visit("rotation", boundary.rotation,
          {.meaning = "rotation of the wall, added to its velocity or displacement, see rotation "
                      "of a wall",
           .example = R"toml({ centre = [0, 0], angle = "pi/6*t" })toml"});
  }
  if (row.pressure != Use::no) {
    visit("pressure", boundary.pressure,
          {.meaning = "pressure, positive when it pushes on the body, a number or a formula of x, "
                      "y, z, t",
           .unit = "Pa",
           .example = R"toml("3000*(1 - exp(-t))")toml",
           .required = row.pressure == Use::required});
  }
  if (row.traction != Use::no) {
    visit("traction", boundary.traction,
          {.meaning = "force per area in fixed directions, numbers or formulas of x, y, z, t",
           .unit = "Pa",
           .example = R"toml(["1000*t", 0])toml",
           .required = row.traction == Use::required});
    visit("area", boundary.area,
          {.meaning = "the area of the force per area", .example = R"("present")"});
  }
}

}  // namespace pliant
