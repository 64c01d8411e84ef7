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
    word(Method::remeshed, "remeshed", "Lagrangian particles with remeshing and a level set"),
    word(Method::total_lagrangian, "total_lagrangian",
         "particles and stress points of the undeformed body (TL.1); hyperelastic materials")};

template <>
inline constexpr std::array words<kernels::Weight>{
    word(kernels::Weight::quartic, "quartic", "quartic B-spline, 5 x 5 particles (RP.14)"),
    word(kernels::Weight::quartic_polynomial, "quartic_polynomial",
         "a polynomial within 0.7 % of it, about twice as fast (RP.15)"),
    word(kernels::Weight::compact, "compact", "3 x 3 particles, the fastest (RP.16)"),
    word(kernels::Weight::fourth_order, "fourth_order",
         "5 x 5 particles, for waves: gradients of fourth order where the lattice is hardly "
         "deformed (RP.90)")};

template <>
inline constexpr std::array words<Operators>{
    word(Operators::moment_matrix, "moment_matrix", "exact for linear fields (RP.18)"),
    word(Operators::symmetric_sph, "symmetric_sph",
         "plain SPH without ghosts or remeshing, the paper's baseline (RP.73), (RP.74)")};

template <>
inline constexpr std::array words<GhostTreatment>{
    word(GhostTreatment::linear, "linear", "linear fits, current normals (RP.34)"),
    word(GhostTreatment::averaged, "averaged", "averages, as Hieber & Koumoutsakos (RP.38)"),
    word(GhostTreatment::rigid, "rigid", "the neighbours' rigid motion (RP.39)")};

/// `remeshing.volume`; the case holds a flag.
enum class VolumeRule { reset, extensive };
template <>
inline constexpr std::array words<VolumeRule>{
    word(VolumeRule::reset, "reset", "every particle gets the volume of a cell (RP.24)"),
    word(VolumeRule::extensive, "extensive",
         "mass, momentum and volume are conserved to rounding (RP.25); for periodic cells")};

template <>
inline constexpr std::array words<MaterialCase::Model>{
    word(MaterialCase::Model::linear, "linear", "Hooke's law with the Jaumann rate (RP.3)"),
    word(MaterialCase::Model::reduced_polynomial, "reduced_polynomial",
         "hyperelastic, up to five coefficients (RP.9)")};

template <>
inline constexpr std::array words<MaterialCase::Law>{
    word(MaterialCase::Law::rho, "rho", "pressure linear in the density (RP.5)"),
    word(MaterialCase::Law::log, "log", "pressure linear in the logarithm of the density (RP.6)")};

template <>
inline constexpr std::array words<PronyCase::Moduli>{
    word(PronyCase::Moduli::long_term, "long_term", "2/D is what is left when all has relaxed"),
    word(PronyCase::Moduli::instantaneous, "instantaneous", "2/D is what a sudden change meets")};

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
    word(ShapeWord::box, "box", "between two corners; its ends may be infinite"),
    word(ShapeWord::disc, "disc", "in 2D"),
    word(ShapeWord::ball, "ball", "in 3D"),
    word(ShapeWord::cylinder, "cylinder", "in 3D, infinite along its axis"),
    word(ShapeWord::half_space, "half_space", "everything on one side of a plane"),
    word(ShapeWord::mesh, "mesh", "in 3D, inside a closed surface of triangles from a file"),
    word(ShapeWord::unite, "union", "all points of all parts"),
    word(ShapeWord::difference, "difference", "the first part without the others"),
    word(ShapeWord::intersection, "intersection", "the points that all parts share")};

/// Boundaries as case files name them: a fixed wall is a wall without velocity.
enum class BoundaryWord { fixed, moving_wall, slip_wall, contact_wall, pressure };
template <>
inline constexpr std::array words<BoundaryWord>{
    word(BoundaryWord::fixed, "fixed", "material sticks to a wall at rest"),
    word(BoundaryWord::moving_wall, "moving_wall", "material sticks to a wall that moves"),
    word(BoundaryWord::slip_wall, "slip_wall", "material slides along the wall without friction"),
    word(BoundaryWord::contact_wall, "contact_wall",
         "a wall that bodies touch, press against and leave (RP.50)"),
    word(BoundaryWord::pressure, "pressure", "pressure on the free surface inside a region")};

template <>
inline constexpr std::array words<BoundaryCase::Friction>{
    word(BoundaryCase::Friction::frictionless, "frictionless", "what touches slides (RP.36)"),
    word(BoundaryCase::Friction::sticking, "sticking", "what touches sticks (RP.35)")};

template <>
inline constexpr std::array words<ContactCase::Kind>{
    word(ContactCase::Kind::frictionless, "frictionless", "they push and slide (RP.65)"),
    word(ContactCase::Kind::sticking, "sticking", "they push, and stick as long as they do"),
    word(ContactCase::Kind::bonded, "bonded",
         "one interface for good, whose materials stay apart")};

template <>
inline constexpr std::array words<MeasurementCase::Kind>{
    word(MeasurementCase::Kind::extent, "extent",
         "farthest point of the free surface along an axis"),
    word(MeasurementCase::Kind::ray, "ray", "distance along a line from a point to the surface"),
    word(MeasurementCase::Kind::mean_radius, "mean_radius",
         "mean distance of the surface from a point"),
    word(MeasurementCase::Kind::point_displacement, "point_displacement",
         "displacement of a material point along an axis"),
    word(MeasurementCase::Kind::point_value, "point_value", "a field at a fixed point"),
    word(MeasurementCase::Kind::mass, "mass", "of a body"),
    word(MeasurementCase::Kind::momentum, "momentum", "of a body, along an axis"),
    word(MeasurementCase::Kind::angular_momentum, "angular_momentum", "of a body, about a point"),
    word(MeasurementCase::Kind::kinetic_energy, "kinetic_energy", "of a body"),
    word(MeasurementCase::Kind::strain_energy, "strain_energy", "of a body"),
    word(MeasurementCase::Kind::total_energy, "total_energy",
         "kinetic plus strain energy of a body"),
    word(MeasurementCase::Kind::energy_ratio, "energy_ratio",
         "kinetic over strain energy of a body: small when loads are slow"),
    word(MeasurementCase::Kind::wall_force, "wall_force",
         "force of a contact wall on the bodies, mean since the last sample (RP.52)"),
    word(MeasurementCase::Kind::contact_force, "contact_force",
         "force between two bodies in contact, mean since the last sample (RP.67)"),
    word(MeasurementCase::Kind::volume, "volume", "of a body; an area in 2D"),
    word(MeasurementCase::Kind::surface_area, "surface_area",
         "of the free surface; a length in 2D"),
    word(MeasurementCase::Kind::closest_pair, "closest_pair",
         "smallest distance of two particles of a body over the spacing, at most 2"),
    word(MeasurementCase::Kind::velocity_error, "velocity_error",
         "difference from an exact velocity, over an amplitude"),
    word(MeasurementCase::Kind::period, "period",
         "twice the mean time between zero crossings of another measurement"),
    word(MeasurementCase::Kind::amplitude_ratio, "amplitude_ratio",
         "mean ratio of successive maxima of the same sign of another measurement"),
    word(MeasurementCase::Kind::largest_mean, "largest_mean",
         "largest mean over a time of another measurement"),
    word(MeasurementCase::Kind::last_time, "last_time",
         "when another measurement was last above a thousandth of its largest value")};

template <>
inline constexpr std::array words<MeasurementCase::Norm>{
    word(MeasurementCase::Norm::maximum, "maximum", "largest over the particles (L-infinity)"),
    word(MeasurementCase::Norm::root_mean_square, "root_mean_square", "L2 over the particles")};

enum class Axis { x, y, z };
template <>
inline constexpr std::array words<Axis>{word(Axis::x, "x", ""), word(Axis::y, "y", ""),
                                        word(Axis::z, "z", "in 3D")};

enum class Side { upper, lower };
template <>
inline constexpr std::array words<Side>{word(Side::upper, "upper", "towards the positive axis"),
                                        word(Side::lower, "lower", "towards the negative axis")};

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
