#include "engine/total_lagrangian/observe/frame.hpp"

#include <algorithm>
#include <map>

#include "engine/method/full_stress.hpp"
#include "engine/method/shown_field.hpp"
#include "engine/total_lagrangian/stress_point.hpp"

namespace pliant::total_lagrangian {

namespace {

/// Stress as xx, yy, zz, xy, yz, xz, then pressure, density and dilatation.
constexpr int stress = 0, pressure = 6, density = 7, dilatation = 8, mean_fields = 9;
using Means = std::array<double, mean_fields>;

template <int D>
Means values_of(const StressPoint<D>& point, double density_at_rest) {
  Means values = {};
  const std::array<double, 6> stress_of_point = full_stress<D>(point.stress, point.pressure);
  std::copy(stress_of_point.begin(), stress_of_point.end(), values.begin() + stress);
  values[pressure] = point.pressure;
  values[density] = density_at_rest / point.volume_ratio;
  values[dilatation] = point.volume_ratio - 1;
  return values;
}

// [slot] means over the cells around a particle, weighted by their filled fractions.
template <class T, int D>
std::vector<Means> means(const Body<T, D>& body) {
  std::vector<Means> sum(body.layout.slots(), Means{});
  std::vector<double> weight(body.layout.slots(), 0);
  for (const Block<D>& block : body.layout.blocks()) {
    body.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (!(body.fraction[p] > 0)) return;
      const Means values = values_of<D>(stress_point<T, D>(body, p, cell), body.material.density);
      for (const std::int64_t q : body.corners(cell)) {
        for (int k = 0; k < mean_fields; ++k) sum[q][k] += body.fraction[p] * values[k];
        weight[q] += body.fraction[p];
      }
    });
  }
  for (std::size_t p = 0; p < sum.size(); ++p) {
    for (double& value : sum[p]) value /= weight[p] > 0 ? weight[p] : 1;
  }
  return sum;
}

// Facets share corners that lie between the same two particles.
template <class T, int D>
FrameSurface take_surface(const State<T, D>& state) {
  FrameSurface surface;
  surface.corners = D;
  std::vector<double> velocity, displacement;
  std::vector<std::int32_t> owners;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const Body<T, D>& body = state.bodies[b];
    std::map<std::pair<std::int32_t, std::int32_t>, std::int64_t> known;
    for (const auto& facet : body.facets) {
      for (const Vertex<D>& v : facet.vertex) {
        const auto number = static_cast<std::int64_t>(owners.size());
        // At a node on the surface, all lines from it end in the same corner.
        const auto [at, is_new] =
            known.insert({{v.first, v.along < 1e-6 ? v.first : v.second}, number});
        surface.vertex.push_back(at->second);
        if (!is_new) continue;
        const Point<D> x = body.position(v);
        for (int a = 0; a < 3; ++a) surface.position.push_back(a < D ? x[a] : 0);
        for (int a = 0; a < D; ++a) {
          displacement.push_back(x[a] - v.start[a]);
          velocity.push_back((1 - v.along) * body.velocity[a][v.first] +
                             v.along * body.velocity[a][v.second]);
        }
        owners.push_back(static_cast<std::int32_t>(b));
      }
    }
  }
  surface.fields = {shown(field_list[Field::velocity], D, std::move(velocity)),
                    shown(field_list[Field::displacement], D, std::move(displacement)),
                    {"body", "1", 1, std::move(owners)}};
  return surface;
}

}  // namespace

template <class T, int D>
Frame take_frame(const State<T, D>& state, const FrameParts& parts) {
  Frame frame;
  frame.real_bytes = sizeof(T);
  frame.time = state.clock.time;
  frame.step = state.clock.step;
  std::vector<double> velocity, displacement, level_set, p_field, rho, sigma, volume_change;
  std::vector<std::int32_t> kinds, owners;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const Body<T, D>& body = state.bodies[b];
    const std::vector<Means> mean = means(body);
    for (const Block<D>& block : body.layout.blocks()) {
      body.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
        if (!body.is_particle(p)) return;
        const Point<D> start = body.place(p, cell);
        for (int a = 0; a < 3; ++a) {
          const bool exists = a < D;
          frame.position.push_back(exists ? start[a] + body.displacement[a][p] : 0);
          if (!exists) continue;
          velocity.push_back(body.velocity[a][p]);
          displacement.push_back(body.displacement[a][p]);
        }
        sigma.insert(sigma.end(), mean[p].begin() + stress, mean[p].begin() + pressure);
        p_field.push_back(mean[p][pressure]);
        rho.push_back(mean[p][density]);
        volume_change.push_back(mean[p][dilatation]);
        level_set.push_back(body.level_set[p]);
        kinds.push_back(static_cast<std::int32_t>(kernels::Kind::interior));
        owners.push_back(static_cast<std::int32_t>(b));
      });
    }
  }
  frame.fields = {shown(field_list[Field::velocity], D, std::move(velocity)),
                  shown(field_list[Field::displacement], D, std::move(displacement)),
                  {"pressure", "Pa", 1, std::move(p_field)},
                  {"density", "kg/m^3", 1, std::move(rho)},
                  {"stress", "Pa", 6, std::move(sigma)},
                  {"dilatation", "1", 1, std::move(volume_change)},
                  shown(field_list[Field::level_set], 1, std::move(level_set)),
                  {"kind", "1", 1, std::move(kinds)},
                  {"body", "1", 1, std::move(owners)}};
  if (parts.surface) frame.surface = take_surface(state);
  return frame;
}

template Frame take_frame<double, 2>(const State<double, 2>&, const FrameParts&);
template Frame take_frame<double, 3>(const State<double, 3>&, const FrameParts&);
template Frame take_frame<float, 2>(const State<float, 2>&, const FrameParts&);
template Frame take_frame<float, 3>(const State<float, 3>&, const FrameParts&);

}  // namespace pliant::total_lagrangian
