#include "engine/total_lagrangian/setup.hpp"

#include <pliant/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/geometry/padded.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/total_lagrangian/block_cells.hpp"
#include "engine/total_lagrangian/fit.hpp"
#include "engine/total_lagrangian/prestress.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::total_lagrangian {

namespace {

constexpr int sub_cells = 10;                // to a side, of a cell that the surface cuts
constexpr double smallest_fraction = 0.001;  // of a cell that is worth a stress point
constexpr double on_surface = 1e-9;          // [h] distances that rounding may leave
// Cells of a block: large blocks evaluate few cells of others, but small bodies need enough blocks
// for all threads. What a block uses again, two planes of rows, stays in the second-level cache.
constexpr std::int64_t least_cells = 1024, most_cells = 16384, wanted_blocks = 12;

// Nodes lie on both faces of a box whose sides are whole multiples of the spacing.
template <int D>
Lattice<D> nodes_on_faces(const Case& settings, const Box<3>& box) {
  Lattice<D> lattice;
  const double h = lattice.spacing = settings.discretisation.spacing;
  for (int a = 0; a < D; ++a) {
    const double cells = std::round((box.upper[a] - box.lower[a]) / h);
    lattice.origin[a] = (box.lower[a] + box.upper[a] - (cells + 1) * h) / 2;
  }
  return lattice;
}

// phi on every node of a box of cells, and what follows from it.
template <int D>
class Nodes {
 public:
  Nodes(const Lattice<D>& lattice, const Shape& shape, const Box<3>& box) {
    const double h = lattice.spacing;
    std::int64_t count = 1;
    for (int a = 0; a < D; ++a) {
      lower_[a] = lattice.cell(a, box.lower[a]) - 2;
      extent_[a] = lattice.cell(a, box.upper[a]) + 3 - lower_[a];
      count *= extent_[a];
    }
    phi_.reserve(count);
    for_each([&](const Cell<D>& cell) { phi_.push_back(phi_at(shape, lattice.node(cell), h)); });
  }

  /// Moves the node of a cell to `x`.
  void move(const Cell<D>& cell, const Shape& shape, const Point<D>& x, double h) {
    phi_[index(cell)] = phi_at(shape, x, h);
  }

  template <class F>
  void for_each(F&& f) const {
    Cell<D> cell;
    for (int z = 0; z < (D == 3 ? extent_[D - 1] : 1); ++z) {
      for (int y = 0; y < extent_[1]; ++y) {
        for (int x = 0; x < extent_[0]; ++x) {
          cell[D - 1] = lower_[D - 1] + z;
          cell[1] = lower_[1] + y;
          cell[0] = lower_[0] + x;
          f(cell);
        }
      }
    }
  }

  bool has_cell(const Cell<D>& cell) const {
    for (int a = 0; a < D; ++a) {
      if (cell[a] < lower_[a] || cell[a] >= lower_[a] + extent_[a] - 1) return false;
    }
    return true;
  }

  /// [h]
  double phi(const Cell<D>& cell) const { return phi_[index(cell)]; }

  /// (TL.1)
  double fraction(const Cell<D>& cell) const {
    std::array<double, 1 << D> corner;
    for (int c = 0; c < (1 << D); ++c) {
      Cell<D> at = cell;
      for (int a = 0; a < D; ++a) at[a] += c >> a & 1;
      corner[c] = phi(at);
    }
    const auto [least, most] = std::minmax_element(corner.begin(), corner.end());
    if (*most <= 0) return 1;
    if (*least >= 0) return 0;
    double sum = 0;
    const int count = kernels::power(sub_cells, D);
    for (int k = 0; k < count; ++k) {
      double value = 0;
      for (int c = 0; c < (1 << D); ++c) {
        double weight = 1;
        for (int a = 0, rest = k; a < D; ++a, rest /= sub_cells) {
          const double s = (rest % sub_cells + 0.5) / sub_cells;
          weight *= c >> a & 1 ? s : 1 - s;
        }
        value += weight * corner[c];
      }
      sum += std::clamp(0.5 - sub_cells * value, 0.0, 1.0);
    }
    const double fraction = sum / count;
    return fraction < smallest_fraction ? 0 : fraction;
  }

  const Cell<D>& lower() const { return lower_; }
  Cell<D> upper() const {
    Cell<D> cell = lower_;
    for (int a = 0; a < D; ++a) cell[a] += extent_[a] - 1;
    return cell;
  }

 private:
  // Nodes on the surface count as inside, always: edges of the body stay sharp.
  static double phi_at(const Shape& shape, const Point<D>& x, double h) {
    const double phi = signed_distance(shape, padded<D>(x), D);
    return std::abs(phi) < on_surface * h ? -on_surface : phi / h;
  }

  std::int64_t index(const Cell<D>& cell) const {
    std::int64_t at = 0;
    for (int a = D - 1; a >= 0; --a) at = at * extent_[a] + (cell[a] - lower_[a]);
    return at;
  }

  Cell<D> lower_, extent_;
  std::vector<double> phi_;
};

// A spare layer around the particles, so that every particle has slots on all sides.
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
  occupancy.dilate(1.8);  // also the neighbours across edges and corners
  const std::int64_t cells = std::clamp(marked / wanted_blocks, least_cells, most_cells);
  const int blocks = static_cast<int>(std::max<std::int64_t>(marked / cells, 2));
  body.layout.build(occupancy, {}, blocks, 1);
}

// The constants that the kernels read: those of a linear material's hyperelastic form.
template <class T, int D>
void take_material(const BodyCase& source, Body<T, D>& body) {
  kernels::Material<double> material = source.material;
  if (material.model != kernels::Model::reduced_polynomial) {
    material.order = 1;
    material.coefficient[0] = material.shear_modulus / 2;
    material.compressibility = 2 / material.bulk_modulus;
  }
  body.material = kernels::with_scalar<T>(material);
  body.prony = source.prony;
  body.memory_pressure.resize(body.prony.size());
  body.next_memory_pressure.resize(body.prony.size());
}

template <class T, int D>
void make_room(Body<T, D>& body) {
  const std::int64_t slots = body.slots = body.layout.slots();
  body.for_each_array([slots](const Declaration&, auto components) {
    for (Buffer<T>& component : components) component.grow(slots, T(0));
  });
}

// The nearest wall that comes within half a spacing holds a particle: on average over where the
// wall lies between particles, it is where the case says.
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
        body.held[b].push_back(
            {static_cast<std::int32_t>(p), w, wall.slips() ? wall.normal(x) : Point<D>{}});
      }
    });
  }
}

// Level set, cells and masses. A cell stays one that the body fills when its corners move.
template <class T, int D>
void fill(const Nodes<D>& nodes, Body<T, D>& body) {
  const double h = body.lattice.spacing;
  const double corner_mass = body.material.density * std::pow(h, D) / (1 << D);
  const Layout<D>& layout = body.layout;
  std::fill_n(body.mass.get(), layout.slots(), T(0));
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (!nodes.has_cell(cell)) return;
      body.level_set[p] = h * nodes.phi(cell);
      body.fraction[p] = body.fraction[p] > 0 ? std::max(nodes.fraction(cell), smallest_fraction)
                                              : nodes.fraction(cell);
      if (body.fraction[p] == 0) return;
      const double det = body.is_fitted(cell) ? shape_of<T, D>(body, cell).determinant() : 1;
      for (const std::int64_t q : body.corners(cell)) {
        body.mass[q] += corner_mass * det * body.fraction[p];
      }
    });
  }
}

template <class T, int D>
void fit(const Boundaries<D>& boundaries, const Shape& shape, Nodes<D>& nodes, Body<T, D>& body) {
  body.fitted_nodes = fit_to_rims(boundaries, body);
  if (body.fitted_nodes.empty()) return;
  for (const FittedNode<D>& node : body.fitted_nodes) {
    const Cell<D> cell = body.layout.cell(node.slot);
    nodes.move(cell, shape, body.place(node.slot, cell), body.lattice.spacing);
  }
  fill(nodes, body);
}

}  // namespace

template <class T, int D>
void make_body(const Case& settings, const BodyCase& source, const Boundaries<D>& boundaries,
               Body<T, D>& body) {
  body.name = source.name;
  body.source = &source;
  take_material(source, body);
  const Box<3> box = bounding_box(source.geometry);
  body.lattice = nodes_on_faces<D>(settings, box);
  Nodes<D> nodes(body.lattice, source.geometry, box);
  lay_out<T, D>(nodes, body);
  make_room<T, D>(body);
  fill(nodes, body);
  hold<T, D>(boundaries, body);
  fit(boundaries, source.geometry, nodes, body);
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
