#include "engine/remeshed/contact/momentum_correction.hpp"

#include <algorithm>

#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/observe/integrals.hpp"
#include "engine/remeshed/resources.hpp"

namespace pliant::remeshed {

namespace {

using scheduler::Phase;

/// Adds m and m u of a block's interior particles.
template <class T, int D>
void add_particles(const Body<T, D>& body, int block, double& mass, Point<D>& momentum) {
  const FieldStore<T, D>& f = body.stage[0];
  const T* m = f.get(Field::mass);
  const Kind* kind = body.population.kind.get();
  std::array<const T*, D> u;
  for (int a = 0; a < D; ++a) u[a] = f.get(Field::velocity, a);
  const Layout<D>& layout = body.population.layout;
  const Block<D>& range = layout.blocks()[block];
  for (int s = range.first_segment; s < range.first_segment + range.segment_count; ++s) {
    const kernels::Segment<D>& segment = layout.segments()[s];
    for (std::int64_t p = segment.first; p < segment.first + segment.count; ++p) {
      if (kind[p] != Kind::interior) continue;
      mass += m[p];
      for (int a = 0; a < D; ++a) momentum[a] += double(m[p]) * u[a][p];
    }
  }
}

/// sum m u/sum m over the interior particles.
template <class T, int D>
Point<D> mean_velocity(const Body<T, D>& body) {
  double mass = 0;
  Point<D> velocity = {};
  for (std::size_t b = 0; b < body.population.layout.blocks().size(); ++b) {
    double mass_of_block = 0;
    Point<D> momentum = {};
    add_particles<T, D>(body, static_cast<int>(b), mass_of_block, momentum);
    mass += mass_of_block;
    for (int a = 0; a < D; ++a) velocity[a] += momentum[a];
  }
  for (double& component : velocity) component /= mass;
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
MomentumCorrection<T, D>::MomentumCorrection(State<T, D>& state, const Case& settings)
    : state_(state), contacts_(settings.contacts), shift_(settings.bodies.size()) {
  if (!contacts_.empty()) state_.momentum_budgets.resize(settings.bodies.size());
}

template <class T, int D>
void MomentumCorrection<T, D>::open() {
  for (std::size_t b = 0; b < state_.momentum_budgets.size(); ++b) {
    const Body<T, D>& body = state_.bodies[b];
    MomentumBudget<D>& budget = state_.momentum_budgets[b];
    budget.mass =
        integrate<T, D>({body, body.population, body.stage[0]}, state_.boundaries, {}).mass;
    budget.momentum = budget_momentum<T, D>(state_, static_cast<int>(b));
  }
}

template <class T, int D>
void MomentumCorrection<T, D>::add_phases(std::vector<Phase>& phases, Impulses impulses) {
  sums_.resize(state_.blocks.size());
  using namespace resource;
  using enum Group;
  PhaseRows rows(phases);
  rows.each("momentum",
            own(particles(velocity) + particles(constants) + whole(kinds) + whole(fits)),
            own(whole(momentum)), [this](int block) { sum(block); });
  rows.reduce("momentum", all(whole(momentum) + whole(contact_impulse) + whole(momentum_budgets)),
              all(whole(momentum_budgets)), [this, impulses = std::move(impulses)] {
                if (impulses) add_impulses(impulses());
                balance();
              });
  rows.each("momentum", all(whole(momentum_budgets)) + own(particles(velocity) + whole(kinds)),
            own(particles(velocity)), [this](int block) { shift(block); });
}

template <class T, int D>
void MomentumCorrection<T, D>::sum(int block) {
  const auto [body, local] = state_.blocks[block];
  const BlockGhosts<T, D>& ghosts = state_.bodies[body].population.ghosts[local];
  const auto is_set = [](std::int8_t i) { return i >= 0; };
  sums_[block] = {0, {}, false};
  sums_[block].is_held = std::any_of(ghosts.wall.begin(), ghosts.wall.end(), is_set) ||
                         std::any_of(ghosts.pressure.begin(), ghosts.pressure.end(), is_set);
  add_particles<T, D>(state_.bodies[body], local, sums_[block].mass, sums_[block].momentum);
}

template <class T, int D>
void MomentumCorrection<T, D>::add_impulses(const std::vector<Point<D>>& impulses) {
  for (std::size_t c = 0; c < impulses.size(); ++c) {
    for (int a = 0; a < D; ++a) {
      state_.contact_impulse[c][a] += impulses[c][a];
      state_.momentum_budgets[contacts_[c].bodies[0]].momentum[a] -= impulses[c][a];
      state_.momentum_budgets[contacts_[c].bodies[1]].momentum[a] += impulses[c][a];
    }
  }
}

template <class T, int D>
void MomentumCorrection<T, D>::balance() {
  of_body_.assign(state_.momentum_budgets.size(), {0, {}, false});
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    Sum& sum = of_body_[state_.blocks[b].body];
    sum.mass += sums_[b].mass;
    sum.is_held = sum.is_held || sums_[b].is_held;
    for (int a = 0; a < D; ++a) sum.momentum[a] += sums_[b].momentum[a];
  }
  for (std::size_t b = 0; b < of_body_.size(); ++b) {
    MomentumBudget<D>& budget = state_.momentum_budgets[b];
    for (int a = 0; a < D; ++a) {
      const double mean = of_body_[b].momentum[a] / of_body_[b].mass;
      if (of_body_[b].is_held) budget.momentum[a] = budget.mass * mean;
      shift_[b][a] = budget.momentum[a] / budget.mass - mean;
    }
  }
}

template <class T, int D>
void MomentumCorrection<T, D>::shift(int block) {
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

template class MomentumCorrection<double, 2>;
template class MomentumCorrection<double, 3>;
template Point<2> budget_momentum<double, 2>(const State<double, 2>&, int);
template Point<3> budget_momentum<double, 3>(const State<double, 3>&, int);
template class MomentumCorrection<float, 2>;
template class MomentumCorrection<float, 3>;
template Point<2> budget_momentum<float, 2>(const State<float, 2>&, int);
template Point<3> budget_momentum<float, 3>(const State<float, 3>&, int);

}  // namespace pliant::remeshed
