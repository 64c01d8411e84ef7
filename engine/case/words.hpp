#pragma once

#include <array>
#include <string_view>

#include "engine/case/case.hpp"

/// The words that case files use for the choices of a case.
namespace pliant {

/// One value of an enumeration as case files spell it.
struct Word {
  int value;
  std::string_view text;
  std::string_view meaning;
};

/// All words of enumeration `E`, in the order in which the reference lists them.
template <class E>
inline constexpr std::array<Word, 0> words{};

template <class E>
constexpr Word word(E value, std::string_view text, std::string_view meaning) {
  return {static_cast<int>(value), text, meaning};
}

template <>
inline constexpr std::array words<Method>{
    word(Method::remeshed, "remeshed",
         "Lagrangian particles that are remeshed; a level set follows the free surface"),
    word(Method::total_lagrangian, "total_lagrangian",
         "nodes and stress points of the undeformed body (TL.1), for slow loads; hyperelastic "
         "materials only")};

template <>
inline constexpr std::array words<Precision>{
    word(Precision::binary64, "double", "64 bits, about 16 digits"),
    word(Precision::binary32, "single", "32 bits, about 7 digits; faster, and half of the memory")};

template <>
inline constexpr std::array words<kernels::Weight>{
    word(kernels::Weight::quartic, "quartic_spline", "quartic B-spline, 5 x 5 particles (RP.14)"),
    word(kernels::Weight::quartic_polynomial, "quartic_spline_fit",
         "polynomial fit to the quartic spline within 0.7 %, 5 x 5 particles, about twice as fast "
         "(RP.15)"),
    word(kernels::Weight::compact, "compact",
         "polynomial over the compact stencil of 3 x 3 particles, the "
         "fastest (RP.16)"),
    word(kernels::Weight::fourth_order, "fourth_order",
         "gradients of fourth order on a nearly undeformed lattice, for waves, 5 x 5 particles "
         "(RP.90)")};

template <>
inline constexpr std::array words<Operators>{
    word(Operators::moment_matrix, "moment_matrix",
         "gradients that are exact for linear fields (RP.18)"),
    word(Operators::symmetric_sph, "symmetric_sph",
         "plain SPH without ghosts or remeshing, the baseline of the paper (RP.73), (RP.74)")};

template <>
inline constexpr std::array words<GhostTreatment>{
    word(GhostTreatment::linear, "linear", "linear fits with current normals (RP.34)"),
    word(GhostTreatment::averaged, "averaged", "averages, as in Hieber & Koumoutsakos (RP.38)"),
    word(GhostTreatment::rigid, "rigid", "rigid motion of the neighbours (RP.39)")};

template <>
inline constexpr std::array words<VolumeRule>{
    word(VolumeRule::reset, "reset", "every particle gets the volume of a lattice cell (RP.24)"),
    word(VolumeRule::conserved, "conserved",
         "mass, momentum and volume are conserved to rounding (RP.25), for periodic bodies")};

template <>
inline constexpr std::array words<MaterialCase::Model>{
    word(MaterialCase::Model::linear, "linear", "Hooke's law with the Jaumann rate (RP.3)"),
    word(MaterialCase::Model::reduced_polynomial, "reduced_polynomial",
         "hyperelastic reduced polynomial with up to five coefficients (RP.9)")};

template <>
inline constexpr std::array words<MaterialCase::EquationOfState>{
    word(MaterialCase::EquationOfState::linear, "linear", "pressure linear in the density (RP.5)"),
    word(MaterialCase::EquationOfState::logarithmic, "logarithmic",
         "pressure linear in the logarithm of the density (RP.6)")};

template <>
inline constexpr std::array words<PronyCase::Moduli>{
    word(PronyCase::Moduli::long_term, "long_term",
         "2/D is the bulk modulus after full relaxation"),
    word(PronyCase::Moduli::instantaneous, "instantaneous",
         "2/D is the bulk modulus for sudden changes")};

/// Shapes as case files name them; a ball is a disc in 2D.
enum class ShapeWord {
  box,
  disc,
  ball,
  cylinder,
  half_space,
  mesh,
  unite,
  difference,
  intersection
};
template <>
inline constexpr std::array words<ShapeWord>{
    word(ShapeWord::box, "box", "axis-aligned box between two corners, which may be infinite"),
    word(ShapeWord::disc, "disc", "disc, in 2D"),
    word(ShapeWord::ball, "ball", "ball, in 3D"),
    word(ShapeWord::cylinder, "cylinder", "round cylinder, infinite along its axis, in 3D"),
    word(ShapeWord::half_space, "half_space", "all points on one side of a plane"),
    word(ShapeWord::mesh, "mesh", "interior of a closed triangle surface from a file, in 3D"),
    word(ShapeWord::unite, "union", "points that lie in any of the parts"),
    word(ShapeWord::difference, "difference",
         "points of the first part that lie in none of the others"),
    word(ShapeWord::intersection, "intersection", "points that lie in all parts")};

/// Boundaries as case files name them: a fixed wall is a wall without velocity.
enum class BoundaryWord { fixed, moving_wall, slip_wall, contact_wall, pressure };
template <>
inline constexpr std::array words<BoundaryWord>{
    word(BoundaryWord::fixed, "fixed", "no-slip wall at rest"),
    word(BoundaryWord::moving_wall, "moving_wall", "no-slip wall with a prescribed velocity"),
    word(BoundaryWord::slip_wall, "slip_wall",
         "wall along which the body slides without friction and from which it cannot separate"),
    word(BoundaryWord::contact_wall, "contact_wall",
         "wall with unilateral contact: bodies can meet it and separate from it (RP.50)"),
    word(BoundaryWord::pressure, "pressure",
         "pressure on the part of the free surface that lies in a region")};

template <>
inline constexpr std::array words<BoundaryCase::Friction>{
    word(BoundaryCase::Friction::frictionless, "frictionless",
         "bodies in contact slide freely (RP.36)"),
    word(BoundaryCase::Friction::no_slip, "no_slip", "bodies in contact do not slide (RP.35)")};

template <>
inline constexpr std::array words<ContactCase::Kind>{
    word(ContactCase::Kind::frictionless, "frictionless",
         "unilateral contact without friction (RP.65)"),
    word(ContactCase::Kind::no_slip, "no_slip", "unilateral contact without sliding"),
    word(ContactCase::Kind::tied, "tied", "permanent bond without sliding or separation")};

template <>
inline constexpr std::array words<MeasurementCase::Kind>{
    word(MeasurementCase::Kind::extent, "extent",
         "coordinate of the farthest point of the free surface along an axis"),
    word(MeasurementCase::Kind::surface_distance, "surface_distance",
         "distance from a point to the free surface along a direction"),
    word(MeasurementCase::Kind::mean_radius, "mean_radius",
         "mean distance from a point to the free surface over all directions"),
    word(MeasurementCase::Kind::point_displacement, "point_displacement",
         "displacement of a material point along an axis"),
    word(MeasurementCase::Kind::point_value, "point_value", "value of a field at a fixed point"),
    word(MeasurementCase::Kind::mass, "mass", "mass of a body"),
    word(MeasurementCase::Kind::momentum, "momentum", "momentum of a body along an axis"),
    word(MeasurementCase::Kind::angular_momentum, "angular_momentum",
         "angular momentum of a body about a point"),
    word(MeasurementCase::Kind::kinetic_energy, "kinetic_energy", "kinetic energy of a body"),
    word(MeasurementCase::Kind::strain_energy, "strain_energy", "strain energy of a body"),
    word(MeasurementCase::Kind::total_energy, "total_energy",
         "kinetic plus strain energy of a body"),
    word(MeasurementCase::Kind::energy_ratio, "energy_ratio",
         "ratio of kinetic to strain energy of a body, small for slow loads"),
    word(MeasurementCase::Kind::wall_force, "wall_force",
         "force of a contact wall on all bodies, averaged since the last sample (RP.52)"),
    word(MeasurementCase::Kind::contact_force, "contact_force",
         "force between two bodies in contact, averaged since the last sample (RP.67)"),
    word(MeasurementCase::Kind::volume, "volume", "volume of a body, area in 2D"),
    word(MeasurementCase::Kind::surface_area, "surface_area",
         "area of the free surface of a body, length in 2D"),
    word(MeasurementCase::Kind::minimum_particle_distance, "minimum_particle_distance",
         "smallest distance between two particles of a body over the spacing, at most 2"),
    word(MeasurementCase::Kind::velocity_error, "velocity_error",
         "difference from an exact velocity over an amplitude"),
    word(MeasurementCase::Kind::period, "period",
         "twice the mean time between zero crossings of another measurement"),
    word(MeasurementCase::Kind::amplitude_ratio, "amplitude_ratio",
         "mean ratio of successive maxima of equal sign of another measurement"),
    word(MeasurementCase::Kind::peak_moving_average, "peak_moving_average",
         "peak of the moving average of another measurement (RP.62)"),
    word(MeasurementCase::Kind::last_time_above, "last_time_above",
         "last time at which another measurement exceeds a thousandth of its peak (RP.63)")};

template <>
inline constexpr std::array words<MeasurementCase::Norm>{
    word(MeasurementCase::Norm::maximum, "maximum", "maximum over the particles (L-infinity)"),
    word(MeasurementCase::Norm::root_mean_square, "root_mean_square",
         "root mean square over the particles (L2)")};

enum class Axis { x, y, z };
template <>
inline constexpr std::array words<Axis>{word(Axis::x, "x", ""), word(Axis::y, "y", ""),
                                        word(Axis::z, "z", "in 3D")};

enum class Side { upper, lower };
template <>
inline constexpr std::array words<Side>{word(Side::upper, "upper", "towards the positive axis"),
                                        word(Side::lower, "lower", "towards the negative axis")};

/// The word for `value`.
template <class E>
constexpr std::string_view text_of(E value) {
  for (const Word& word : words<E>) {
    if (word.value == static_cast<int>(value)) return word.text;
  }
  return {};
}

/// Fields that `point_value` reads; those with a z only in 3D.
inline constexpr std::array<std::string_view, 14> measurable_fields{
    "density",        "pressure",       "velocity_x",     "velocity_y", "velocity_z",
    "displacement_x", "displacement_y", "displacement_z", "stress_xx",  "stress_xy",
    "stress_xz",      "stress_yy",      "stress_yz",      "stress_zz"};

/// Fields that exist in `dimension`.
constexpr bool is_measurable(std::string_view field, int dimension) {
  for (const std::string_view known : measurable_fields) {
    if (known == field) return dimension == 3 || field.find('z', field.size() - 2) == field.npos;
  }
  return false;
}

}  // namespace pliant
