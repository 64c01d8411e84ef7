#include "engine/point_based/bonds/balance_bonds.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "engine/point_based/bonds/chosen_bonds.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/bonds/patch_weights.hpp"
#include "engine/point_based/surface/surface_shares.hpp"
#include "engine/undeformed/held_directions.hpp"

// Most nodes of a body on a lattice are regular: a uniform stress exerts no force on them. Only the
// weights of nodes near irregular ones change.
namespace pliant::point_based {

namespace {

// Forces that count as none, over the stress times V^((D-1)/D). Rows of nodes between a wall and a
// lattice yield to forces of either sign in turn, which the stabilisation of a lattice hardly
// resists.
constexpr double no_force = 0.05, no_force_on_lattices = 0.03;
constexpr int layers_that_change = 2;  // of nodes around those with a force
// Larger changes of weights shorten the time step; few nodes of a lattice ask for them.
constexpr double most_change_on_lattices = 4;
constexpr double no_limit = std::numeric_limits<double>::infinity();

/// The nodes that walls hold or guide.
template <class T, int D>
std::vector<std::int64_t> constrained_nodes(const Body<T, D>& body) {
  std::vector<std::int64_t> nodes;
  for (const auto& of_block : body.held) {
    for (const auto& held : of_block) nodes.push_back(body.number[held.slot]);
  }
  return nodes;
}

/// Finds the nodes that bear the forces of attached walls on facets.
template <class T, int D>
class WallBearings {
 public:
  WallBearings(const Body<T, D>& body, const std::vector<Point<D>>& positions,
               const Boundaries<D>& boundaries)
      : nodes_(constrained_nodes(body)),
        places_(places_of(nodes_, positions)),
        nearest_(places_),
        boundaries_(boundaries),
        reach_(0.5 * body.resolution) {}

  /// The part of the area vector of a facet that lies on a wall: the constrained node nearest to it
  /// bears this part. A facet that cuts off the edge beside a wall has another one, too.
  BorneArea<D> of(const std::array<Point<D>, D>& corners, const Point<D>& area) const {
    if (nodes_.empty()) return {};
    Point<D> middle = {};
    for (const Point<D>& corner : corners) {
      if (boundaries_.nearest_wall(corner).second > reach_) return {};
      for (int a = 0; a < D; ++a) middle[a] += corner[a] / D;
    }
    Point<D> part = boundaries_.walls[boundaries_.nearest_wall(middle).first].normal(middle);
    const double along = dot<D>(part, area);
    for (double& component : part) component *= along;
    return {nodes_[nearest_.nearest(middle)], part};
  }

 private:
  static std::vector<Point<D>> places_of(const std::vector<std::int64_t>& nodes,
                                         const std::vector<Point<D>>& positions) {
    std::vector<Point<D>> places;
    places.reserve(nodes.size());
    for (const std::int64_t node : nodes) places.push_back(positions[node]);
    return places;
  }

  std::vector<std::int64_t> nodes_;
  std::vector<Point<D>> places_;
  NearestNodes<D> nearest_;
  const Boundaries<D>& boundaries_;
  double reach_;  ///< [m]
};

/// The balance of the nodes of a body under a uniform stress.
template <class T, int D>
class Balance {
 public:
  Balance(const NodeCloud<D>& cloud, const Body<T, D>& body, const Boundaries<D>& boundaries,
          BondChoice<D>& choice)
      : bonds_(cloud, choice),
        choice_(choice),
        free_(cloud.positions.size(), undeformed::all_directions<D>()),
        count_(cloud.positions.size()) {
    const WallBearings<T, D> walls(body, cloud.positions, boundaries);
    areas_ = surface_shares(body, [&walls](const auto& corners, const Point<D>& area) {
      return walls.of(corners, area);
    });
    for (const auto& [slot, free] : undeformed::held_directions(body)) {
      free_[body.number[slot]] = free;
    }
  }

  void improve(scheduler::Workers& workers) {
    const std::vector<bool> changes = nodes_that_change();
    WeightedNodes<D> part = part_that_changes(changes);
    balance_weights(part, choice_.is_lattice() ? most_change_on_lattices : no_limit, least_force(),
                    workers);
    choice_.correction.resize(changes.size());
    for (std::size_t m = 0; m < members_.size(); ++m) {
      if (!changes[members_[m]]) continue;
      choice_.correction[members_[m]] = factors_of(part.weight[m], bonds_.weights(members_[m]));
    }
  }

 private:
  std::int64_t nodes() const { return static_cast<std::int64_t>(areas_.size()); }

  double least_force() const { return choice_.is_lattice() ? no_force_on_lattices : no_force; }

  /// Adds the forces of the energy of a node to those on its neighbours and itself.
  template <class Add>
  void add_forces(std::int64_t node, const NodeOperator<D>& made, Add&& add) const {
    const double volume = choice_.elastic_volumes[node];
    for (std::size_t k = 0; k < made.gradient.size(); ++k) {
      Point<D> force;
      for (int a = 0; a < D; ++a) force[a] = volume * made.gradient[k][a];
      add(bonds_.neighbour(node, k), 1, force);
      add(node, -1, force);
    }
  }

  /// [node] whether its weights change. Nodes without elastic volume or gradient have no energy;
  /// the latter take any force.
  std::vector<bool> nodes_that_change() {
    std::vector<Point<D>> force(areas_.size());
    const auto add = [&force](std::int64_t node, double sign, const Point<D>& part) {
      for (int a = 0; a < D; ++a) force[node][a] += sign * part[a];
    };
    for (std::int64_t i = 0; i < nodes(); ++i) {
      add(i, -1, areas_[i]);
      const NodeOperator<D> made = bonds_.gradient(i);
      if (made.rank < D) free_[i] = {};
      if (!(choice_.elastic_volumes[i] > 0) || made.rank < D) continue;
      count_[i] = made.gradient.size();
      add_forces(i, made, add);
    }
    std::vector<bool> changes(areas_.size());
    for (std::int64_t i = 0; i < nodes(); ++i) {
      const Point<D> unborne = undeformed::projected<D>(free_[i], force[i]);
      const double area = std::pow(choice_.elastic_volumes[i], (D - 1.) / D);
      changes[i] = norm<D>(unborne) > least_force() * area;
    }
    for (int layer = 0; layer < layers_that_change; ++layer) changes = with_neighbours(changes);
    return changes;
  }

  std::vector<bool> with_neighbours(const std::vector<bool>& inner) const {
    std::vector<bool> all = inner;
    for (std::int64_t i = 0; i < nodes(); ++i) {
      for (std::size_t k = 0; k < count_[i]; ++k) {
        const std::int32_t j = bonds_.neighbour(i, k);
        if (inner[i]) all[j] = true;
        if (inner[j]) all[i] = true;
      }
    }
    return all;
  }

  /// The nodes that change, with those around them, which keep their weights: these forces count as
  /// areas.
  WeightedNodes<D> part_that_changes(const std::vector<bool>& changes) {
    const std::vector<bool> takes_part = with_neighbours(changes);
    std::vector<std::int32_t> number(changes.size(), -1);
    WeightedNodes<D> part;
    for (std::int64_t i = 0; i < nodes(); ++i) {
      if (!takes_part[i]) continue;
      number[i] = static_cast<std::int32_t>(members_.size());
      members_.push_back(i);
      part.positions.push_back(bonds_.place(i));
      part.volumes.push_back(choice_.elastic_volumes[i]);
      part.areas.push_back(areas_[i]);
      part.free.push_back(free_[i]);
    }
    part.weight.resize(members_.size());
    part.neighbour.resize(members_.size());
    const auto add = [&](std::int64_t node, double sign, const Point<D>& force) {
      if (number[node] < 0) return;
      for (int a = 0; a < D; ++a) part.areas[number[node]][a] -= sign * force[a];
    };
    for (const std::int64_t i : members_) {
      if (!changes[i] || count_[i] == 0) continue;
      part.weight[number[i]] = bonds_.weights(i);
      for (std::size_t k = 0; k < count_[i]; ++k) {
        part.neighbour[number[i]].push_back(number[bonds_.neighbour(i, k)]);
      }
    }
    for (std::int64_t i = 0; i < nodes(); ++i) {
      if (changes[i] || count_[i] == 0) continue;
      bool reaches = takes_part[i];
      for (std::size_t k = 0; k < count_[i]; ++k) {
        reaches = reaches || takes_part[bonds_.neighbour(i, k)];
      }
      if (reaches) add_forces(i, bonds_.gradient(i), add);
    }
    return part;
  }

  ChosenBonds<D> bonds_;
  BondChoice<D>& choice_;
  /// [node] the directions in which no wall takes the force, as in WeightedNodes
  std::vector<std::array<double, D * D>> free_;
  std::vector<std::size_t> count_;  ///< [node] of its bonds that have an energy
  std::vector<Point<D>> areas_;     ///< [node] (PB.51)
  std::vector<std::int64_t> members_;
};

}  // namespace

template <class T, int D>
void balance_bonds(const NodeCloud<D>& cloud, const Body<T, D>& body,
                   const Boundaries<D>& boundaries, BondChoice<D>& choice,
                   scheduler::Workers& workers) {
  Balance<T, D>(cloud, body, boundaries, choice).improve(workers);
}

template void balance_bonds(const NodeCloud<2>&, const Body<double, 2>&, const Boundaries<2>&,
                            BondChoice<2>&, scheduler::Workers&);
template void balance_bonds(const NodeCloud<3>&, const Body<double, 3>&, const Boundaries<3>&,
                            BondChoice<3>&, scheduler::Workers&);
template void balance_bonds(const NodeCloud<2>&, const Body<float, 2>&, const Boundaries<2>&,
                            BondChoice<2>&, scheduler::Workers&);
template void balance_bonds(const NodeCloud<3>&, const Body<float, 3>&, const Boundaries<3>&,
                            BondChoice<3>&, scheduler::Workers&);

}  // namespace pliant::point_based
