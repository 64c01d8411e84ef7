#include "engine/total_lagrangian/setup.hpp"

#include <pliant/error.hpp>
#include "engine/method/initial_velocity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/geometry/signed_distance.hpp"

namespace pliant::total_lagrangian {

namespace {

constexpr int sub_cells = 10;                // to a side, of a cell that the surface cuts
constexpr double smallest_fraction = 0.001;  // of a cell that is worth a stress point
constexpr double on_surface = 1e-9;          // [h] distances that rounding may leave
constexpr std::int64_t slots_of_block = 2048;

// Nodes lie on both faces of a box whose sides are whole multiples of the spacing.
template <int D>
Lattice<D> nodes_on_faces(const Case& settings, const Box& box) {
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
  Nodes(const Lattice<D>& lattice, const Shape& shape, const Box& box) {
    const double h = lattice.spacing;
    std::int64_t count = 1;
    for (int a = 0; a < D; ++a) {
      lower_[a] = lattice.cell(a, box.lower[a]) - 2;
      extent_[a] = lattice.cell(a, box.upper[a]) + 3 - lower_[a];
      count *= extent_[a];
    }
    phi_.reserve(count);
    for_each([&](const Cell<D>& cell) {
      const Point<D> x = lattice.node(cell);
      Vector at = {};
      for (int a = 0; a < D; ++a) at[a] = x[a];
      const double phi = signed_distance(shape, at, D);
      // Nodes on the surface count as inside, always: edges of the body stay sharp.
      phi_.push_back(std::abs(phi) < on_surface * h ? -on_surface : phi / h);
    });
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
  double phi(const Cell<D>& cell) const {
    std::int64_t at = 0;
    for (int a = D - 1; a >= 0; --a) at = at * extent_[a] + (cell[a] - lower_[a]);
    return phi_[at];
  }

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
  const int blocks = static_cast<int>(std::max<std::int64_t>(marked / slots_of_block, 2));
  body.layout.build(occupancy, {}, blocks, 1);
}

template <class T, int D>
void make_room(Body<T, D>& body) {
  const std::int64_t slots = body.layout.slots();
  body.for_each_array([slots](Field, auto components) {
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
        if (!wall.bonded() || wall.distance(x) >= reach) continue;
        body.held[b].push_back(
            {static_cast<std::int32_t>(p), w, wall.slips() ? wall.normal(x) : Point<D>{}});
      }
    });
  }
}

}  // namespace

template <class T, int D>
void make_body(const Case& settings, const BodyCase& source, const Boundaries<D>& boundaries,
               Body<T, D>& body) {
  body.name = source.name;
  body.source = &source;
  const Box box = bounding_box(source.geometry);
  body.lattice = nodes_on_faces<D>(settings, box);
  const double h = body.lattice.spacing;
  const Nodes<D> nodes(body.lattice, source.geometry, box);
  lay_out<T, D>(nodes, body);
  make_room<T, D>(body);
  const double corner_mass = body.material.density * std::pow(h, D) / (1 << D);
  const Layout<D>& layout = body.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (!nodes.has_cell(cell)) return;
      body.level_set[p] = h * nodes.phi(cell);
      body.fraction[p] = nodes.fraction(cell);
      if (body.fraction[p] == 0) return;
      for (const std::int64_t q : body.corners(cell))
        body.mass[q] += corner_mass * body.fraction[p];
    });
  }
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (!body.is_particle(p)) return;
      ++body.particles;
      body.inverse_mass[p] = 1 / body.mass[p];
      Vector x = {};
      for (int a = 0; a < D; ++a) x[a] = body.lattice.node(a, cell[a]);
      const Vector u = initial_velocity(source, x);
      for (int a = 0; a < D; ++a) body.velocity[a][p] = u[a];
    });
  }
  hold<T, D>(boundaries, body);
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
