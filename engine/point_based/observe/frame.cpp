#include "engine/point_based/observe/frame.hpp"

#include "engine/geometry/padded.hpp"
#include "engine/method/full_stress.hpp"
#include "engine/method/shown_field.hpp"
#include "engine/point_based/forces/node_state.hpp"
#include "engine/point_based/observe/opened_surface.hpp"

namespace pliant::point_based {

namespace {

template <class T, int D>
void add_closed_surface(const Body<T, D>& body, int owner, SurfaceVertices& vertices) {
  const auto first = static_cast<std::int64_t>(vertices.owner.size());
  const std::vector<Point<D>> place = present_corners(body);
  for (std::size_t c = 0; c < place.size(); ++c) {
    const Vector x = padded<D>(place[c]);
    vertices.position.insert(vertices.position.end(), x.begin(), x.end());
    for (int a = 0; a < D; ++a) {
      vertices.displacement.push_back(place[c][a] - body.surface.start[c][a]);
      vertices.velocity.push_back(body.velocity[a][body.surface.node[c]]);
    }
    vertices.owner.push_back(owner);
  }
  for (const auto& facet : body.surface.facet) {
    for (const std::int32_t corner : facet) vertices.vertex.push_back(first + corner);
  }
}

template <class T, int D>
FrameSurface take_surface(const State<T, D>& state) {
  SurfaceVertices vertices;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const auto owner = static_cast<int>(b);
    // A body that blades may cut is shown in one way all the time, so that nothing jumps at the
    // first cut.
    if (b < state.cuts.size() && state.cuts[b]) {
      state.cuts[b]->opened_surface(state.bodies[b]).add(state.bodies[b], owner, vertices);
    } else {
      add_closed_surface(state.bodies[b], owner, vertices);
    }
  }
  FrameSurface surface;
  surface.corners = D;
  surface.position = std::move(vertices.position);
  surface.vertex = std::move(vertices.vertex);
  surface.fields = {shown(field_list[Field::velocity], D, std::move(vertices.velocity)),
                    shown(field_list[Field::displacement], D, std::move(vertices.displacement)),
                    {"body", "1", 1, std::move(vertices.owner)}};
  return surface;
}

}  // namespace

template <class T, int D>
Frame take_frame(const State<T, D>& state, const FrameParts& parts) {
  Frame frame;
  frame.real_bytes = sizeof(T);
  frame.time = state.clock.time;
  frame.step = state.clock.step;
  std::vector<double> velocity, displacement, pressure, density, stress, dilatation;
  std::vector<std::int32_t> kinds, owners;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const Body<T, D>& body = state.bodies[b];
    for (const NodeBlock& block : body.blocks) {
      for (std::int64_t slot = block.first; slot < block.first + block.nodes; ++slot) {
        const Vector x = padded<D>(body.position(slot));
        frame.position.insert(frame.position.end(), x.begin(), x.end());
        for (int a = 0; a < D; ++a) {
          velocity.push_back(body.velocity[a][slot]);
          displacement.push_back(body.displacement[a][slot]);
        }
        const NodeState<D> node = node_state(body, block, slot);
        const std::array<double, 6> sigma = full_stress<D>(node.stress, node.pressure);
        stress.insert(stress.end(), sigma.begin(), sigma.end());
        pressure.push_back(node.pressure);
        density.push_back(body.material.density / node.volume_ratio);
        dilatation.push_back(node.volume_ratio - 1);
        kinds.push_back(static_cast<std::int32_t>(kernels::Kind::interior));
        owners.push_back(static_cast<std::int32_t>(b));
      }
    }
  }
  frame.fields = {shown(field_list[Field::velocity], D, std::move(velocity)),
                  shown(field_list[Field::displacement], D, std::move(displacement)),
                  {"pressure", "Pa", 1, std::move(pressure)},
                  {"density", "kg/m^3", 1, std::move(density)},
                  {"stress", "Pa", 6, std::move(stress)},
                  {"dilatation", "1", 1, std::move(dilatation)},
                  {"kind", "1", 1, std::move(kinds)},
                  {"body", "1", 1, std::move(owners)}};
  if (parts.surface) frame.surface = take_surface(state);
  return frame;
}

template Frame take_frame<double, 2>(const State<double, 2>&, const FrameParts&);
template Frame take_frame<double, 3>(const State<double, 3>&, const FrameParts&);
template Frame take_frame<float, 2>(const State<float, 2>&, const FrameParts&);
template Frame take_frame<float, 3>(const State<float, 3>&, const FrameParts&);

}  // namespace pliant::point_based
