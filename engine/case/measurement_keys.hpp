#pragma once

#include "engine/case/key.hpp"
#include "engine/case/words.hpp"

/// The part of the vocabulary that describes measurements: the keys of each kind.
namespace pliant {

template <class Visitor>
void axis_key(Visitor& visit, MeasurementCase& m, std::string_view meaning) {
  Axis axis{m.axis};
  visit("axis", axis, {.meaning = meaning, .example = R"("x")"});
  m.axis = static_cast<int>(axis);
}

template <class Visitor>
void point_key(Visitor& visit, MeasurementCase& m, std::string_view meaning, bool required) {
  visit("point", m.point,
        {.meaning = meaning, .unit = "m", .example = "[0, 0]", .required = required});
}

template <class Visitor>
void reference_length_key(Visitor& visit, MeasurementCase& m) {
  visit(
      "reference", m.reference,
      {.meaning = "length that is subtracted, for a displacement", .unit = "m", .example = "0.5"});
}

template <class Visitor>
void relative_key(Visitor& visit, MeasurementCase& m) {
  visit("relative", m.relative,
        {.meaning = "whether the value is divided by the value at the start", .example = "true"});
}

template <class Visitor>
void extent_keys(Visitor& visit, MeasurementCase& m) {
  axis_key(visit, m, "axis along which the extent is measured");
  Side side = m.lower_side ? Side::lower : Side::upper;
  visit("side", side, {.meaning = "end of the body", .example = R"("upper")"});
  m.lower_side = side == Side::lower;
  visit("where", m.where,
        {.meaning = "formula of x, y, z, t; only surface points where it is not zero count",
         .example = R"("abs(y) < 0.5")"});
  reference_length_key(visit, m);
}

template <class Visitor>
void velocity_error_keys(Visitor& visit, MeasurementCase& m) {
  visit("exact", m.exact,
        {.meaning = "exact velocity, numbers or formulas of x, y, z, t",
         .unit = "m/s",
         .example = R"toml(["0.01*sin(2*pi*x)", 0])toml",
         .required = true});
  visit("reference", m.reference,
        {.meaning = "amplitude by which the error is divided",
         .unit = "m/s",
         .example = "0.01",
         .limits = positive,
         .required = true});
  visit("norm", m.norm, {.meaning = "norm of the error over the body", .example = R"("maximum")"});
}

template <class Visitor>
void history_keys(Visitor& visit, MeasurementCase& m) {
  visit("of", MeasurementName{m.of},
        {.meaning = "name of the measurement whose history is evaluated",
         .example = R"("tip_displacement")",
         .required = true});
  if (m.kind != MeasurementCase::Kind::peak_moving_average) return;
  visit("window", m.window,
        {.meaning = "time over which the moving average is taken",
         .unit = "s",
         .example = "0.005",
         .limits = positive,
         .required = true});
}

template <class Visitor>
void measurement_keys(Visitor& visit, MeasurementCase& m) {
  using Kind = MeasurementCase::Kind;
  visit("name", Name{m.name},
        {.meaning = "name in summary.json and result.h5",
         .example = R"("tip_displacement")",
         .required = true});
  if (!visit("kind", m.kind,
             {.meaning = "kind of measurement",
              .example = R"("mass")",
              .required = true,
              .decides = true})) {
    return;
  }
  if (m.kind == Kind::period || m.kind == Kind::amplitude_ratio ||
      m.kind == Kind::peak_moving_average || m.kind == Kind::last_time_above) {
    return history_keys(visit, m);
  }
  if (m.kind == Kind::wall_force) {
    visit("boundary", BoundaryName{m.boundary},
          {.meaning = "name of the contact wall", .example = R"("floor")", .required = true});
    return axis_key(visit, m, "component");
  }
  if (m.kind == Kind::contact_force) {
    visit("bodies", BodyPair{m.bodies},
          {.meaning = "two bodies of one [[contact]]: the force on the first from the second",
           .example = R"(["left", "right"])",
           .required = true});
    return axis_key(visit, m, "component");
  }
  visit("body", BodyName{m.body}, {.meaning = "name of the body; by default the first one"});
  switch (m.kind) {
    case Kind::extent:
      return extent_keys(visit, m);
    case Kind::surface_distance:
      point_key(visit, m, "start of the line, inside the body", true);
      visit("direction", Direction{m.direction},
            {.meaning = "direction of the line", .example = "[1, 0]", .required = true});
      return reference_length_key(visit, m);
    case Kind::mean_radius:
      point_key(visit, m, "centre", true);
      visit("directions", m.directions,
            {.meaning = "number of directions over which the mean is taken",
             .example = "64",
             .limits = {8, 65536, true, true, "from 8 to 65536"}});
      return;
    case Kind::point_displacement:
      point_key(visit, m, "position of the material point at t = 0", true);
      return axis_key(visit, m, "component");
    case Kind::point_value:
      point_key(visit, m, "fixed position", true);
      visit("field", FieldName{m.field},
            {.meaning = "field: density, pressure, velocity_x, displacement_x, stress_xx, ...",
             .example = R"("pressure")",
             .required = true});
      return;
    case Kind::momentum:
      axis_key(visit, m, "component");
      return relative_key(visit, m);
    case Kind::angular_momentum:
      point_key(visit, m, "point about which it is taken", false);
      if (visit.dimension() == 3) axis_key(visit, m, "component in 3D; in 2D it is about z");
      return relative_key(visit, m);
    case Kind::minimum_particle_distance:
      return;
    case Kind::velocity_error:
      return velocity_error_keys(visit, m);
    default:
      return relative_key(visit, m);
  }
}

}  // namespace pliant
