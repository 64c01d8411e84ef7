#pragma once

#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/measurement_kinds.hpp"
#include "engine/case/vocabulary/words.hpp"

/// The part of the vocabulary that describes measurements: the value of each of their keys. The
/// table in measurement_kinds.hpp says which kind has which keys.
namespace pliant {

template <class Visitor>
void axis_key(Visitor& visit, MeasurementCase& m, std::string_view meaning) {
  Axis axis{m.axis};
  visit("axis", axis, {.meaning = meaning, .example = R"("x")"});
  m.axis = static_cast<int>(axis);
}

template <class Visitor>
void side_key(Visitor& visit, MeasurementCase& m) {
  Side side = m.lower_side ? Side::lower : Side::upper;
  visit("side", side, {.meaning = "end of the body", .example = R"("upper")"});
  m.lower_side = side == Side::lower;
}

/// Keys for the quantity and the object of a measurement.
template <class Visitor>
void object_key(Visitor& visit, MeasurementCase& m, const KeyUse& use) {
  switch (use.key) {
    case MeasurementKey::body:
      visit("body", BodyName{m.body}, {.meaning = "name of the body; by default the first one"});
      return;
    case MeasurementKey::boundary:
      visit("boundary", BoundaryName{m.boundary},
            {.meaning = "name of the wall", .example = R"("floor")", .required = true});
      return;
    case MeasurementKey::bodies:
      visit("bodies", BodyPair{m.bodies},
            {.meaning = "two bodies of one [[contact]]: the force on the first from the second",
             .example = R"(["left", "right"])",
             .required = true});
      return;
    case MeasurementKey::cut:
      visit("cut", CutName{m.cut},
            {.meaning = "name of the [[cut]]", .example = R"("scalpel")", .required = true});
      return;
    case MeasurementKey::field:
      visit("field", FieldName{m.field},
            {.meaning = "field: density, pressure, velocity_x, displacement_x, stress_xx, ...",
             .example = R"("pressure")",
             .required = true});
      return;
    case MeasurementKey::exact:
      visit("exact", m.exact,
            {.meaning = "exact velocity, numbers or formulas of x, y, z, t",
             .unit = "m/s",
             .example = R"toml(["0.01*sin(2*pi*x)", 0])toml",
             .required = true});
      return;
    case MeasurementKey::of:
      visit("of", MeasurementName{m.of},
            {.meaning = "name of the measurement whose history is evaluated",
             .example = R"("tip_displacement")",
             .required = true});
      return;
    case MeasurementKey::terms:
      visit("terms", MeasurementNames{m.terms},
            {.meaning = "names of the measurements, which have the same unit",
             .example = R"(["left_force", "right_force"])",
             .required = true});
      return;
    default:
      return;
  }
}

/// Keys for a place or a direction.
template <class Visitor>
void place_key(Visitor& visit, MeasurementCase& m, const KeyUse& use) {
  switch (use.key) {
    case MeasurementKey::axis:
      return axis_key(visit, m, use.meaning);
    case MeasurementKey::rotation_axis:
      if (visit.dimension() == 3) axis_key(visit, m, use.meaning);
      return;
    case MeasurementKey::side:
      return side_key(visit, m);
    case MeasurementKey::where:
      visit("where", m.where,
            {.meaning = "formula of x, y, z, t; only points where it is not zero count",
             .example = R"("abs(y) < 0.5")"});
      return;
    case MeasurementKey::point:
      visit("point", m.point,
            {.meaning = use.meaning, .unit = "m", .example = "[0, 0]", .required = use.required});
      return;
    case MeasurementKey::direction:
      visit("direction", Direction{m.direction},
            {.meaning = "direction of the line", .example = "[1, 0]", .required = true});
      return;
    case MeasurementKey::directions:
      visit("directions", m.directions,
            {.meaning = "number of directions over which the mean is taken",
             .example = "64",
             .limits = {8, 65536, true, true, "from 8 to 65536"}});
      return;
    default:
      return;
  }
}

/// Keys for the evaluation.
template <class Visitor>
void evaluation_key(Visitor& visit, MeasurementCase& m, const KeyUse& use) {
  switch (use.key) {
    case MeasurementKey::length:
      visit("reference", m.reference,
            {.meaning = "length that is subtracted, for a displacement",
             .unit = "m",
             .example = "0.5"});
      return;
    case MeasurementKey::amplitude:
      visit("reference", m.reference,
            {.meaning = "amplitude by which the error is divided",
             .unit = "m/s",
             .example = "0.01",
             .limits = positive,
             .required = true});
      return;
    case MeasurementKey::relative:
      visit(
          "relative", m.relative,
          {.meaning = "whether the value is divided by the value at the start", .example = "true"});
      return;
    case MeasurementKey::norm:
      visit("norm", m.norm,
            {.meaning = "norm of the error over the body", .example = R"("maximum")"});
      return;
    case MeasurementKey::window:
      visit("window", m.window,
            {.meaning = "time over which the moving average is taken",
             .unit = "s",
             .example = "0.005",
             .limits = positive,
             .required = true});
      return;
    case MeasurementKey::fraction:
      visit("fraction", m.fraction,
            {.meaning = "fraction of the peak that must be exceeded",
             .example = "0.01",
             .limits = {0, 1, false, false, "above 0 and below 1"}});
      return;
    case MeasurementKey::time:
      visit("time", m.time,
            {.meaning = "time of the value",
             .unit = "s",
             .example = "0.01",
             .limits = not_negative,
             .required = true});
      return;
    case MeasurementKey::factors:
      visit("factors", m.factors,
            {.meaning = "one factor for each term; by default all are 1", .example = "[1, -1]"});
      return;
    default:
      return;
  }
}

template <class Visitor>
void measurement_keys(Visitor& visit, MeasurementCase& m) {
  visit("name", Name{m.name},
        {.meaning = "name in summary.json and result.h5",
         .example = R"("tip_displacement")",
         .required = true});
  const bool known = visit("kind", m.kind,
                           {.meaning = "kind of measurement",
                            .example = R"("mass")",
                            .required = true,
                            .decides = true});
  if (!known) return;
  for (const KeyUse& use : row_of(m.kind).keys) {
    object_key(visit, m, use);
    place_key(visit, m, use);
    evaluation_key(visit, m, use);
  }
}

}  // namespace pliant
