#include "engine/remeshed/contact/contact_momentum_correction.hpp"

#include <algorithm>

#include "engine/method/decompositions.hpp"
#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/ghosts/record_loads.hpp"
#include "engine/remeshed/observe/integrals.hpp"
#include "engine/remeshed/state/resources.hpp"

namespace pliant::remeshed {

namespace {

using scheduler::Phase;

constexpr double no_wall = 1e-9;  ///< of sums of n n: no wall pushes along this direction

/// The part of a vector in the directions in which walls push, from the sum of their n n.
template <int D>
Point<D> along_normals(const std::array<double, D * D>& normals, const Point<D>& vector) {
  using Tensor = Eigen::Matrix<double, D, D>;
  const Tensor sum = Eigen::Map<const Tensor>(normals.data());
  const Eigen::Map<const Eigen::Matrix<double, D, 1>> whole(vector.data());
  Point<D> part = {};
  if (sum.trace() == 0) return part;
  const Eigensystem<D> walls = eigensystem<D>(sum);
  for (int i = 0; i < D; ++i) {
    if (walls.values[i] < no_wall * sum.trace()) continue;
    const double along = walls.vectors.col(i).dot(whole);
    for (int a = 0; a < D; ++a) part[a] += along * walls.vectors(a, i);
  }
  return part;
}

/// sum m u/sum m over the interior particles.
template <class T, int D>
Point<D> mean_velocity(const Body<T, D>& body) {
  ParticleMomentum<D> sum;
  for (std::size_t b = 0; b < body.population.layout.blocks().size(); ++b) {
    add<D>(sum, particle_momentum<T, D>(body, static_cast<int>(b), body.stage[0]));
  }
  Point<D> velocity = sum.momentum;
  for (double& component : velocity) component /= sum.mass;
  return velocity;
}

}  // namespace

template <class T, int D>
Point<D> budget_momentum(const State<T, D>& state, int body) {
  Point<D> momentum = mean_velocity<T, D>(state.bodies[body]);
  for (double& component : momentum) component *= state.momentum_budgets[body].mass;
  return momentum;
}

template <class T, int D>
ContactMomentumCorrection<T, D>::ContactMomentumCorrection(State<T, D>& state, const Case& settings)
    : state_(state),
      contacts_(settings.contacts),
      of_body_(settings.bodies.size()),
      shift_(settings.bodies.size()) {
  if (!contacts_.empty() || state_.boundaries.have_contact()) {
    state_.momentum_budgets.resize(settings.bodies.size());
  }
}

template <class T, int D>
void ContactMomentumCorrection<T, D>::open() {
  for (std::size_t b = 0; b < state_.momentum_budgets.size(); ++b) {
    const Body<T, D>& body = state_.bodies[b];
    MomentumBudget<D>& budget = state_.momentum_budgets[b];
    budget.mass =
        body.mass_scaling *
        integrate<T, D>({body, body.population, body.stage[0]}, state_.boundaries, {}).mass;
    budget.momentum = budget_momentum<T, D>(state_, static_cast<int>(b));
  }
}

template <class T, int D>
void ContactMomentumCorrection<T, D>::add_phases(std::vector<Phase>& phases,
                                                 std::function<Impulses()> impulses) {
  sums_.resize(state_.blocks.size());
  using namespace resource;
  using enum Group;
  PhaseRows rows(phases);
  rows.each("momentum",
            own(particles(velocity) + particles(constants) + whole(kinds) + whole(fits)),
            own(whole(momentum)), [this](int block) { sum(block); });
  rows.reduce(
      "momentum",
      all(whole(momentum) + whole(contact_impulse) + whole(wall_impulse) + whole(momentum_budgets)),
      all(whole(momentum_budgets)), [this, impulses = std::move(impulses)] {
        fold_blocks();
        if (impulses) add_impulses(impulses());
        balance();
      });
  rows.each("momentum", all(whole(momentum_budgets)) + own(particles(velocity) + whole(kinds)),
            own(particles(velocity)), [this](int block) { shift(block); });
}

template <class T, int D>
void ContactMomentumCorrection<T, D>::sum(int block) {
  const auto [body, local] = state_.blocks[block];
  const BlockGhosts<T, D>& ghosts = state_.bodies[body].population.ghosts[local];
  Sum& sum = sums_[block] = {};
  sum.is_held =
      std::ranges::any_of(ghosts.pressure, [](std::int8_t load) { return load != no_load; });
  for (std::size_t g = 0; g < ghosts.wall.size(); ++g) {
    if (ghosts.wall[g] < 0) continue;
    const Wall<D>& wall = state_.boundaries.walls[ghosts.wall[g]];
    sum.is_held = sum.is_held || wall.is_attached();
    const Point<D>& n = ghosts.normal[g];
    for (int i = 0; i < D * D; ++i) sum.normals[i] += n[i / D] * n[i % D];
  }
  add<D>(sum, particle_momentum<T, D>(state_.bodies[body], local, state_.bodies[body].stage[0]));
}

template <class T, int D>
void ContactMomentumCorrection<T, D>::fold_blocks() {
  of_body_.assign(of_body_.size(), {});
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    Sum& sum = of_body_[state_.blocks[b].body];
    add<D>(sum, sums_[b]);
    sum.is_held = sum.is_held || sums_[b].is_held;
    for (int i = 0; i < D * D; ++i) sum.normals[i] += sums_[b].normals[i];
  }
}

template <class T, int D>
void ContactMomentumCorrection<T, D>::add_impulses(const Impulses& impulses) {
  for (std::size_t b = 0; b < impulses.of_body_forces.size(); ++b) {
    const int body = state_.blocks[b].body;
    MomentumBudget<D>& budget = state_.momentum_budgets[body];
    for (int a = 0; a < D; ++a) {
      budget.momentum[a] += budget.mass / of_body_[body].mass * impulses.of_body_forces[b][a];
    }
  }
  crossed_ = impulses.of_contacts;
  find_gains();
  follow_free_bodies<D>(contacts_, gains_, crossed_);
  for (std::size_t c = 0; c < crossed_.size(); ++c) {
    for (int a = 0; a < D; ++a) {
      const double impulse = crossed_[c][a];
      state_.contact_impulse[c][a] += impulse;
      state_.momentum_budgets[contacts_[c].bodies[0]].momentum[a] -= impulse;
      state_.momentum_budgets[contacts_[c].bodies[1]].momentum[a] += impulse;
    }
  }
  add_friction(impulses);
}

// Momentum along the normals of walls is unknown, so that bodies near walls count as held.
template <class T, int D>
void ContactMomentumCorrection<T, D>::find_gains() {
  gains_.resize(of_body_.size());
  for (std::size_t b = 0; b < of_body_.size(); ++b) {
    const Sum& sum = of_body_[b];
    const MomentumBudget<D>& budget = state_.momentum_budgets[b];
    gains_[b].is_free = !sum.is_held;
    for (int a = 0; a < D; ++a) {
      if (sum.normals[a * (D + 1)] > 0) gains_[b].is_free = false;
      gains_[b].gained[a] = budget.mass * sum.momentum[a] / sum.mass - budget.momentum[a];
    }
  }
}

// (RP.98). The part along the normals is later removed with the unknown impulses.
template <class T, int D>
void ContactMomentumCorrection<T, D>::add_friction(const Impulses& impulses) {
  const std::size_t walls = state_.boundaries.walls.size();
  for (std::size_t i = 0; i < impulses.of_walls.size(); ++i) {
    const Wall<D>& wall = state_.boundaries.walls[i % walls];
    if (wall.is_attached() || wall.slips()) continue;
    Point<D>& momentum = state_.momentum_budgets[state_.blocks[i / walls].body].momentum;
    for (int a = 0; a < D; ++a) momentum[a] += impulses.of_walls[i][a];
  }
  for (std::size_t b = 0; b < impulses.sticks.size(); ++b) {
    if (impulses.sticks[b] != 0) of_body_[state_.blocks[b].body].is_held = true;
  }
}

template <class T, int D>
void ContactMomentumCorrection<T, D>::balance() {
  for (std::size_t b = 0; b < of_body_.size(); ++b) {
    const Sum& sum = of_body_[b];
    MomentumBudget<D>& budget = state_.momentum_budgets[b];
    Point<D> shift;
    for (int a = 0; a < D; ++a) {
      shift[a] = budget.momentum[a] / budget.mass - sum.momentum[a] / sum.mass;
    }
    const Point<D> unknown = sum.is_held ? shift : along_normals<D>(sum.normals, shift);
    for (int a = 0; a < D; ++a) {
      shift_[b][a] = shift[a] - unknown[a];
      budget.momentum[a] -= budget.mass * unknown[a];
    }
  }
}

template <class T, int D>
void ContactMomentumCorrection<T, D>::shift(int block) {
  const auto [owner, local] = state_.blocks[block];
  Body<T, D>& body = state_.bodies[owner];
  const Layout<D>& layout = body.population.layout;
  const Kind* kind = body.population.kind.get();
  const Block<D>& range = layout.blocks()[local];
  for (int a = 0; a < D; ++a) {
    T* u = body.stage[0].get(Field::velocity, a);
    const T by = static_cast<T>(shift_[owner][a]);
    for (int s = range.first_segment; s < range.first_segment + range.segment_count; ++s) {
      const kernels::Segment<D>& segment = layout.segments()[s];
      for (std::int64_t p = segment.first; p < segment.first + segment.count; ++p) {
        if (kind[p] == Kind::interior) u[p] += by;
      }
    }
  }
}

template class ContactMomentumCorrection<double, 2>;
template class ContactMomentumCorrection<double, 3>;
template Point<2> budget_momentum<double, 2>(const State<double, 2>&, int);
template Point<3> budget_momentum<double, 3>(const State<double, 3>&, int);
template class ContactMomentumCorrection<float, 2>;
template class ContactMomentumCorrection<float, 3>;
template Point<2> budget_momentum<float, 2>(const State<float, 2>&, int);
template Point<3> budget_momentum<float, 3>(const State<float, 3>&, int);

}  // namespace pliant::remeshed
