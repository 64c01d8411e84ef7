#include "engine/total_lagrangian/setup.hpp"

#include <pliant/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/boundaries/overhang.hpp"
#include "engine/geometry/padded.hpp"
#include "engine/method/hyperelastic.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/total_lagrangian/block_cells.hpp"
#include "engine/total_lagrangian/fit.hpp"
#include "engine/total_lagrangian/fitted_cells.hpp"
#include "engine/total_lagrangian/nodes.hpp"
#include "engine/total_lagrangian/parameters.hpp"
#include "engine/total_lagrangian/prestress.hpp"
#include "engine/undeformed/network_memory.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::total_lagrangian {

namespace {

// Cells of a block. Large blocks share fewer cells with others, but small bodies need blocks for
// all threads. With fewer than 640 cells, a second thread takes no time off a step. What a block
// reads again, two planes of rows, stays in the second-level cache.
constexpr std::int64_t least_cells = 1024, most_cells = 16384, wanted_blocks = 12;
constexpr std::int64_t cells_for_two_threads = 640;

// A whole number of cells fits along the shortest side, so that the thickness in bending is exact.
// If the other sides of a box are multiples of h, nodes lie on all faces.
template <int D>
Lattice<D> nodes_on_faces(double spacing, const Box<3>& box) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int a = 0; a < D; ++a) shortest = std::min(shortest, box.upper[a] - box.lower[a]);
  Lattice<D> lattice;
  const double h = lattice.spacing = shortest / std::max(1.0, std::round(shortest / spacing));
  for (int a = 0; a < D; ++a) {
    const double cells = std::round((box.upper[a] - box.lower[a]) / h);
    lattice.origin[a] = (box.lower[a] + box.upper[a] - (cells + 1) * h) / 2;
  }
  return lattice;
}

// Adds a spare layer around the particles, so that every particle has slots on all sides.
template <class T, int D>
void lay_out(const Nodes<D>& nodes, Body<T, D>& body) {
  Occupancy<D> occupancy;
  occupancy.reset(nodes.lower(), nodes.upper(), 2);
  std::int64_t marked = 0;
  nodes.for_each([&](const Cell<D>& cell) {
    if (!nodes.has_cell(cell) || nodes.fraction(cell) == 0) return;
    ++marked;
    for (int c = 0; c < (1 << D); ++c) {
      Cell<D> at = cell;
      for (int a = 0; a < D; ++a) at[a] += c >> a & 1;
      occupancy.mark(at);
    }
  });
  if (marked == 0) {
    throw InputError(fmt::format(
        "body `{}` fills no cell of its lattice; use a finer discretisation.spacing", body.name));
  }
  occupancy.dilate(1.8);     // includes neighbours across edges and corners
  occupancy.fill_columns();  // then packs of cells have their corners in packs of particles
  const std::int64_t cells = std::clamp(marked / wanted_blocks, least_cells, most_cells);
  const std::int64_t least_blocks = marked < cells_for_two_threads ? 1 : 2;
  const int blocks = static_cast<int>(std::max(marked / cells, least_blocks));
  body.layout.build(occupancy, {}, blocks, 1);
}

// The constants that kernels read: a linear material in its hyperelastic form, and coefficients
// without the share that relaxes, (TL.24).
template <class T, int D>
void take_material(const BodyCase& source, Body<T, D>& body) {
  kernels::HyperelasticMaterial<double> material = hyperelastic_material(source);
  kernels::Material<double>& polynomial = material.polynomial;
  if (!kernels::carries_deformation(source.material.model)) {
    material.law = kernels::ElasticLaw::reduced_polynomial;
    polynomial.model = source.material.model;
    polynomial.order = 1;
    polynomial.coefficient[0] = polynomial.shear_modulus / 2;
    polynomial.compressibility = 2 / polynomial.bulk_modulus;
  }
  const double lasting = long_term_share(source.prony_shear);
  for (double& coefficient : polynomial.coefficient) coefficient *= lasting;
  body.material = kernels::with_scalar<T>(material);
  body.prony_shear = source.prony_shear;
  body.network.resize(undeformed::network_arrays<D>(body.prony_shear.size()));
  body.next_network.resize(body.network.size());
  body.prony = source.prony;
  body.memory_pressure.resize(body.prony.size());
  body.next_memory_pressure.resize(body.prony.size());
}

// Hourglass stiffness (TL.17) and (TL.26), with Poisson's ratio at rest.
template <int D>
kernels::HourglassStiffness<double> hourglass_stiffness(const std::optional<double>& given,
                                                        const kernels::Material<double>& material) {
  if (given) return {*given, *given, 0, 0};
  const double k = material.bulk_modulus, mu = material.shear_modulus;
  const double poisson = (3 * k - 2 * mu) / (6 * k + 2 * mu);
  if (D == 2) return {1 / (1 - poisson), 0, 0, 0};
  constexpr double twist = 2. / 3;                                     // of plates
  const double pattern = 1 / (twist * (1 - poisson) * (1 - poisson));  // (TL.26)
  return {twist, pattern, 1 - twist, poisson / (1 - poisson)};
}

template <class T, int D>
void make_room(Body<T, D>& body) {
  const std::int64_t slots = body.slots = body.layout.slots();
  body.for_each_array([slots](const Declaration&, auto components) {
    for (Buffer<T>& component : components) component.grow(slots, T(0));
  });
}

// A particle is held by the nearest wall within half a spacing: on average, the held boundary is
// then in the right place. The same holds along the wall where the body overhangs it.
template <class T, int D>
void hold(const Boundaries<D>& boundaries, Body<T, D>& body) {
  const double reach = body.lattice.spacing * (0.5 - on_surface);
  body.held.assign(body.layout.blocks().size(), {});
  for (std::size_t b = 0; b < body.held.size(); ++b) {
    body.layout.for_each_slot(body.layout.blocks()[b], [&](std::int64_t p, const Cell<D>& cell) {
      if (!body.is_particle(p)) return;
      const Point<D> x = body.lattice.node(cell);
      for (int w = 0; w < static_cast<int>(boundaries.walls.size()); ++w) {
        const Wall<D>& wall = boundaries.walls[w];
        if (!wall.is_attached() || wall.distance(x) >= reach) continue;
        if (is_beyond_rim<D>(body.source->geometry, wall, x, body.lattice.spacing / 2)) continue;
        body.held[b].push_back(
            {static_cast<std::int32_t>(p), w, wall.slips() ? wall.normal(x) : Point<D>{}, x});
      }
    });
  }
}

template <class T, int D>
kernels::CutPack<T, D> pack_of_whole_cells() {
  kernels::CutPack<T, D> pack = {};
  std::ranges::fill(pack.moment[0], T(1));
  return pack;
}

// Sets the moments (TL.36) of a cell that the surface cuts.
template <class T, int D>
void take_moments(const CellMoments<D>& moments, std::int64_t slot, Body<T, D>& body) {
  std::int32_t& number = body.cut[slot / kernels::slots_per_pack];
  if (number == 0) {
    number = static_cast<std::int32_t>(body.cut_packs.size());
    body.cut_packs.push_back(pack_of_whole_cells<T, D>());
  }
  for (int m = 0; m < (1 << D); ++m) {
    body.cut_packs[number].moment[m][slot % kernels::slots_per_pack] = static_cast<T>(moments[m]);
  }
}

// Sets level set, cells and masses. A cell keeps its stress point when its corners move.
template <class T, int D>
void fill(const Nodes<D>& nodes, Body<T, D>& body) {
  const double h = body.lattice.spacing;
  const double corner_mass = body.material.density * std::pow(h, D) / (1 << D);
  const Layout<D>& layout = body.layout;
  std::fill_n(body.mass.get(), layout.slots(), T(0));
  body.cut.assign(layout.slots() / kernels::slots_per_pack, 0);
  body.cut_packs = {pack_of_whole_cells<T, D>()};
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (!nodes.has_cell(cell)) return;
      body.level_set[p] = h * nodes.phi(cell);
      body.fraction[p] = body.fraction[p] > 0 ? std::max(nodes.fraction(cell), Nodes<D>::smallest)
                                              : nodes.fraction(cell);
      if (body.fraction[p] == 0) return;
      if (const auto* const moments = nodes.moments(cell)) take_moments<T, D>(*moments, p, body);
      const double det = body.is_fitted(cell) ? shape_of<T, D>(body, cell).determinant() : 1;
      for (const std::int64_t q : body.corners(cell)) {
        body.mass[q] += corner_mass * det * body.fraction[p];
      }
    });
  }
}

template <class T, int D>
void fit(const Boundaries<D>& boundaries, Nodes<D>& nodes, Body<T, D>& body) {
  WallFit<D> found = fit_to_walls(boundaries, body);
  body.fitted_nodes = std::move(found.nodes);
  if (body.fitted_nodes.empty()) return;
  for (const FittedNode<D>& node : body.fitted_nodes) {
    const Cell<D> cell = body.layout.cell(node.slot);
    nodes.move(cell, body.place(node.slot, cell));
  }
  for (const Cell<D>& cell : found.flat_cells) {
    nodes.empty(cell);
    body.fraction[body.layout.slot(cell)] = 0;
  }
  fill(nodes, body);
  const auto has_no_cell = [&](const auto& node) { return !body.is_particle(node.slot); };
  std::erase_if(body.fitted_nodes, has_no_cell);
  for (auto& of_block : body.held) {
    std::erase_if(of_block, has_no_cell);
    for (ConstrainedParticle<D>& held : of_block) {
      held.start = body.place(held.slot, body.layout.cell(held.slot));
    }
  }
}

}  // namespace

template <class T, int D>
void make_body(const Case& settings, const BodyCase& source, const Boundaries<D>& boundaries,
               Body<T, D>& body) {
  body.name = source.name;
  body.source = &source;
  take_material(source, body);
  body.hourglass =
      hourglass_stiffness<D>(parameters_of(settings).hourglass_stiffness, source.material);
  const Box<3> box = bounding_box(source.geometry);
  body.lattice = nodes_on_faces<D>(settings.discretisation.spacing, box);
  Nodes<D> nodes(body.lattice, source.geometry, box);
  lay_out<T, D>(nodes, body);
  if (!parameters_of(settings).damping) body.sampled_force[0].grow(body.layout.slots(), T(0));
  make_room<T, D>(body);
  fill(nodes, body);
  hold<T, D>(boundaries, body);
  fit(boundaries, nodes, body);
  make_fitted_cells(body);
  find_block_cells(body);
  const Layout<D>& layout = body.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (!body.is_particle(p)) return;
      ++body.particles;
      body.inverse_mass[p] = 1 / body.mass[p];
      const Vector u = initial_velocity(source, padded<D>(body.place(p, cell)));
      for (int a = 0; a < D; ++a) body.velocity[a][p] = u[a];
    });
  }
  prestress(source, body);
  make_surface<T, D>(boundaries, body);
}

template void make_body<double, 2>(const Case&, const BodyCase&, const Boundaries<2>&,
                                   Body<double, 2>&);
template void make_body<double, 3>(const Case&, const BodyCase&, const Boundaries<3>&,
                                   Body<double, 3>&);
template void make_body<float, 2>(const Case&, const BodyCase&, const Boundaries<2>&,
                                  Body<float, 2>&);
template void make_body<float, 3>(const Case&, const BodyCase&, const Boundaries<3>&,
                                  Body<float, 3>&);

}  // namespace pliant::total_lagrangian
