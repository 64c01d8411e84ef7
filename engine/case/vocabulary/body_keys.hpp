#pragma once

#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/shape_keys.hpp"
#include "engine/case/vocabulary/words.hpp"

namespace pliant {

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
                    "(hyperelastic materials only)",
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

}  // namespace pliant
