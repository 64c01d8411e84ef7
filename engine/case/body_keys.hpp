#pragma once

#include "engine/case/key.hpp"
#include "engine/case/shape_keys.hpp"
#include "engine/case/words.hpp"

/// The part of the vocabulary that describes bodies, their boundaries and contacts.
namespace pliant {

template <class Visitor>
void prony_keys(Visitor& visit, PronyCase& prony) {
  visit("ratios", prony.ratios,
        {.meaning =
             "g_1, g_2, ..., relaxing fractions of the instantaneous modulus; their sum is below 1",
         .example = "[0.3, 0.2]",
         .limits = {0, 1, false, false, "above 0 and below 1"},
         .required = true});
  visit("times", prony.times,
        {.meaning = "tau_1, tau_2, ..., their relaxation times",
         .unit = "s",
         .example = "[0.1, 1]",
         .limits = positive,
         .required = true});
  visit("moduli", prony.moduli,
        {.meaning =
             "modulus to which compressibility (of prony) or coefficients (of prony_shear) refer",
         .example = R"("long_term")"});
}

template <class Visitor>
void material_keys(Visitor& visit, MaterialCase& material) {
  const bool known = visit("model", material.model,
                           {.meaning = "constitutive model",
                            .example = R"("linear")",
                            .required = true,
                            .decides = true});
  visit("density", material.density,
        {.meaning = "density at rest",
         .unit = "kg/m^3",
         .example = "1000",
         .limits = positive,
         .required = true});
  if (!known) return;
  if (material.model == MaterialCase::Model::linear) {
    visit("equation_of_state", material.equation_of_state,
          {.meaning = "pressure as a function of the density", .example = R"("linear")"});
  }
  if (material.model != MaterialCase::Model::reduced_polynomial) {
    visit("youngs_modulus", material.youngs_modulus,
          {.meaning = "Young's modulus E",
           .unit = "Pa",
           .example = "100",
           .limits = positive,
           .required = true});
    visit("poissons_ratio", material.poissons_ratio,
          {.meaning = "Poisson's ratio nu",
           .example = "0.3",
           .limits = {-1, 0.5, false, false, "above -1 and below 0.5"},
           .required = true,
           .remedy = "0.49 is nearly incompressible"});
  } else {
    visit("coefficients", Coefficients{material.coefficients},
          {.meaning = "C_10 (positive), C_20, ..., up to five; the shear modulus is 2 C_10",
           .unit = "Pa",
           .example = "[2.2]",
           .required = true});
    visit("compressibility", material.compressibility,
          {.meaning = "D; the bulk modulus is 2/D",
           .unit = "1/Pa",
           .example = "0.001",
           .limits = positive,
           .required = true});
    visit("prony", material.prony,
          {.meaning =
               "Prony series of the bulk modulus, see prony; without it the material is elastic",
           .example = "{ ratios = [0.3, 0.2], times = [0.1, 1] }"});
    visit("prony_shear", material.prony_shear,
          {.meaning = "Prony series of the shear modulus (TL.24), see prony, for total_lagrangian",
           .example = "{ ratios = [0.5], times = [2] }"});
  }
}

template <class Visitor>
void rotation_keys(Visitor& visit, RigidRotation& rotation) {
  visit("centre", rotation.centre, {.meaning = "point at rest", .unit = "m"});
  visit("angular_velocity", AngularVelocity{rotation.angular_velocity},
        {.meaning = "angular velocity, about z in 2D, a vector in 3D",
         .unit = "1/s",
         .example = R"("2*pi")",
         .required = true});
}

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
void stress_keys(Visitor& visit, StressExpression& stress) {
  const auto component = [&visit](std::string_view key, Expression& value,
                                  std::string_view meaning) {
    visit(key, value,
          {.meaning = meaning,
           .unit = "Pa",
           .example = R"toml("-9810*(1 - y)")toml",
           .variables = "xyz"});
  };
  component("xx", stress.xx, "sigma_xx, positive in tension");
  component("yy", stress.yy, "sigma_yy");
  component("xy", stress.xy, "sigma_xy");
  if (visit.dimension() == 2) return;
  component("zz", stress.zz, "sigma_zz, in 3D; plane strain has nu (sigma_xx + sigma_yy)");
  component("yz", stress.yz, "sigma_yz, in 3D");
  component("xz", stress.xz, "sigma_xz, in 3D");
}

template <class Visitor>
void body_keys(Visitor& visit, BodyCase& body) {
  visit("name", Name{body.name},
        {.meaning = "name, to which contacts, measurements and --set refer",
         .example = R"("block")",
         .required = true});
  visit("geometry", body.geometry,
        {.meaning = "shape at t = 0, see geometry",
         .example = R"({ shape = "box", lower = [0, 0], upper = [1, 1] })",
         .required = true});
  visit("material", body.material_as_given,
        {.meaning = "name of a [material.NAME] table, or an inline table with the keys of one",
         .example = R"("tissue")",
         .required = true});
  visit("velocity", body.velocity.translation,
        {.meaning = "initial velocity; without it and without rotation the body starts at rest",
         .unit = "m/s",
         .example = R"([0, "-25*y"])",
         .variables = "xyz"});
  visit("stretch", body.stretch,
        {.meaning = "initial stretch along each axis; geometry is the shape of the stretched body "
                    "(reduced_polynomial only)",
         .example = "[1, 0.95]",
         .limits = positive});
  visit("stress", body.stress,
        {.meaning = "initial stress, see stress; without it the body starts free of stress",
         .unit = "Pa",
         .example = R"toml({ yy = "-9810*(1 - y)" })toml"});
  visit("rotation", body.velocity.rotation,
        {.meaning = "initial rigid rotation, added to velocity, see rotation",
         .example = "{ centre = [0, 0], angular_velocity = 1 }"});
}

/// Where a blade is.
template <class Visitor>
void blade_keys(Visitor& visit, CutCase& cut) {
  visit("track", FilePath{cut.track.file},
        {.meaning = "recorded path of the edge in the undeformed body, instead of from, to, path, "
                    "start and end: CSV with the header time,x,y in 2D; "
                    "time,x1,y1,z1,x2,y2,z2 (both ends) or time,x,y,z,qw,qx,qy,qz (start, and a "
                    "quaternion that turns edge) in 3D; interpolated linearly between rows",
         .example = R"("scalpel.csv")"});
  visit(
      "edge", cut.edge,
      {.meaning = "vector from the start of the edge to its end, in 3D, instead of to: numbers or "
                  "formulas of t",
       .unit = "m",
       .example = R"toml([0, "0.01*sin(t)", "-0.01*cos(t)"])toml",
       .variables = "t"});
  if (!cut.track.file.empty()) return;
  visit("from", cut.from,
        {.meaning = "start of the blade's edge at time start, in the undeformed body; in 2D the "
                    "edge is this point; required without a track, like path and end",
         .unit = "m",
         .example = "[0, 0, 1]"});
  visit("to", cut.to,
        {.meaning = "end of the edge, in 3D; tissue beyond it stays whole",
         .unit = "m",
         .example = "[0, 0, 0.5]"});
  visit("path", cut.path,
        {.meaning = "displacement of the edge since time start, in the undeformed body, numbers or "
                    "formulas of t",
         .unit = "m",
         .example = R"toml(["0.1*t", 0, 0])toml",
         .variables = "t"});
  visit("start", cut.start,
        {.meaning = "time at which the blade starts to cut",
         .unit = "s",
         .example = "0.5",
         .limits = not_negative});
  visit("end", cut.end,
        {.meaning = "time at which the blade stops cutting",
         .unit = "s",
         .example = "1",
         .limits = not_negative});
}

template <class Visitor>
void cut_keys(Visitor& visit, CutCase& cut) {
  visit("name", Name{cut.name},
        {.meaning = "name, to which measurements and --set refer",
         .example = R"("scalpel")",
         .required = true});
  visit("body", BodyName{cut.body}, {.meaning = "name of the body; by default the first one"});
  blade_keys(visit, cut);
  visit("resistance", cut.resistance,
        {.meaning = "energy that new cut faces take from the blade, per undeformed area (PB.18)",
         .unit = "J/m^2",
         .example = "200",
         .limits = not_negative});
  visit("friction", cut.friction,
        {.meaning = "friction of the moving blade, a force per length of its edge in the body "
                    "(PB.18)",
         .unit = "N/m",
         .example = "5",
         .limits = not_negative});
  visit("drag", cut.drag,
        {.meaning =
             "viscous friction, a force per length of the edge and per velocity relative to the "
             "tissue (PB.18)",
         .unit = "Pa s",
         .example = "20",
         .limits = not_negative});
  visit("puncture_force", cut.puncture_force,
        {.meaning = "force on the surface at which the blade enters the body, per unit thickness "
                    "in 2D; until then it dents the body (PB.35); 0 enters at once",
         .unit = "N",
         .example = "0.5",
         .limits = not_negative});
}

template <class Visitor>
void contact_keys(Visitor& visit, ContactCase& contact) {
  visit("bodies", BodyPair{contact.bodies},
        {.meaning = "the two bodies; a body that is named twice is in contact with itself "
                    "(methods on the undeformed body)",
         .example = R"(["left", "right"])",
         .required = true});
  const bool known =
      visit("kind", contact.law,
            {.meaning = "contact law", .example = R"("frictionless")", .decides = true});
  if (!known || contact.law != ContactLaw::coulomb) return;
  visit("friction", contact.friction,
        {.meaning = "coefficient of Coulomb friction (RP.75)",
         .example = "0.3",
         .limits = not_negative,
         .required = true});
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
          {.meaning = "pressure, positive when it pushes on the body, a number or a formula of t",
           .unit = "Pa",
           .example = R"toml("3000*(1 - exp(-t))")toml",
           .required = row.pressure == Use::required,
           .variables = "t"});
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
