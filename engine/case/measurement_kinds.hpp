#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/measurement_kind.hpp"
#include "engine/case/word.hpp"

/// The kinds of measurements, each declared in one row: word, unit, keys and meaning. The functions
/// that evaluate them are in a table of each method (`observe/measure.cpp`), and in that of
/// `simulation/histories.cpp` for the kinds that evaluate the history of another measurement.
namespace pliant {

inline constexpr auto measurement_kinds = [] {
  using Kind = MeasurementCase::Kind;
  using Key = MeasurementKey;
  using namespace key_uses;
  return std::to_array<MeasurementKind>({
      {Kind::extent,
       "extent",
       units::metre,
       Sampling::value,
       {body, {Key::axis, "axis along which the extent is measured"}, side, where, length},
       "coordinate of the farthest point of the free surface along an axis, less the reference; on "
       "the lower side the reference less the coordinate",
       "no point of the free surface counts"},
      {Kind::surface_distance,
       "surface_distance",
       units::metre,
       Sampling::value,
       {body, point("start of the line, inside the body"), {Key::direction, "", true}, length},
       "distance from a point to the free surface along a direction",
       "the line does not start inside the body, or meets no free surface"},
      {Kind::mean_radius,
       "mean_radius",
       units::metre,
       Sampling::value,
       {body, point("centre"), {Key::directions}},
       "mean distance from a point to the free surface over all directions",
       "the point is outside the body, or a direction meets no free surface"},
      {Kind::point_displacement,
       "point_displacement",
       units::metre,
       Sampling::value,
       {body, point("position of the material point at t = 0"), component},
       "displacement of a material point along an axis",
       "no particles that started around the point remain"},
      {Kind::point_value,
       "point_value",
       units::of_field,
       Sampling::value,
       {body, point("fixed position"), {Key::field, "", true}},
       "value of a field at a fixed point",
       "the point is outside the body"},
      {Kind::material_value,
       "material_value",
       units::of_field,
       Sampling::value,
       {body, point("position of the material point at t = 0"), {Key::field, "", true}},
       "value of a field at a material point",
       "no particles that started around the point remain"},
      {Kind::mean_value,
       "mean_value",
       units::of_field,
       Sampling::value,
       {body, {Key::field, "", true}, {Key::where, "present positions in the body"}},
       "mean of a field over the volume of a body, or over a part of it",
       "no particle lies where the formula is not zero"},
      {Kind::mass, "mass", units::mass, Sampling::value, {body, relative}, "mass of a body", ""},
      {Kind::centre_of_mass,
       "centre_of_mass",
       units::metre,
       Sampling::value,
       {body, component, length},
       "coordinate of the centre of mass of a body",
       "the body has no mass"},
      {Kind::momentum,
       "momentum",
       units::momentum,
       Sampling::value,
       {body, component, relative},
       "momentum of a body along an axis",
       ""},
      {Kind::angular_momentum,
       "angular_momentum",
       units::angular_momentum,
       Sampling::value,
       {body,
        {Key::point, "point about which it is taken"},
        {Key::rotation_axis, "component in 3D; in 2D it is about z"},
        relative},
       "angular momentum of a body about a point",
       ""},
      {Kind::kinetic_energy,
       "kinetic_energy",
       units::energy,
       Sampling::value,
       {body, relative},
       "kinetic energy of a body",
       ""},
      {Kind::strain_energy,
       "strain_energy",
       units::energy,
       Sampling::value,
       {body, relative},
       "strain energy of a body",
       ""},
      {Kind::total_energy,
       "total_energy",
       units::energy,
       Sampling::value,
       {body, relative},
       "kinetic plus strain energy of a body",
       ""},
      {Kind::energy_ratio,
       "energy_ratio",
       units::one,
       Sampling::value,
       {body, relative},
       "ratio of kinetic to strain energy of a body, small for slow loads",
       "the strain energy is zero"},
      {Kind::wall_force,
       "wall_force",
       units::force,
       Sampling::rate,
       {{{Key::boundary, "", true}, component}},
       "force of a wall on all bodies, averaged since the last sample (RP.65)",
       ""},
      {Kind::wall_moment,
       "wall_moment",
       units::moment,
       Sampling::rate,
       {{{Key::boundary, "", true},
         {Key::point, "point about which it is taken"},
         {Key::rotation_axis, "component in 3D; in 2D it is about z"}}},
       "moment of the force of a wall on all bodies, averaged since the last sample (TL.31)",
       ""},
      {Kind::contact_force,
       "contact_force",
       units::force,
       Sampling::rate,
       {{{Key::bodies, "", true}, component}},
       "force between two bodies in contact, averaged since the last sample (RP.68)",
       ""},
      {Kind::blade_force,
       "blade_force",
       units::force,
       Sampling::rate,
       {{{Key::cut, "", true}, component}},
       "force of a blade on the body that it cuts, averaged since the last sample (PB.18)",
       ""},
      {Kind::cutting_work,
       "cutting_work",
       units::energy,
       Sampling::value,
       {{{Key::cut, "", true}}},
       "energy that new cut faces and friction have taken from a blade so far (PB.19)",
       ""},
      {Kind::volume,
       "volume",
       units::volume,
       Sampling::value,
       {body, relative},
       "volume of a body, area in 2D",
       ""},
      {Kind::surface_area,
       "surface_area",
       units::area,
       Sampling::value,
       {body, relative},
       "area of the free surface of a body, length in 2D",
       ""},
      {Kind::connected_parts,
       "connected_parts",
       units::one,
       Sampling::value,
       {body},
       "number of parts into which cuts have divided a body",
       ""},
      {Kind::largest_part_volume,
       "largest_part_volume",
       units::volume,
       Sampling::value,
       {body, relative},
       "undeformed volume of the largest of these parts, up to the cuts",
       ""},
      {Kind::minimum_particle_distance,
       "minimum_particle_distance",
       units::one,
       Sampling::value,
       {body},
       "smallest distance between two particles of a body over the spacing, at most 2",
       ""},
      {Kind::velocity_error,
       "velocity_error",
       units::one,
       Sampling::value,
       {body, {Key::exact, "", true}, {Key::amplitude, "", true}, {Key::norm}},
       "difference from an exact velocity over an amplitude",
       ""},
      {Kind::period,
       "period",
       units::second,
       Sampling::from_history,
       {of},
       "twice the mean time between zero crossings of another measurement",
       "the measurement crosses zero less than twice"},
      {Kind::amplitude_ratio,
       "amplitude_ratio",
       units::one,
       Sampling::from_history,
       {of},
       "mean ratio of successive maxima of equal sign of another measurement",
       "the measurement has no two successive maxima of equal sign"},
      {Kind::peak_moving_average,
       "peak_moving_average",
       units::of_source,
       Sampling::from_history,
       {of, {Key::window, "", true}},
       "moving average of largest magnitude of another measurement (RP.66)",
       "the samples cover less time than the window"},
      {Kind::last_time_above,
       "last_time_above",
       units::second,
       Sampling::from_history,
       {of, {Key::fraction}},
       "last time at which another measurement exceeds a fraction of its peak, in magnitude "
       "(RP.67)",
       "the measurement is zero throughout"},
      {Kind::smallest,
       "smallest",
       units::of_source,
       Sampling::from_history,
       {of},
       "smallest value of another measurement so far",
       "the measurement has no value at any time"},
      {Kind::largest,
       "largest",
       units::of_source,
       Sampling::from_history,
       {of},
       "largest value of another measurement so far",
       "the measurement has no value at any time"},
      {Kind::value_at_time,
       "value_at_time",
       units::of_source,
       Sampling::from_history,
       {of, {Key::time, "", true}},
       "value of another measurement at a given time, linear between samples",
       "the samples do not reach the time"},
      {Kind::weighted_sum,
       "weighted_sum",
       units::of_terms,
       Sampling::from_history,
       {{{Key::terms, "", true}, {Key::factors}}},
       "sum of other measurements, each times a factor",
       "one of the measurements has no value"},
  });
}();
static_assert(is_in_order(measurement_kinds));

constexpr const MeasurementKind& row_of(MeasurementCase::Kind kind) {
  return measurement_kinds[static_cast<std::size_t>(kind)];
}

template <>
inline constexpr auto words<MeasurementCase::Kind> =
    words_of<MeasurementCase::Kind>(measurement_kinds);

/// A field that measurements read; those with a z exist only in 3D, but for the stress out of the
/// plane.
struct MeasurableField {
  std::string_view name, unit;
};
inline constexpr auto measurable_fields = std::to_array<MeasurableField>({
    {"density", "kg/m^3"},   {"pressure", "Pa"},      {"velocity_x", "m/s"},
    {"velocity_y", "m/s"},   {"velocity_z", "m/s"},   {"displacement_x", "m"},
    {"displacement_y", "m"}, {"displacement_z", "m"}, {"stress_xx", "Pa"},
    {"stress_xy", "Pa"},     {"stress_xz", "Pa"},     {"stress_yy", "Pa"},
    {"stress_yz", "Pa"},     {"stress_zz", "Pa"},     {"von_mises_stress", "Pa"},
    {"strain_xx", "1"},      {"strain_xy", "1"},      {"strain_xz", "1"},
    {"strain_yy", "1"},      {"strain_yz", "1"},      {"strain_zz", "1"},
});

constexpr bool exists_in(const MeasurableField& field, int dimension) {
  const std::string_view name = field.name;
  return dimension == 3 || name == "stress_zz" || name.find('z', name.size() - 2) == name.npos;
}

/// SI unit of the values of a measurement, "1" for ratios.
std::string_view unit_of(const Case& a_case, const MeasurementCase& m);

/// Names the measurements that are means over the whole run, or that evaluate a history of two
/// values, because a case of a method without remeshings gives no `output.measure_every`; empty
/// where there are none.
std::string sampling_warning(const Case& a_case);

/// The same at the end of a run of a method with remeshings, of which there may have been few:
/// where more than a twentieth of the run lies between two of the `times` [s] of its samples.
std::string sampling_warning(const Case& a_case, const std::vector<double>& times);

}  // namespace pliant
