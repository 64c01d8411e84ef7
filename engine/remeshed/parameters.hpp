#pragma once

#include "engine/case/case.hpp"
#include "engine/case/vocabulary/method_keys.hpp"
#include "engine/case/vocabulary/word.hpp"
#include "kernels/remeshed/stage/gradient.hpp"

namespace pliant::remeshed {

/// How phi is reinitialised: by closest points (RP.41), or as in H&K, (RP.74).
enum class Reinitialisation { closest_point, first_order };

/// det F of remeshed particles: rho0/rho, (RP.38), or the remeshed value, as in H&K.
enum class Determinant { from_density, remeshed };

/// Whether steps and remeshings keep the velocity and spin of free bodies, (RP.90), or leave them
/// as remeshed, as in H&K.
enum class FreeMotion { kept, remeshed };

/// The table [remeshed] of a case: options in which the method differs from that of the paper.
struct Parameters {
  kernels::Gradient gradient = kernels::Gradient::moment_matrix;
  Reinitialisation reinitialisation = Reinitialisation::closest_point;
  Determinant determinant = Determinant::from_density;
  FreeMotion free_motion = FreeMotion::kept;
  double mass_scaling = 1;  ///< M of (RP.87): inertia over mass
};

inline const Parameters& parameters_of(const Case& settings) {
  return settings.parameters.as<Parameters>();
}

/// Whether the damping rate follows the motion, (RP.88).
inline bool damps_adaptively(const Case& settings) { return !settings.discretisation.damping; }

/// Whether the gradient of a particle reads the volumes of its neighbours.
inline bool reads_volumes(const Case& settings) {
  return parameters_of(settings).gradient == kernels::Gradient::normalised;
}

void visit_keys(MethodKeys& visit, MethodParameters& parameters);

}  // namespace pliant::remeshed

namespace pliant {

template <>
inline constexpr std::array words<kernels::Gradient>{
    word(kernels::Gradient::moment_matrix, "moment_matrix",
         "exact for linear fields on any particles (RP.20)"),
    word(kernels::Gradient::normalised, "normalised",
         "one factor for each axis, as in Hieber & Koumoutsakos (RP.19); for "
         "kernel = \"quartic_spline\" only")};

template <>
inline constexpr std::array words<remeshed::Reinitialisation>{
    word(remeshed::Reinitialisation::closest_point, "closest_point",
         "distances to closest points of the surface, which stays where it is (RP.41)"),
    word(remeshed::Reinitialisation::first_order, "first_order",
         "first-order upwind scheme, as in Hieber & Koumoutsakos (RP.74)")};

template <>
inline constexpr std::array words<remeshed::Determinant>{
    word(remeshed::Determinant::from_density, "from_density", "rho0/rho (RP.38)"),
    word(remeshed::Determinant::remeshed, "remeshed",
         "that of the remeshed F, as in Hieber & Koumoutsakos")};

template <>
inline constexpr std::array words<remeshed::FreeMotion>{
    word(remeshed::FreeMotion::kept, "kept",
         "corrected after each remeshing so that body forces alone change it (RP.90)"),
    word(remeshed::FreeMotion::remeshed, "remeshed",
         "without a correction, as in Hieber & Koumoutsakos")};

}  // namespace pliant
