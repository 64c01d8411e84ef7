#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "engine/case/case.hpp"
#include "engine/case/method_rules.hpp"
#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/case/vocabulary/contact_laws.hpp"
#include "engine/case/vocabulary/measurement_kinds.hpp"
#include "engine/case/vocabulary/word.hpp"

/// The words that case files use for the choices of a case.
namespace pliant {

template <>
inline constexpr std::array words<Precision>{
    word(Precision::binary64, "double", "64 bits, about 16 digits"),
    word(Precision::binary32, "single", "32 bits, about 7 digits; faster, and half of the memory")};

template <>
inline constexpr std::array words<CheckResponse>{
    word(CheckResponse::warn, "warn", "a message; the run continues"),
    word(CheckResponse::stop, "stop", "the run ends with exit status 3"),
    word(CheckResponse::off, "off", "no message")};

template <>
inline constexpr std::array words<BoundaryCase::LoadedArea>{
    word(BoundaryCase::LoadedArea::present, "present", "per area of the deformed surface"),
    word(BoundaryCase::LoadedArea::undeformed, "undeformed",
         "per area of the undeformed surface, a dead load; not in the remeshed method")};

template <>
inline constexpr std::array words<kernels::Kernel>{
    word(kernels::Kernel::quartic_spline, "quartic_spline",
         "quartic B-spline, 5 x 5 particles (RP.15)"),
    word(kernels::Kernel::quartic_spline_fit, "quartic_spline_fit",
         "polynomial fit to the quartic spline within 0.7 %, 5 x 5 particles, about twice as fast "
         "(RP.16)"),
    word(kernels::Kernel::compact, "compact",
         "polynomial over the compact stencil of 3 x 3 particles, the "
         "fastest (RP.17)"),
    word(kernels::Kernel::fourth_order, "fourth_order",
         "gradients of fourth order on a nearly undeformed lattice, for waves, 5 x 5 particles "
         "(RP.18)")};

template <>
inline constexpr std::array words<GhostTreatment>{
    word(GhostTreatment::linear, "linear", "linear fits with current normals (RP.45)"),
    word(GhostTreatment::averaged, "averaged", "averages, as in Hieber & Koumoutsakos (RP.49)"),
    word(GhostTreatment::rigid, "rigid", "rigid motion of the neighbours (RP.59)")};

/// The words of methods; their values are positions in the list.
inline std::vector<Word> words_of(MethodList methods) {
  std::vector<Word> words;
  for (const MethodRules& method : methods) {
    words.push_back({static_cast<int>(words.size()), method.word, method.meaning});
  }
  return words;
}

template <>
inline constexpr std::array words<VolumeRule>{
    word(VolumeRule::reset, "reset", "every particle gets the volume of a lattice cell (RP.34)"),
    word(VolumeRule::conserved, "conserved",
         "mass, momentum and volume are conserved to rounding (RP.35), for periodic bodies")};

template <>
inline constexpr std::array words<MaterialCase::Model>{
    word(MaterialCase::Model::linear, "linear", "Hooke's law with the Jaumann rate (RP.3)"),
    word(MaterialCase::Model::reduced_polynomial, "reduced_polynomial",
         "hyperelastic reduced polynomial with up to five coefficients (RP.9)"),
    word(MaterialCase::Model::neo_hookean, "neo_hookean",
         "hyperelastic, stable in compression (PB.6)"),
    word(MaterialCase::Model::st_venant_kirchhoff, "st_venant_kirchhoff",
         "Hooke's law of the Green strain (PB.7); loses stiffness below a stretch of 0.58")};

template <>
inline constexpr std::array words<MaterialCase::EquationOfState>{
    word(MaterialCase::EquationOfState::linear, "linear", "pressure linear in the density (RP.5)"),
    word(MaterialCase::EquationOfState::logarithmic, "logarithmic",
         "pressure linear in the logarithm of the density (RP.6)")};

template <>
inline constexpr std::array words<PronyCase::Moduli>{
    word(PronyCase::Moduli::long_term, "long_term", "the modulus after full relaxation"),
    word(PronyCase::Moduli::instantaneous, "instantaneous", "the modulus of sudden changes")};

/// Shapes in the words of case files; a ball is a disc in 2D.
enum class ShapeWord {
  box,
  disc,
  ball,
  capsule,
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
    word(ShapeWord::capsule, "capsule", "all points within a radius of a line between two points"),
    word(ShapeWord::cylinder, "cylinder", "round cylinder, infinite along its axis, in 3D"),
    word(ShapeWord::half_space, "half_space", "all points on one side of a plane"),
    word(ShapeWord::mesh, "mesh", "interior of a closed triangle surface from a file, in 3D"),
    word(ShapeWord::unite, "union", "points that lie in any of the parts"),
    word(ShapeWord::difference, "difference",
         "points of the first part that lie in none of the others"),
    word(ShapeWord::intersection, "intersection", "points that lie in all parts")};

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

}  // namespace pliant
