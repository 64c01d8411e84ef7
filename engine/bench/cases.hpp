#pragma once

#include <cstdint>
#include <string_view>

#include "engine/case/case.hpp"

/// The cases of the standard set: case files of cases/ with other settings, without measurements
/// and output.
namespace pliant::bench {

/// cases/rotating_cylinder with about `particles` interior particles, remeshed every 10 steps, with
/// the time step of (RP.29) and a dissipation of 0.25.
Case rotating_cylinder(std::int64_t particles, kernels::Kernel kernel);

/// A ball that rotates about the z axis, with the material and the settings of the cylinder.
Case spinning_ball(std::int64_t particles, kernels::Kernel kernel);

/// cases/compression_hyperelastic with n x 2n particles and adaptive remeshing, until t = 0.02 with
/// the time step of (RP.29).
Case compression(int n, kernels::Kernel kernel);

/// The stretched block of cases/block_cut, uncut, with about `nodes` nodes of the point-based
/// method. Each has 26 neighbours, scattered in memory.
Case point_block(std::int64_t nodes, Precision precision);

/// A free vibrating block of rubber, a unit square or cube, with about `particles` particles of a
/// method on the undeformed body.
Case elastic_block(int dimension, std::int64_t particles, Precision precision,
                   std::string_view method = "total_lagrangian");

}  // namespace pliant::bench
