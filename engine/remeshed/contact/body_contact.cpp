#include "engine/remeshed/contact/body_contact.hpp"

#include <algorithm>
#include <numeric>

#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/ghosts/fit_evaluator.hpp"
#include "engine/remeshed/runge_kutta.hpp"
#include "engine/remeshed/state/resources.hpp"
#include "kernels/remeshed/ghosts/interface_traction.hpp"

namespace pliant::remeshed {

namespace {

using scheduler::Phase;

// (RP.56): the time in which a gap or an overlap is to close [h/c]. With a shorter time contact
// oscillates; with a longer one bodies sink into each other.
constexpr double closing_time = 15;
// Largest gap of surfaces that touch [h]. With 0, noise of phi would open a pressed surface; with
// more, contact would begin too early, which costs energy.
constexpr double touching_gap = 0.01;

kernels::InterfaceKind converted(ContactLaw law) {
  switch (law) {
    case ContactLaw::frictionless:
      return kernels::InterfaceKind::frictionless;
    case ContactLaw::no_slip:
      return kernels::InterfaceKind::no_slip;
    case ContactLaw::coulomb:
      return kernels::InterfaceKind::coulomb;
    case ContactLaw::tied:
      break;
  }
  return kernels::InterfaceKind::tied;
}

}  // namespace

template <class T, int D>
BodyContact<T, D>::BodyContact(State<T, D>& state, const Case& settings,
                               const kernels::RemeshedTable<T, D>& kernels)
    : state_(state),
      contacts_(settings.contacts),
      kernels_(kernels),
      search_(state, settings.contacts) {}

template <class T, int D>
void BodyContact<T, D>::add_tractions(std::vector<Phase>& phases, int stage) {
  using namespace resource;
  using enum Group;
  PhaseRows(phases).at_stage(stage).each(
      "tractions", all(whole(records)) + near(whole(fits)) + own(whole(contact_points)),
      own(whole(tractions) + whole(contact_impulse)),
      [this, stage](int block) { find_tractions(block, stage); });
}

template <class T, int D>
void BodyContact<T, D>::prepare(double time_step) {
  time_step_ = time_step;
  search_.prepare();
  block_impulse_.assign(state_.blocks.size() * contacts_.size(), {});
  block_friction_.assign(state_.blocks.size(), 0);
}

template <class T, int D>
const std::vector<Point<D>>& BodyContact<T, D>::fold() {
  impulse_.assign(contacts_.size(), {});
  for (std::size_t i = 0; i < block_impulse_.size(); ++i) {
    for (int a = 0; a < D; ++a) impulse_[i % contacts_.size()][a] += block_impulse_[i][a];
  }
  return impulse_;
}

template <class T, int D>
double BodyContact<T, D>::lost_by_friction() const {
  return std::accumulate(block_friction_.begin(), block_friction_.end(), 0.);
}

template <class T, int D>
void BodyContact<T, D>::find_tractions(int block, int stage) {
  const auto [owner, local] = state_.blocks[block];
  const Body<T, D>& own = state_.bodies[owner];
  BlockGhosts<T, D>& ghosts = state_.bodies[owner].population.ghosts[local];
  ContactPoints<T, D>& contact_points = ghosts.contact_points;
  for (std::size_t k = 0; k < contact_points.ghost.size(); ++k) {
    const int c = contact_points.contact[k];
    const bool is_first = contacts_[c].bodies[0] == owner;
    const Body<T, D>& other = state_.bodies[contacts_[c].bodies[is_first ? 1 : 0]];
    const Interaction found =
        interaction(own, other, ghosts, k, contacts_[c], search_.directions(block)[k]);
    contact_points.traction[k] = found.traction;
    // Impulse on the second body: the mean of the two sides.
    const double share = 0.5 * stage_weight[stage] * time_step_ * contact_points.area[k];
    Point<D>& impulse = block_impulse_[block * contacts_.size() + c];
    for (int a = 0; a < D; ++a) impulse[a] += (is_first ? -share : share) * found.traction[a];
    block_friction_[block] += share * found.friction;
  }
}

template <class T, int D>
auto BodyContact<T, D>::interaction(const Body<T, D>& own, const Body<T, D>& other,
                                    const BlockGhosts<T, D>& ghosts, std::size_t point,
                                    const ContactCase& contact,
                                    const ContactDirection<D>& direction) const -> Interaction {
  constexpr int width = kernels::record_width<D>;
  const ContactPoints<T, D>& contact_points = ghosts.contact_points;
  const std::int32_t g = contact_points.ghost[point];
  FitEvaluator<T, D> present(own, ghosts, kernels_);
  std::array<T, width> sum = {};
  for (std::int64_t i = contact_points.begin[point]; i < contact_points.begin[point + 1]; ++i) {
    const T* record =
        other.records.get() + static_cast<std::int64_t>(contact_points.record[i]) * width;
    for (int f = 0; f < width; ++f) sum[f] += contact_points.coefficient[i] * record[f];
  }
  const double speed = std::min<double>(kernels::wave_speed_at_rest(own.material),
                                        kernels::wave_speed_at_rest(other.material));
  const double distance = closing_time * own.lattice.spacing;
  const kernels::GhostFits<T, D> fits = present.of(g);
  auto n = kernels::unit_normal<T, D>(fits.linear);
  T share = 1;  // of the traction on the plane of the contact, on the surface with the normal n
  kernels::VectorOf<T, D> returning = {};
  double closing = 0;
  if (contact.law == ContactLaw::tied) {
    // A tie ignores the level sets: their errors at its ends would shake it.
    for (int a = 0; a < D; ++a) {
      returning[a] = static_cast<T>(direction.parted[a] * speed / distance);
    }
  } else {
    closing = contact_points.gap[point] * speed / distance;
    share = 0;
    for (int a = 0; a < D; ++a) {
      const T of_contact = static_cast<T>(direction.normal[a]);
      share += n[a] * of_contact;
      n[a] = of_contact;
    }
    share = std::max(share, T(0)) * static_cast<T>(direction.cover);
  }
  const kernels::SurfaceLoad<T, D> load = kernels::interface_traction<T, D>(
      {fits.surface, kernels::Impedance<T>(own.material)},
      {{sum.data()}, kernels::Impedance<T>(other.material)}, n, static_cast<T>(closing),
      converted(contact.law), static_cast<T>(contact.friction),
      contact_points.gap[point] < touching_gap * own.lattice.spacing, returning);
  Interaction result{{}, 0};
  for (int a = 0; a < D; ++a) {
    result.traction[a] = share * (load.normal * load.n[a] + load.shear[a]);
  }
  if (contact.law != ContactLaw::coulomb || !kernels::slides<T, D>(load, contact.friction)) {
    return result;
  }
  const auto slip = kernels::slip_velocity<T, D>(fits.surface, {sum.data()}, load.n);
  for (int a = 0; a < D; ++a) result.friction += share * load.shear[a] * slip[a];
  return result;
}

template class BodyContact<double, 2>;
template class BodyContact<double, 3>;
template class BodyContact<float, 2>;
template class BodyContact<float, 3>;

}  // namespace pliant::remeshed
