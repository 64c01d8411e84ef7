#include "engine/remeshed/contact/surface_sampler.hpp"

#include <algorithm>
#include <limits>

#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/contact/opposing_fit.hpp"
#include "engine/remeshed/state/resources.hpp"

namespace pliant::remeshed {

template <class T, int D>
SurfaceSampler<T, D>::SurfaceSampler(State<T, D>& state, const std::vector<ContactCase>& contacts)
    : state_(state),
      contacts_(contacts),
      may_touch_(state.bodies.size()),
      surfaces_(state.bodies.size()) {
  for (const ContactCase& contact : contacts_) {
    for (const int body : contact.bodies) may_touch_[body] = 1;
  }
}

template <class T, int D>
void SurfaceSampler<T, D>::add_phases(std::vector<scheduler::Phase>& phases) {
  using namespace resource;
  using enum Group;
  PhaseRows rows(phases);
  rows.each("contact search: samples",
            own(particles(drift) + ghosts(drift) + particles(constants) + ghosts(constants) +
                whole(fits) + whole(records)),
            own(whole(surface_samples)), [this](int block) { find_samples(block); });
  rows.reduce("contact search: cells", all(whole(surface_samples)),
              all(whole(surface_samples) + whole(surface_cells)), [this] { sort_samples(); });
}

template <class T, int D>
void SurfaceSampler<T, D>::find_samples(int block) {
  const auto [owner, local] = state_.blocks[block];
  std::vector<Sample>& samples = samples_[block];
  samples.clear();
  if (may_touch_[owner] == 0) return;
  const Body<T, D>& body = state_.bodies[owner];
  const Layout<D>& layout = body.population.layout;
  const double h = body.lattice.spacing;
  const T* phi = body.stage[0].get(Field::level_set);
  const auto add = [&](std::int64_t slot, const Cell<D>& cell, std::int32_t record) {
    Sample sample{{{}, 0}, record, phi[slot] / h, {}, {}};
    if (record >= 0) {
      const kernels::RecordSum<T, D> particle{
          body.records.get() + static_cast<std::int64_t>(record) * kernels::record_width<D>};
      for (int a = 0; a < D; ++a) sample.gradient[a] = particle.level_set_gradient(a);
    }
    for (int a = 0; a < D; ++a) {
      const T drift = body.stage[0].get(Field::drift, a)[slot];
      sample.displacement[a] = body.stage[0].get(Field::displacement, a)[slot] + drift;
      sample.site.position[a] = in_first_period<D>(cell[a] + drift / h, body.lattice, a);
    }
    samples.push_back(sample);
  };
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[local];
  const int first_segment = layout.blocks()[local].first_segment;
  for (const kernels::SurfacePack& pack : ghosts.packs) {
    const kernels::Segment<D>& segment = layout.segments()[first_segment + pack.segment];
    Cell<D> cell = segment.cell;
    cell[0] += static_cast<std::int32_t>(pack.first - segment.first);
    std::int32_t record = pack.record;
    for (int l = 0; l < Layout<D>::pack; ++l, ++cell[0]) {
      if (pack.lanes >> l & 1) add(pack.first + l, cell, record++);
    }
  }
  for (const std::int32_t slot : ghosts.slot) add(slot, layout.cell(slot), -1);
}

template <class T, int D>
void SurfaceSampler<T, D>::sort_samples() {
  for (std::size_t body = 0; body < surfaces_.size(); ++body) gather(static_cast<int>(body));
  for (const ContactCase& contact : contacts_) {
    if (!are_near(contact)) continue;
    for (const int body : contact.bodies) surfaces_[body].is_near_another = true;
  }
  for (std::size_t body = 0; body < surfaces_.size(); ++body) {
    SurfaceSamples<D>& surface = surfaces_[body];
    if (!surface.is_near_another) continue;
    const std::size_t count = surface.record.size();
    surface.cells.cover(surface.lower, surface.upper, period_of<D>(state_.bodies[body].lattice),
                        contact_fit_radius, count);
    surface.cells.sort(count, [&](auto&& f) {
      for (std::size_t b = 0; b < samples_.size(); ++b) {
        if (state_.blocks[b].body != static_cast<int>(body)) continue;
        for (const Sample& sample : samples_[b]) f(sample.site);
      }
    });
  }
}

template <class T, int D>
void SurfaceSampler<T, D>::gather(int body) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  SurfaceSamples<D>& surface = surfaces_[body];
  surface.lower.fill(infinity);
  surface.upper.fill(-infinity);
  surface.is_near_another = false;
  surface.record.clear();
  surface.level_set.clear();
  surface.gradient.clear();
  surface.displacement.clear();
  for (std::size_t b = 0; b < samples_.size(); ++b) {
    if (state_.blocks[b].body != body) continue;
    for (Sample& sample : samples_[b]) {
      sample.site.label = static_cast<std::int32_t>(surface.record.size());
      surface.record.push_back(sample.record);
      surface.level_set.push_back(sample.level_set);
      surface.gradient.push_back(sample.gradient);
      surface.displacement.push_back(sample.displacement);
      for (int a = 0; a < D; ++a) {
        surface.lower[a] = std::min(surface.lower[a], sample.site.position[a]);
        surface.upper[a] = std::max(surface.upper[a], sample.site.position[a]);
      }
    }
  }
}

// Boxes include ghosts, so bodies with separate boxes are far from touching.
template <class T, int D>
bool SurfaceSampler<T, D>::are_near(const ContactCase& contact) const {
  const SurfaceSamples<D>& first = surfaces_[contact.bodies[0]];
  const SurfaceSamples<D>& second = surfaces_[contact.bodies[1]];
  const Lattice<D>& lattice = state_.bodies[contact.bodies[0]].lattice;
  const Lattice<D>& other = state_.bodies[contact.bodies[1]].lattice;
  for (int a = 0; a < D; ++a) {
    if (lattice.period[a] != 0) continue;
    const double shift = (other.origin[a] - lattice.origin[a]) / lattice.spacing;
    if (first.lower[a] > second.upper[a] + shift || second.lower[a] + shift > first.upper[a]) {
      return false;
    }
  }
  return true;
}

template class SurfaceSampler<double, 2>;
template class SurfaceSampler<double, 3>;
template class SurfaceSampler<float, 2>;
template class SurfaceSampler<float, 3>;

}  // namespace pliant::remeshed
