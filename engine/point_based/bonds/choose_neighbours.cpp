#include "engine/point_based/bonds/choose_neighbours.hpp"

#include <cmath>

#include "engine/point_based/bonds/candidates.hpp"
#include "engine/point_based/parameters.hpp"

namespace pliant::point_based {

// Irregular nodes replace neighbours that cuts remove by nodes farther away.
template <class T, int D>
BondChoice<D> choose_neighbours(const Case& settings, const PlacedNodes<D>& nodes,
                                const Body<T, D>& body, scheduler::Workers& workers) {
  constexpr int candidates_per_neighbour = 3;
  constexpr int searched = 3;  // nodes more for each neighbour, of which some are too small
  BondChoice<D> choice;
  choice.neighbours = neighbour_count(settings);
  choice.support = nodes.support;
  choice.alpha = parameters_of(settings).stabilisation.value_or(nodes.alpha);
  choice.may_change = has_cuts(settings, *body.source);
  const bool is_lattice = !std::isinf(nodes.support);
  const int ranks = !is_lattice && choice.may_change ? candidates_per_neighbour : 1;
  // The patch test balances the forces on the whole body, including those that walls take.
  choice.elastic_volumes = parameters_of(settings).gradient == NodeGradient::patch_exact
                               ? nodes.cloud.volumes
                               : nodes.elastic_volumes;
  const int candidates = ranks * choice.neighbours + 1;
  choice.candidates = find_candidates<D>(
      nodes.stretched(), choice.elastic_volumes,
      is_lattice ? candidates : candidates + searched * choice.neighbours, body.name, workers);
  if (!is_lattice) sort_by_size<D>(candidates, choice.candidates);
  for (auto& list : choice.candidates) {
    const auto most = static_cast<std::size_t>(choice.neighbours);
    if (!is_lattice || list.size() <= most) continue;
    list.resize(whole_shells(most, list[most].distance, D + 1,
                             [&](std::size_t n) { return list[n].distance; }));
  }
  choice.slot_of.resize(nodes.cloud.positions.size());
  for (std::int64_t slot = 0; slot < body.slots; ++slot) {
    if (body.number[slot] >= 0) choice.slot_of[body.number[slot]] = slot;
  }
  return choice;
}

template BondChoice<2> choose_neighbours(const Case&, const PlacedNodes<2>&, const Body<double, 2>&,
                                         scheduler::Workers&);
template BondChoice<3> choose_neighbours(const Case&, const PlacedNodes<3>&, const Body<double, 3>&,
                                         scheduler::Workers&);
template BondChoice<2> choose_neighbours(const Case&, const PlacedNodes<2>&, const Body<float, 2>&,
                                         scheduler::Workers&);
template BondChoice<3> choose_neighbours(const Case&, const PlacedNodes<3>&, const Body<float, 3>&,
                                         scheduler::Workers&);

}  // namespace pliant::point_based
