#include "engine/remeshed/neighbours/neighbours.hpp"

#include <algorithm>
#include <cmath>

#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/neighbours/neighbour_lists.hpp"
#include "engine/remeshed/neighbours/stencil_reach.hpp"
#include "engine/remeshed/state/resources.hpp"

// When the stencil is no longer enough.
//
// Between remeshings particles keep their slots. The stencil of n slots on each side (2; with the
// compact kernel 1) contains all neighbours of a particle as long as none from farther away enters
// the support R. Two particles at distance r, with velocities that vary smoothly between them, obey
//
//     d ln r/dt = (u_q - u_p).d/r^2 = the mean of t.eps t along the line between them, t = d/r,
//
// whose absolute value is at most max abs(eps)_2 <= max abs(eps)_F. With E the sum of dt max
// abs(eps)_F,
//
//     r(E2) >= r(E1) exp(-(E2 - E1)).                                                      (RP.24)
//
// Outside the stencil r(0) >= (n + 1) h, so it is complete while (n + 1) h exp(-E) >= R. This bound
// assumes the worst place and the worst direction all the time, and is usually reached much too
// early. Then the closest pair among those n + 1 slots apart is measured, and (RP.24) is applied
// from there; pairs n + 2 apart are still bounded by r(0). If a pair is too close, neighbours are
// searched by position within R + s. The result is complete while (R + s) exp(-(E - E_search)) >=
// R.
//
// All this must hold until the end of the next step, whose strain rate is not known yet. Twice the
// last one is allowed for, but no more than the strain at which a step fails (the solver stops the
// run there). That also bounds the lists: their length grows with exp(d E) of a step, and a step
// above the stability limit strains without limit. A tenth of each bound is a reserve for what eps
// at the particles does not show: the motion between them, and the difference between the sum over
// steps and an integral. Ghosts move with the velocities that the particles near them see, and eps
// of these particles contains them. Parts of a body that meet across a void are not covered by
// (RP.24); they become neighbours at the next search.
namespace pliant::remeshed {

namespace {

using kernels::Kernel;
using scheduler::Phase;

constexpr double usable = 0.9;
constexpr double ahead = 2;  // multiple of the strain of the last step

// ln(1 + s/R) of a search: a wider skin makes lists longer, a narrower one makes searches more
// frequent.
constexpr double least_skin = 0.04;
constexpr double steps_of_skin = 3;
constexpr double largest_skin = largest_step_strain / usable;

double strain_between(double distance, Kernel kernel) {
  return usable * std::log(distance / kernels::support(kernel));
}

}  // namespace

double stencil_strain(Kernel kernel) {
  return strain_between(kernels::stencil_reach(kernel) + 1, kernel);
}

template <class T, int D>
void NeighbourSearch<T, D>::clear() {
  for (Body<T, D>& body : state_.bodies) {
    body.neighbours.are_listed = false;
    body.neighbours.complete_until = stencil_strain(kernel_);
  }
}

template <class T, int D>
bool NeighbourSearch<T, D>::is_due(double time_step) {
  bool any = false;
  for (Body<T, D>& body : state_.bodies) {
    BodyNeighbours<D>& neighbours = body.neighbours;
    neighbours.coming_strain =
        std::min(ahead * time_step * neighbours.strain_rate, largest_step_strain);
    const bool due =
        in_every_step_ || neighbours.strain + neighbours.coming_strain > neighbours.complete_until;
    neighbours.is_measuring_due = due && !neighbours.are_listed && !in_every_step_;
    neighbours.is_search_due = due && !neighbours.is_measuring_due;
    if (due) neighbours.blocks.resize(body.population.layout.blocks().size());
    any = any || due;
  }
  return any;
}

template <class T, int D>
void NeighbourSearch<T, D>::add_strain(const StageResults& results, double time_step) {
  for (std::size_t b = 0; b < state_.bodies.size(); ++b) {
    BodyNeighbours<D>& neighbours = state_.bodies[b].neighbours;
    neighbours.strain_rate = results.strain_rate(b);
    neighbours.strain += time_step * neighbours.strain_rate;
  }
}

template <class T, int D>
std::vector<Phase> NeighbourSearch<T, D>::phases() {
  using namespace resource;
  using enum Group;
  const Resources positions = particles(drift) + ghosts(drift) + whole(kinds);
  std::vector<Phase> phases;
  PhaseRows rows(phases);
  rows.each("stencil reach", near(slots(drift) + whole(kinds)), own(whole(closest_pairs)),
            [this](int block) { measure(block); });
  rows.reduce("stencil reach", all(whole(closest_pairs)),
              all(whole(search_decisions) + whole(neighbour_lists)), [this] { decide(); });
  rows.each("cells", all(whole(search_decisions)) + own(positions), own(whole(sites)),
            [this](int block) {
              const auto [body, local] = state_.owner(block);
              if (body.neighbours.is_search_due) find_sites<T, D>(body, local);
            });
  rows.reduce("cells", all(whole(search_decisions) + whole(sites)), all(whole(cells)), [this] {
    for (Body<T, D>& body : state_.bodies) {
      if (body.neighbours.is_search_due) sort_sites<T, D>(body);
    }
  });
  rows.each("neighbours", all(whole(search_decisions) + whole(cells)) + own(positions),
            own(whole(neighbour_lists)), [this](int block) {
              const auto [body, local] = state_.owner(block);
              if (!body.neighbours.is_search_due) return;
              list_neighbours<T, D>(body, local, kernels::stencil_reach(kernel_), in_every_step_);
            });
  return phases;
}

template <class T, int D>
void NeighbourSearch<T, D>::measure(int block) {
  const auto [body, local] = state_.owner(block);
  if (!body.neighbours.is_measuring_due) return;
  body.neighbours.blocks[local].closest =
      closest_outside<T, D>(body, local, kernels::stencil_reach(kernel_));
}

template <class T, int D>
void NeighbourSearch<T, D>::decide() {
  for (Body<T, D>& body : state_.bodies) {
    BodyNeighbours<D>& neighbours = body.neighbours;
    if (neighbours.is_measuring_due) decide_after_measuring(neighbours);
    if (neighbours.is_search_due) prepare_search(body);
  }
}

template <class T, int D>
void NeighbourSearch<T, D>::decide_after_measuring(BodyNeighbours<D>& neighbours) const {
  double closest = neighbours.blocks[0].closest;
  for (const BlockNeighbours<D>& block : neighbours.blocks) {
    closest = std::min(closest, block.closest);
  }
  neighbours.complete_until =
      std::min(neighbours.strain + strain_between(closest, kernel_),
               strain_between(kernels::stencil_reach(kernel_) + 2, kernel_));
  neighbours.is_search_due =
      neighbours.strain + neighbours.coming_strain > neighbours.complete_until;
}

template <class T, int D>
void NeighbourSearch<T, D>::prepare_search(Body<T, D>& body) const {
  BodyNeighbours<D>& neighbours = body.neighbours;
  const double skin =
      std::clamp(steps_of_skin * neighbours.coming_strain, least_skin, largest_skin);
  neighbours.radius = kernels::support(kernel_) * std::exp(skin);
  neighbours.complete_until = neighbours.strain + strain_between(neighbours.radius, kernel_);
  neighbours.are_listed = true;
  const std::size_t packs = body.population.layout.slots() / Layout<D>::pack;
  neighbours.start.resize(packs);
  neighbours.length.resize(packs);
}

template class NeighbourSearch<double, 2>;
template class NeighbourSearch<double, 3>;
template class NeighbourSearch<float, 2>;
template class NeighbourSearch<float, 3>;

}  // namespace pliant::remeshed
