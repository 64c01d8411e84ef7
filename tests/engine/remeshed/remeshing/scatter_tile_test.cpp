#include "engine/remeshed/remeshing/scatter_tile.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/engine/remeshed/spinning_disc.hpp"

namespace pliant::test {
namespace {

using Value = kernels::NodeField<2>;

/// (RP.31)
double m4prime(double s) {
  s = std::abs(s);
  if (s < 1) return 1 - 2.5 * s * s + 1.5 * s * s * s;
  return s < 2 ? (2 - s) * (2 - s) * (1 - s) / 2 : 0;
}

/// The sums of (RP.32): 1, m, m u, v, phi.
using Sums = std::array<double, 6>;

struct Particle {
  Point<2> cell;  ///< position in cells
  Sums values;
};

/// All particles and ghosts except images.
std::vector<Particle> particles_of(Body& body) {
  std::vector<Particle> particles;
  const auto& fields = body.stage[0];
  const double h = body.lattice.spacing;
  for (const Kind kind : {Kind::interior, Kind::free_ghost, Kind::wall_ghost}) {
    for_each(body.population, kind, [&](std::int64_t p, const Cell<2>& cell) {
      const double m = fields.get(Field::mass)[p];
      Particle particle{
          {},
          {1, m, m * fields.get(Field::velocity, 0)[p], m * fields.get(Field::velocity, 1)[p],
           fields.get(Field::volume)[p], fields.get(Field::level_set)[p]}};
      for (int a = 0; a < 2; ++a) {
        particle.cell[a] = cell[a] + fields.get(Field::drift, a)[p] / h;
      }
      particles.push_back(particle);
    });
  }
  return particles;
}

/// Distance along an axis, to the nearest image if the axis is periodic [cells].
double along(double from, double to, std::int32_t period) {
  const double distance = to - from;
  return period == 0 ? distance : distance - period * std::round(distance / period);
}

/// Moves every particle by up to half a cell, each differently, and its images with it.
void displace(Solver& solver) {
  Body& body = solver.state().bodies[0];
  const double h = body.lattice.spacing;
  for (const Kind kind : {Kind::interior, Kind::free_ghost, Kind::wall_ghost}) {
    for_each(body.population, kind, [&](std::int64_t p, const Cell<2>& cell) {
      body.stage[0].get(Field::drift, 0)[p] = 0.5 * h * std::sin(3. * cell[0] + 5. * cell[1]);
      body.stage[0].get(Field::drift, 1)[p] = 0.5 * h * std::cos(2. * cell[0] - 7. * cell[1]);
    });
  }
}

/// Compares every node of every block with the sum over all particles.
void expect_all_sums(Solver& solver) {
  Body& body = solver.state().bodies[0];
  const auto& layout = body.population.layout;
  remeshed::LayoutSearch<double, 2> search(body, false);
  search.prepare();
  const int blocks = static_cast<int>(layout.blocks().size());
  for (int b = 0; b < blocks; ++b) search.find_bounds(b);
  const std::vector<Particle> particles = particles_of(body);
  const auto& kernels = kernels::RemeshedTable<double, 2>::of(kernels::Isa::sse2);
  const Cell<2>& period = body.lattice.period;
  remeshed::TransportedFields<double, 2> material = {3, {}};
  for (int c = 0; c < 3; ++c) material.field[c] = body.stage[0].get(Field::material, c);
  remeshed::ScatterTile<double, 2> tile;
  for (int b = 0; b < blocks; ++b) {
    tile.lay_out(layout, b);
    tile.fill(body, search.bounds(), material, kernels);
    layout.for_each_slot(layout.blocks()[b], [&](std::int64_t, const Cell<2>& cell) {
      if (!body.lattice.is_wrapped(cell)) return;
      Sums sums = {};
      for (const Particle& particle : particles) {
        double w = 1;
        for (int a = 0; a < 2; ++a) w *= m4prime(along(particle.cell[a], cell[a], period[a]));
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += w * particle.values[i];
      }
      const double* node = tile.node(cell);
      const Sums found = {node[Value::weight],       node[Value::mass],   node[Value::momentum],
                          node[Value::momentum + 1], node[Value::volume], node[Value::level_set]};
      // Sums of sixteen terms of size one.
      for (std::size_t i = 0; i < sums.size(); ++i) {
        EXPECT_NEAR(found[i], sums[i], 1e-13)
            << "value " << i << " at " << cell[0] << ", " << cell[1];
      }
    });
  }
}

TEST(scatter_tile, holds_the_sums_of_all_particles_and_ghosts_of_a_body) {
  Solver solver(spinning_disc(0.125), {1, kernels::Isa::sse2});
  displace(solver);
  expect_all_sums(solver);
}

TEST(scatter_tile, holds_what_particles_bring_across_a_period) {
  Solver solver(small_case("periodic_square", {"discretisation.spacing=1/16"}),
                {1, kernels::Isa::sse2});
  displace(solver);
  expect_all_sums(solver);
}

}  // namespace
}  // namespace pliant::test
