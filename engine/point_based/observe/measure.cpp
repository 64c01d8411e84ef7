#include "engine/point_based/observe/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/geometry/padded.hpp"
#include "engine/method/no_value.hpp"
#include "engine/method/velocity_error.hpp"
#include "engine/point_based/cut_faces/cut_cells.hpp"
#include "engine/point_based/cutting/connected_parts.hpp"
#include "engine/point_based/cutting/crossing.hpp"
#include "engine/point_based/forces/node_state.hpp"
#include "engine/point_based/observe/node_values.hpp"
#include "engine/point_based/surface/surface.hpp"

namespace pliant::point_based {

template <class T, int D>
auto Measurer<T, D>::function_of(MeasurementCase::Kind kind) -> Function {
  using Quantity = MeasurementCase::Kind;
  static constexpr std::pair<Quantity, Function> functions[] = {
      {Quantity::blade_force, &Measurer::blade_impulse},
      {Quantity::cutting_work, &Measurer::cutting_work},
      {Quantity::connected_parts, &Measurer::parts},
      {Quantity::largest_part_volume, &Measurer::parts},
  };
  for (const auto& [known, function] : functions) {
    if (known == kind) return function;
  }
  return nullptr;
}

template <class T, int D>
double Measurer<T, D>::own_value(const MeasurementCase& m) const {
  const Function function = function_of(m.kind);
  return function ? (this->*function)(m) : no_value;
}

template <class T, int D>
undeformed::FreeSurface<D> Measurer<T, D>::free_surface(int index) const {
  const Body<T, D>& body = state_.bodies[index];
  const std::vector<Point<D>> place = present_corners(body);
  undeformed::FreeSurface<D> surface;
  for (std::size_t f = 0; f < body.surface.facet.size(); ++f) {
    if (!body.surface.is_free[f]) continue;
    auto& corner = surface.emplace_back();
    for (int v = 0; v < D; ++v) corner[v] = place[body.surface.facet[f][v]];
  }
  return surface;
}

template <class T, int D>
std::optional<std::int64_t> Measurer<T, D>::nearest_node(int index, const Vector& point) const {
  const Body<T, D>& body = state_.bodies[index];
  const std::span<const CutSurface<D>> cuts = state_.cut_surfaces(index);
  const Point<D> place = unpadded<D>(point);
  double least = std::numeric_limits<double>::infinity();
  std::int64_t nearest = -1;
  body.for_each_node([&](std::int64_t slot) {
    double square = 0;
    for (int a = 0; a < D; ++a) {
      square += (point[a] - body.start[slot][a]) * (point[a] - body.start[slot][a]);
    }
    if (square >= least || first_crossing<D>(body.start[slot], place, cuts)) return;
    least = square;
    nearest = slot;
  });
  if (nearest < 0) return std::nullopt;
  const double size = std::pow(body.mass[nearest] / body.material.density, 1. / D);
  if (std::sqrt(least) > size * std::sqrt(D)) return std::nullopt;
  return nearest;
}

template <class T, int D>
double Measurer<T, D>::point_displacement(const MeasurementCase& m) const {
  const Body<T, D>& body = state_.bodies[m.body];
  const std::optional<std::int64_t> nearest = nearest_node(m.body, m.point);
  if (!nearest) return no_value;
  return point_based::point_displacement(body, m.point, *nearest, m.axis,
                                         state_.cut_surfaces(m.body));
}

template <class T, int D>
double Measurer<T, D>::value_at(const MeasurementCase& m, const Vector& start) const {
  const std::optional<std::int64_t> nearest = nearest_node(m.body, start);
  if (!nearest) return no_value;
  return point_based::material_value(state_.bodies[m.body], start, *nearest, m.field);
}

template <class T, int D>
double Measurer<T, D>::point_value(const MeasurementCase& m) const {
  return value_at(m, start_of(state_.bodies[m.body], m.point));
}

template <class T, int D>
double Measurer<T, D>::material_value(const MeasurementCase& m) const {
  return value_at(m, m.point);
}

template <class T, int D>
double Measurer<T, D>::mean_value(const MeasurementCase& m) const {
  return point_based::mean_value(state_.bodies[m.body], m, state_.clock.time);
}

template <class T, int D>
double Measurer<T, D>::velocity_error(const MeasurementCase& m) const {
  const Body<T, D>& body = state_.bodies[m.body];
  VelocityError error(m, state_.clock.time);
  body.for_each_node([&](std::int64_t slot) {
    Point<D> u;
    for (int a = 0; a < D; ++a) u[a] = body.velocity[a][slot];
    error.add(padded<D>(body.position(slot)), padded<D>(u), D);
  });
  return error.value();
}

template <class T, int D>
double Measurer<T, D>::blade_impulse(const MeasurementCase& m) const {
  const BladeLoad<D>& blade = state_.blades.at(m.cut);
  return blade.impulse[m.axis] + state_.clock.lag() * blade.force[m.axis];
}

template <class T, int D>
double Measurer<T, D>::cutting_work(const MeasurementCase& m) const {
  const BladeLoad<D>& blade = state_.blades.at(m.cut);
  return blade.work + state_.clock.lag() * blade.power;
}

template <class T, int D>
double Measurer<T, D>::parts(const MeasurementCase& m) const {
  const Body<T, D>& body = state_.bodies[m.body];
  std::vector<std::int32_t> node(body.slots, -1), neighbour;
  std::vector<std::int64_t> first = {0};
  std::vector<double> volumes;
  body.for_each_node([&](std::int64_t slot) {
    node[slot] = static_cast<std::int32_t>(volumes.size());
    volumes.push_back(body.mass[slot] / body.material.density);
  });
  for (const NodeBlock& block : body.blocks) {
    for (int i = 0; i < block.nodes; ++i) {
      body.for_each_bond(block, block.first + i,
                         [&](int, std::int64_t other, const Point<D>&, double) {
                           neighbour.push_back(node[other]);
                         });
      first.push_back(static_cast<std::int64_t>(neighbour.size()));
    }
  }
  const std::vector<double> factors(neighbour.size(), 1);
  ConnectedParts found = connected_parts(first, neighbour, factors, volumes);
  if (m.kind == MeasurementCase::Kind::connected_parts) {
    return static_cast<double>(found.volumes.size());
  }
  if (found.volumes.size() > 1 && !state_.cut_surfaces(m.body).empty()) {
    for (const auto& beyond : state_.cuts[m.body]->cut_cells(body).beyond()) {
      found.volumes[found.part_of[node[beyond.of]]] -= beyond.volume;
      found.volumes[found.part_of[node[beyond.side]]] += beyond.volume;
    }
  }
  return *std::max_element(found.volumes.begin(), found.volumes.end());
}

template <class T, int D>
BodyIntegrals Measurer<T, D>::integrals(int index, const Vector& about) const {
  const Body<T, D>& body = state_.bodies[index];
  BodyIntegrals sum;
  for (const NodeBlock& block : body.blocks) {
    for (std::int64_t slot = block.first; slot < block.first + block.nodes; ++slot) {
      const Point<D> x = body.position(slot);
      Vector r = {}, u = {};
      for (int a = 0; a < D; ++a) {
        r[a] = x[a] - about[a];
        u[a] = body.velocity[a][slot];
      }
      sum.mass += body.mass[slot];
      add_motion(sum, body.mass[slot], r, u);
    }
  }
  add_strain(index, sum);
  return sum;
}

template <class T, int D>
void Measurer<T, D>::add_strain(int index, BodyIntegrals& sum) const {
  const Body<T, D>& body = state_.bodies[index];
  body.for_each_node([&](std::int64_t slot) {
    const NodeState<D> node = node_state(body, body.block_of(slot), slot);
    sum.strain_energy += node.energy;
    sum.volume += body.mass[slot] / body.material.density * node.volume_ratio;
  });
}

template class Measurer<double, 2>;
template class Measurer<double, 3>;
template class Measurer<float, 2>;
template class Measurer<float, 3>;

}  // namespace pliant::point_based
