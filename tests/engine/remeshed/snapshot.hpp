#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "tests/engine/remeshed/small_case.hpp"

namespace pliant::test {

/// The values of a solver at one moment, by the names of fields; all components together.
using Snapshot = std::map<std::string, std::vector<double>>;

enum class Slots { all, particles };

/// Fields, kinds and cells of a body's slots, and how its ghosts read them.
inline void add_body(Snapshot& snapshot, const LatticeView& view, Slots which) {
  const auto& population = view.population;
  const auto for_each_chosen = [&](auto&& f) {
    for (const Block<2>& block : population.layout.blocks()) {
      population.layout.for_each_slot(block, [&](std::int64_t slot, const Cell<2>& cell) {
        if (which == Slots::all || population.kind[slot] == Kind::interior) f(slot, cell);
      });
    }
  };
  for_each_chosen([&](std::int64_t slot, const Cell<2>& cell) {
    snapshot["cell"].insert(snapshot["cell"].end(), cell.begin(), cell.end());
    snapshot["kind"].push_back(static_cast<double>(population.kind[slot]));
  });
  for (const remeshed::Declaration& field : remeshed::state_fields) {
    auto& values = snapshot[std::string(field.name)];
    for (const Buffer<double>& component : view.fields[field.field]) {
      for_each_chosen(
          [&](std::int64_t slot, const Cell<2>&) { values.push_back(component[slot]); });
    }
  }
  if (which == Slots::particles) return;
  const auto add = [&](const char* name, const auto& values) {
    snapshot[name].insert(snapshot[name].end(), values.begin(), values.end());
  };
  for (const auto& ghosts : population.ghosts) {
    add("ghost slot", ghosts.slot);
    add("pairs", ghosts.pairs);
    add("distance from walls", ghosts.wall_distance);
    for (const auto& terms : ghosts.terms) {
      add("linear fit", terms.linear);
      add("constrained fit", terms.constrained);
      add("surface fit", terms.surface);
    }
    add("contact", ghosts.contact);
    add("edges of contact", ghosts.edge);
    add("contact height", ghosts.contact_height);
    add("contact area", ghosts.contact_area);
  }
  add("distance from the surface", population.surface_distance);
}

/// Bodies, stress and clock of a solver.
inline Snapshot snapshot_of(const Solver& solver, Slots which = Slots::all) {
  Snapshot snapshot;
  for (const Body& body : solver.state().bodies) {
    add_body(snapshot, {body, body.population, body.stage[0]}, which);
    for (const Buffer<double>& component : body.stress) {
      for_each(body.population, Kind::interior, [&](std::int64_t slot, const Cell<2>&) {
        snapshot["stress"].push_back(component[slot]);
      });
    }
  }
  const remeshed::Clock& clock = solver.clock();
  snapshot["clock"] = {clock.time,
                       static_cast<double>(clock.step),
                       static_cast<double>(clock.remeshings),
                       static_cast<double>(clock.steps_since_remeshing),
                       static_cast<double>(clock.steps_since_reinitialisation),
                       clock.accumulated_strain,
                       clock.deformation,
                       clock.strain_rate,
                       clock.wave_speed};
  for (const auto& wall : solver.state().boundaries.walls) {
    snapshot["walls"].insert(snapshot["walls"].end(), wall.pose().offset.begin(),
                             wall.pose().offset.end());
    snapshot["walls"].push_back(wall.pose().angle);
  }
  for (const auto& impulse : solver.state().wall_impulse) {
    std::vector<double>& values = snapshot["impulse"];
    values.insert(values.end(), impulse.force.begin(), impulse.force.end());
    values.insert(values.end(), impulse.moment.begin(), impulse.moment.end());
  }
  const EnergyBudget energy = *solver.energy_budget();
  snapshot["energy budget"] = {energy.wall_work, energy.load_work, energy.body_force_work,
                               energy.damping};
  return snapshot;
}

/// Names under which two snapshots differ in any bit.
inline std::vector<std::string> differences(const Snapshot& a, const Snapshot& b) {
  const auto same_bits = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  std::vector<std::string> names;
  for (const auto& [name, values] : a) {
    const auto other = b.find(name);
    if (other == b.end() || !std::equal(values.begin(), values.end(), other->second.begin(),
                                        other->second.end(), same_bits)) {
      names.push_back(name);
    }
  }
  for (const auto& [name, values] : b) {
    if (!a.contains(name)) names.push_back(name);
  }
  return names;
}

/// Largest difference of the values under `name`, relative to the largest value; infinite if their
/// numbers differ.
inline double relative_difference(const Snapshot& a, const Snapshot& b, const std::string& name) {
  const std::vector<double>&x = a.at(name), &y = b.at(name);
  if (x.size() != y.size()) return HUGE_VAL;
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    difference = std::max(difference, std::abs(x[i] - y[i]));
    size = std::max(size, std::abs(x[i]));
  }
  return difference == 0 ? 0 : difference / size;
}

}  // namespace pliant::test
