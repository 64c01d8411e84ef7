#include "engine/remeshed/setup/setup.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/signed_distance.hpp"
#include "engine/method/gravity.hpp"
#include "engine/remeshed/parameters.hpp"
#include "engine/remeshed/setup/deep_walls.hpp"
#include "kernels/with_scalar.hpp"

namespace pliant::remeshed {

template <int D>
Lattice<D> body_lattice(const Case& settings, const BodyCase& body) {
  Lattice<D> lattice;
  const double h = lattice.spacing = settings.discretisation.spacing;
  const Box<3> box = bounding_box(body.geometry);
  for (int a = 0; a < D; ++a) {
    if (settings.periodic.axis[a]) {
      lattice.origin[a] = settings.periodic.lower[a];
      lattice.period[a] = static_cast<std::int32_t>(
          std::lround((settings.periodic.upper[a] - settings.periodic.lower[a]) / h));
      continue;
    }
    const double centre = (box.lower[a] + box.upper[a]) / 2;
    const bool odd = std::lround((box.upper[a] - box.lower[a]) / h) % 2 != 0;
    lattice.origin[a] = odd ? centre - h / 2 : centre;
  }
  return lattice;
}

namespace {

template <class T, int D>
void set_up(const Case& settings, const BodyCase& source, bool bears_loads, Body<T, D>& body) {
  body.name = source.name;
  body.source = &source;
  body.material = kernels::with_scalar<T>(source.material);
  body.mass_scaling = parameters_of(settings).mass_scaling;
  body.material.density *= static_cast<T>(body.mass_scaling);
  body.bears_loads = bears_loads;
  for (const kernels::PronyTerm<double>& term : source.prony) {
    body.prony.push_back({static_cast<T>(term.ratio), static_cast<T>(term.time)});
  }
  body.lattice = body_lattice<D>(settings, source);
  for (int buffer = 0; buffer < 3; ++buffer) {
    body.stage[buffer] =
        FieldStore<T, D>(body.material.model, static_cast<int>(body.prony.size()), buffer);
  }
}

}  // namespace

template <class T, int D>
State<T, D> make_state(const Case& settings) {
  State<T, D> state{{}, Boundaries<D>(with_deep_walls(settings)), {}, {}, {}, {}, {}, {}, {}, {}};
  state.clock.damping = settings.discretisation.damping.value_or(0);
  state.wall_impulse.resize(state.boundaries.walls.size());
  state.remeshed_poses.resize(state.boundaries.walls.size());
  state.contact_impulse.resize(settings.contacts.size());
  state.bodies.resize(settings.bodies.size());
  const auto is_tied = [](const ContactCase& contact) { return contact.law == ContactLaw::tied; };
  const bool bears_loads = !state.boundaries.pressures.empty() || Gravity<D>(settings).acts() ||
                           std::ranges::any_of(settings.contacts, is_tied);
  state.motion_budgets.resize(settings.bodies.size());
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    set_up(settings, settings.bodies[b], bears_loads, state.bodies[b]);
  }
  return state;
}

template State<double, 2> make_state<double, 2>(const Case&);
template State<double, 3> make_state<double, 3>(const Case&);
template State<float, 2> make_state<float, 2>(const Case&);
template State<float, 3> make_state<float, 3>(const Case&);
template Lattice<2> body_lattice<2>(const Case&, const BodyCase&);
template Lattice<3> body_lattice<3>(const Case&, const BodyCase&);

}  // namespace pliant::remeshed
