#include "engine/remeshed/state/check_state.hpp"

#include <fmt/format.h>

#include "engine/remeshed/neighbours/neighbours.hpp"

namespace pliant::remeshed {

namespace {

// Distance from a wall within which the edge of a clamp is the likely cause of a failure [h]. The
// stress there is singular, and no step is short enough for it.
constexpr double edge_of_clamp = 3;

}  // namespace

template <class T, int D>
void check_finite(const Case& settings, const StageResults& results, const State<T, D>& state,
                  Remedies remedies) {
  const std::int64_t slot = results.total().non_finite;
  if (slot < 0) return;
  const Body<T, D>& body = state.bodies[state.blocks[results.failed_block()].body];
  const Point<D> x = body.lattice.node(body.population.layout.cell(slot));
  const std::string what =
      fmt::format("particle {} of body `{}` near {} is no longer finite or has lost its volume",
                  slot, body.name, coordinates<D>(x));
  const auto [wall, distance] = state.boundaries.nearest_wall(x);
  if (distance > edge_of_clamp * body.lattice.spacing) {
    throw failed_step(settings, state.clock, what, remedies(settings));
  }
  throw failed_step(settings, state.clock, what + ", beside a wall that holds it",
                    {"load more slowly", "use a finer spacing"});
}

template <class T, int D>
void check_strain(const Case& settings, const StageResults& results, const State<T, D>& state,
                  double time_step, Remedies remedies) {
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const double strain = time_step * results.strain_rate(b);
    if (strain <= largest_step_strain) continue;
    throw failed_step(
        settings, state.clock,
        fmt::format("body `{}` strained by {:.2g} in one step", state.bodies[b].name, strain),
        remedies(settings));
  }
}

template <class T, int D>
void check_bodies(const Case& settings, const State<T, D>& state, Remedies remedies) {
  for (const Body<T, D>& body : state.bodies) {
    if (body.population.particles > 0) continue;
    std::vector<std::string> all = remedies(settings);
    all.insert(all.begin(), "look at the last frames for where it broke");
    throw failed_step(settings, state.clock,
                      fmt::format("body `{}` has no particle left", body.name), all);
  }
}

template void check_finite<double, 2>(const Case&, const StageResults&, const State<double, 2>&,
                                      Remedies);
template void check_strain<double, 2>(const Case&, const StageResults&, const State<double, 2>&,
                                      double, Remedies);
template void check_bodies<double, 2>(const Case&, const State<double, 2>&, Remedies);
template void check_finite<double, 3>(const Case&, const StageResults&, const State<double, 3>&,
                                      Remedies);
template void check_strain<double, 3>(const Case&, const StageResults&, const State<double, 3>&,
                                      double, Remedies);
template void check_bodies<double, 3>(const Case&, const State<double, 3>&, Remedies);
template void check_finite<float, 2>(const Case&, const StageResults&, const State<float, 2>&,
                                     Remedies);
template void check_strain<float, 2>(const Case&, const StageResults&, const State<float, 2>&,
                                     double, Remedies);
template void check_bodies<float, 2>(const Case&, const State<float, 2>&, Remedies);
template void check_finite<float, 3>(const Case&, const StageResults&, const State<float, 3>&,
                                     Remedies);
template void check_strain<float, 3>(const Case&, const StageResults&, const State<float, 3>&,
                                     double, Remedies);
template void check_bodies<float, 3>(const Case&, const State<float, 3>&, Remedies);

}  // namespace pliant::remeshed
