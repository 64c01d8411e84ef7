#include "engine/remeshed/observe/frame.hpp"

#include "engine/method/full_stress.hpp"
#include "engine/method/shown_field.hpp"
#include "engine/remeshed/contact/wall_contact.hpp"
#include "engine/remeshed/observe/point_state.hpp"
#include "engine/remeshed/observe/surface_mesh.hpp"

namespace pliant::remeshed {

namespace {

struct Selection {
  int body;
  std::int64_t slot;
  std::array<double, 3> position;
};

template <class T, int D>
std::vector<Selection> select(const State<T, D>& state, bool with_ghosts) {
  std::vector<Selection> chosen;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const Body<T, D>& body = state.bodies[b];
    for (const Block<D>& block : body.population.layout.blocks()) {
      body.population.layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
        const Kind kind = body.population.kind[p];
        if (kind == Kind::vacant || (kind != Kind::interior && !with_ghosts)) return;
        Selection s{static_cast<int>(b), p, {}};
        const Point<D> x = body.position(p, cell);
        for (int a = 0; a < D; ++a) s.position[a] = x[a];
        chosen.push_back(s);
      });
    }
  }
  return chosen;
}

template <class T, int D>
std::array<double, 6> stress_of(const Body<T, D>& body, std::int64_t p) {
  std::array<double, kernels::symmetric_components<D>> stress;
  for (std::size_t c = 0; c < stress.size(); ++c) stress[c] = body.stress[c][p];
  return full_stress<D>(stress, pressure<T, D>(body, body.stage[0], p));
}

template <class T, int D>
FrameSurface take_surface(const Boundaries<D>& boundaries,
                          const std::vector<LatticeView<T, D>>& views) {
  FrameSurface surface;
  surface.corners = D;
  std::vector<double> velocity, displacement;
  std::vector<std::int32_t> owners;
  for (std::size_t b = 0; b < views.size(); ++b) {
    const auto& fields = views[b].fields;
    const auto mesh = surface_mesh<T, D>(views[b], boundaries);
    const auto first = static_cast<std::int64_t>(surface.position.size() / 3);
    for (const auto& piece : mesh.pieces) {
      for (const std::int64_t v : piece) surface.vertex.push_back(first + v);
    }
    for (const SurfaceVertex<D>& v : mesh.vertices) {
      for (int a = 0; a < 3; ++a) surface.position.push_back(a < D ? v.place[a] : 0);
      for (int a = 0; a < D; ++a) {
        velocity.push_back(v.interpolated(fields.get(Field::velocity, a)));
        displacement.push_back(v.interpolated(fields.get(Field::displacement, a)));
      }
      owners.push_back(static_cast<std::int32_t>(b));
    }
  }
  surface.fields.push_back(shown(field_list[Field::velocity], D, std::move(velocity)));
  surface.fields.push_back(shown(field_list[Field::displacement], D, std::move(displacement)));
  surface.fields.push_back({"body", "1", 1, std::move(owners)});
  return surface;
}

template <class T, int D>
std::vector<std::vector<double>> wall_pressures(const State<T, D>& state,
                                                const Surroundings<D>& around,
                                                const kernels::RemeshedTable<T, D>& kernels) {
  std::vector<std::vector<double>> pressures;
  for (const Body<T, D>& body : state.bodies) {
    pressures.push_back(wall_pressure<T, D>(body, around, kernels));
  }
  return pressures;
}

}  // namespace

template <class T, int D>
Frame take_frame(const State<T, D>& state, const kernels::RemeshedTable<T, D>& kernels,
                 const NodeSource<T, D>& find_nodes,
                 const std::function<Surroundings<D>()>& find_surroundings,
                 const FrameParts& parts) {
  const auto& bodies = state.bodies;
  const std::vector<Selection> chosen = select(state, parts.ghosts);
  Frame frame;
  frame.real_bytes = sizeof(T);
  frame.time = state.clock.time;
  frame.step = state.clock.step;
  for (const Selection& s : chosen) {
    frame.position.insert(frame.position.end(), s.position.begin(), s.position.end());
  }
  const auto values_of = [&](int components, auto value) {
    std::vector<double> values;
    values.reserve(chosen.size() * components);
    for (const Selection& s : chosen) {
      for (int c = 0; c < components; ++c) values.push_back(value(bodies[s.body], s.slot, c));
    }
    return values;
  };
  const auto add = [&](Field field, int components, auto value) {
    frame.fields.push_back(shown(field_list[field], components, values_of(components, value)));
  };
  const auto add_derived = [&](const char* name, const char* unit, auto value) {
    frame.fields.push_back({name, unit, 1, values_of(1, value)});
  };
  using B = Body<T, D>;
  add(Field::velocity, D, [](const B& body, std::int64_t p, int c) {
    return body.stage[0].get(Field::velocity, c)[p];
  });
  add(Field::displacement, D, [](const B& body, std::int64_t p, int c) {
    return body.stage[0].get(Field::displacement, c)[p] + body.stage[0].get(Field::drift, c)[p];
  });
  add_derived("pressure", "Pa", [](const B& body, std::int64_t p, int) {
    return pressure<T, D>(body, body.stage[0], p);
  });
  add_derived("density", "kg/m^3", [](const B& body, std::int64_t p, int) {
    return density<T, D>(body.stage[0], p) / body.mass_scaling;
  });
  add(Field::stress, 6, [](const B& body, std::int64_t p, int c) { return stress_of(body, p)[c]; });
  add(Field::level_set, 1,
      [](const B& body, std::int64_t p, int) { return body.stage[0].get(Field::level_set)[p]; });
  if (parts.ghosts && state.boundaries.have_contact()) {
    const std::vector<std::vector<double>> pressures =
        wall_pressures<T, D>(state, find_surroundings(), kernels);
    std::vector<double> values;
    values.reserve(chosen.size());
    for (const Selection& s : chosen) values.push_back(pressures[s.body][s.slot]);
    frame.fields.push_back({"wall_pressure", "Pa", 1, std::move(values)});
  }
  std::vector<std::int32_t> kinds, owners;
  for (const Selection& s : chosen) {
    kinds.push_back(static_cast<std::int32_t>(bodies[s.body].population.kind[s.slot]));
    owners.push_back(s.body);
  }
  frame.fields.push_back(shown(field_list[Field::kind], 1, std::move(kinds)));
  frame.fields.push_back({"body", "1", 1, std::move(owners)});
  if (parts.surface) frame.surface = take_surface<T, D>(state.boundaries, find_nodes());
  return frame;
}

template Frame take_frame<double, 2>(const State<double, 2>&,
                                     const kernels::RemeshedTable<double, 2>&,
                                     const NodeSource<double, 2>&,
                                     const std::function<Surroundings<2>()>&, const FrameParts&);
template Frame take_frame<double, 3>(const State<double, 3>&,
                                     const kernels::RemeshedTable<double, 3>&,
                                     const NodeSource<double, 3>&,
                                     const std::function<Surroundings<3>()>&, const FrameParts&);
template Frame take_frame<float, 2>(const State<float, 2>&, const kernels::RemeshedTable<float, 2>&,
                                    const NodeSource<float, 2>&,
                                    const std::function<Surroundings<2>()>&, const FrameParts&);
template Frame take_frame<float, 3>(const State<float, 3>&, const kernels::RemeshedTable<float, 3>&,
                                    const NodeSource<float, 3>&,
                                    const std::function<Surroundings<3>()>&, const FrameParts&);

}  // namespace pliant::remeshed
