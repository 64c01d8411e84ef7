#pragma once

#include "engine/point_based/body.hpp"
#include "engine/point_based/point_room.hpp"
#include "kernels/point_based/arguments.hpp"

/// Arguments of the kernels for a block of a body. The step adds durations and what acts on all
/// nodes.
namespace pliant::point_based {

template <class T, int D>
kernels::PointDrift<T, D> drift_arguments(Body<T, D>& body, int local) {
  kernels::PointDrift<T, D> arguments = {};
  arguments.first = body.blocks[local].first;
  arguments.count = body.blocks[local].count;
  for (int a = 0; a < D; ++a) {
    arguments.velocity[a] = body.velocity[a].get();
    arguments.displacement[a] = body.displacement[a].get();
  }
  return arguments;
}

template <class T, int D>
kernels::PointForces<T, D> force_arguments(Body<T, D>& body, int local) {
  const NodeBlock& block = body.blocks[local];
  kernels::PointForces<T, D> arguments = {};
  arguments.first = block.first;
  arguments.count = block.count;
  arguments.bonds = body.bonds;
  arguments.neighbour = body.neighbour.get() + block.first * body.bonds;
  arguments.bond = body.bond.get() + block.first * body.bonds * (D + 1);
  arguments.halo_count = block.halo_count;
  arguments.halo = body.halo.data() + block.first_halo;
  arguments.volume = body.volume.get();
  arguments.stiffness = body.stiffness.get();
  arguments.frequency2 = body.frequency2.get();
  const bool is_pressed = body.is_pressed() && !body.pressed[local].empty();
  for (int a = 0; a < D; ++a) {
    arguments.displacement[a] = body.displacement[a].get();
    if (is_pressed) arguments.load[a] = body.pressure_load[a].get();
  }
  for (int c = 0; c < Body<T, D>::symmetric; ++c) {
    arguments.moment[c] = body.moment[c].get();
    arguments.strain[c] = body.strain[c].get();
    arguments.initial_stress[c] = body.initial_stress[c].get();
  }
  for (int c = 0; c < D * D; ++c) arguments.kept[c] = body.kept_gradient[c].get();
  arguments.share = body.share.get();
  arguments.shared_modulus = body.shared_modulus;
  arguments.material = body.material;
  arguments.point = room_for_points<T>(body.most_points);
  arguments.force = body.force.get() + kernels::point_stride * block.first_point();
  return arguments;
}

template <class T, int D>
kernels::PointMotion<T, D> motion_arguments(Body<T, D>& body, int local) {
  const NodeBlock& block = body.blocks[local];
  kernels::PointMotion<T, D> arguments = {};
  arguments.first = block.first;
  arguments.count = block.count;
  arguments.collected = body.collected[local].data();
  arguments.collected_count = static_cast<int>(body.collected[local].size());
  arguments.force = body.force.get() + kernels::point_stride * block.first_point();
  arguments.inverse_mass = body.inverse_mass.get();
  for (int a = 0; a < D; ++a) {
    if (body.is_loaded()) arguments.external[a] = body.traction[a].get();
    arguments.velocity[a] = body.velocity[a].get();
    arguments.displacement[a] = body.displacement[a].get();
  }
  return arguments;
}

template <class T, int D>
kernels::PointMomentum<T, D> momentum_arguments(const Body<T, D>& body, int local) {
  kernels::PointMomentum<T, D> arguments = {};
  arguments.first = body.blocks[local].first;
  arguments.count = body.blocks[local].count;
  arguments.mass = body.mass.get();
  for (int a = 0; a < D; ++a) arguments.velocity[a] = body.velocity[a].get();
  return arguments;
}

}  // namespace pliant::point_based
