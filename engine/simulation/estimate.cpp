#include "engine/simulation/estimate.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>
#include <cmath>

#include "engine/case/checks/stability.hpp"
#include "engine/case/method_rules.hpp"
#include "engine/geometry/distance_walk.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/lattice/occupancy.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/method/step_length.hpp"

// For small h, the number of slots times h^d is V + S h, with the volume V and S proportional to
// the surface. Counts on two coarse lattices give both; methods supply the bytes per slot, ghost
// and particle.
namespace pliant {

namespace {

constexpr double most_cells = 1e6;  // of a lattice on which slots are counted
constexpr double program_bytes = 2.4e7;

/// The nearest whole number, at most 10^18: a much too fine spacing may give more.
std::int64_t whole(double count) { return std::llround(std::min(count, 1e18)); }

Box<3> clipped_box(const Case& a_case, const BodyCase& body) {
  Box<3> box = bounding_box(body.geometry);
  for (int a = 0; a < a_case.dimension; ++a) {
    if (!a_case.periodic.axis[a]) continue;
    box.lower[a] = std::max(box.lower[a], a_case.periodic.lower[a]);
    box.upper[a] = std::min(box.upper[a], a_case.periodic.upper[a]);
  }
  return box;
}

double cells_of(const Case& a_case, const Footprint& footprint, const Box<3>& box, double spacing) {
  double cells = 1;
  for (int a = 0; a < a_case.dimension; ++a) {
    cells *= (box.upper[a] - box.lower[a]) / spacing + 2 * footprint.reach;
  }
  return cells;
}

/// Particles and slots of a body on a lattice with the given spacing.
struct Count {
  double particles = 0, slots = 0;
};

template <int D>
Count count_on(const Footprint& footprint, const BodyCase& body, const Box<3>& box,
               double spacing) {
  const bool on_corners = footprint.on_corners;
  const double margin = footprint.margin * spacing, reach = footprint.reach;
  const double centre = on_corners ? 0 : 0.5;
  Cell<D> lower = {}, upper = {};
  for (int a = 0; a < D; ++a) {
    lower[a] = on_corners ? -1 : 0;
    upper[a] = cell_below((box.upper[a] - box.lower[a]) / spacing) - lower[a];
  }
  Occupancy<D> occupancy;
  occupancy.reset(lower, upper, static_cast<int>(std::ceil(reach)));
  DistanceWalk distance(body.geometry, D, 2 * margin);
  Count count;
  for_each_cell<D>(lower, upper, [&](const Cell<D>& cell) {
    Vector x = {};
    for (int a = 0; a < D; ++a) x[a] = box.lower[a] + (cell[a] + centre) * spacing;
    if (distance(x) >= margin) return;
    ++count.particles;
    occupancy.mark(cell);
  });
  occupancy.dilate(reach);
  count.slots = static_cast<double>(occupancy.slots());
  return count;
}

template <int D>
Count count_of(const Case& a_case, const Footprint& footprint, const BodyCase& body) {
  const Box<3> box = clipped_box(a_case, body);
  const double h = a_case.discretisation.spacing;
  double coarse = h;
  while (cells_of(a_case, footprint, box, coarse) > most_cells) coarse *= 1.05;
  const Count fine = count_on<D>(footprint, body, box, coarse);
  if (coarse == h) return fine;
  constexpr double ratio = 1.5;
  const Count coarser = count_on<D>(footprint, body, box, ratio * coarse);
  const double volume = fine.slots * std::pow(coarse, D);
  const double slope =
      (coarser.slots * std::pow(ratio * coarse, D) - volume) / ((ratio - 1) * coarse);
  return {fine.particles * std::pow(coarse / h, D),
          (volume - slope * (coarse - h)) / std::pow(h, D)};
}

template <int D>
Estimate estimate_in(const Case& a_case) {
  Estimate sum;
  double bytes = program_bytes, particles = 0, slots = 0;
  sum.bytes = static_cast<std::size_t>(whole(bytes));
  if (a_case.rules == nullptr || a_case.rules->footprint == nullptr) return sum;
  for (const BodyCase& body : a_case.bodies) {
    const Footprint footprint = a_case.rules->footprint(a_case, body);
    const Count count = count_of<D>(a_case, footprint, body);
    const double ghosts = (count.slots - count.particles) / 2;
    particles += count.particles;
    slots += count.slots;
    bytes += count.slots * footprint.bytes_per_slot + ghosts * footprint.bytes_per_ghost +
             count.particles * footprint.bytes_per_particle;
  }
  sum.bytes = static_cast<std::size_t>(whole(bytes));
  sum.particles = whole(particles);
  sum.slots = whole(slots);
  return sum;
}

/// abs(eps) of the initial velocity at `x` [1/s].
double initial_strain_rate(const BodyCase& body, const Vector& x, double h, int dimension) {
  std::array<Vector, 3> slope = {};  // [along]
  for (int a = 0; a < dimension; ++a) {
    Vector before = x, after = x;
    before[a] -= h / 2;
    after[a] += h / 2;
    const Vector u0 = initial_velocity(body, before), u1 = initial_velocity(body, after);
    for (int i = 0; i < dimension; ++i) slope[a][i] = (u1[i] - u0[i]) / h;
  }
  double square = 0;
  for (int i = 0; i < dimension; ++i) {
    for (int j = 0; j < dimension; ++j) square += std::pow((slope[i][j] + slope[j][i]) / 2, 2);
  }
  return std::sqrt(square);
}

/// The largest of these strain rates over all bodies, at the points of a grid.
double largest_strain_rate(const Case& a_case) {
  constexpr int across = 24;
  double largest = 0;
  for (const BodyCase& body : a_case.bodies) {
    const Box<3> box = clipped_box(a_case, body);
    const int count = static_cast<int>(std::pow(across, a_case.dimension));
    for (int k = 0; k < count; ++k) {
      Vector x = {};
      for (int a = 0, rest = k; a < a_case.dimension; ++a, rest /= across) {
        x[a] = box.lower[a] + (box.upper[a] - box.lower[a]) * (rest % across + 0.5) / across;
      }
      if (signed_distance(body.geometry, x, a_case.dimension) >= 0) continue;
      largest = std::max(
          largest, initial_strain_rate(body, x, a_case.discretisation.spacing, a_case.dimension));
    }
  }
  return largest;
}

/// The step with `time.strain` and the strain rate at the start; impacts may need shorter steps.
double step_of(const Case& a_case) {
  const double rate = is_remeshed(a_case) && !a_case.time.step ? largest_strain_rate(a_case) : 0;
  return asked_step(a_case, fastest_wave(a_case), rate);
}

/// Whether the method shows outputs inside a step, so that no step ends for them.
bool shows_states_within_steps(const Case& a_case) {
  return a_case.rules != nullptr && a_case.rules->shows_states_within_steps;
}

std::int64_t looks_of(const Case& a_case) {
  double looks = 0;
  for (const double every : {a_case.output.every, a_case.output.measure_every}) {
    if (every > 0) looks += a_case.time.end / every;
  }
  return shows_states_within_steps(a_case) ? whole(looks) : 0;
}

std::int64_t steps_of(const Case& a_case) {
  const double step = step_of(a_case);
  if (shows_states_within_steps(a_case))
    return whole(std::ceil(a_case.time.end / step * (1 - 1e-9)));
  std::int64_t steps = 0;
  double time = 0;
  const double end = a_case.time.end;
  const auto& output = a_case.output;
  constexpr std::int64_t enough = 1'000'000;  // output times; more would not change the result
  std::array<std::int64_t, 3> passed = {};
  const std::array<double, 3> every = {output.every, output.measure_every, output.checkpoint_every};
  for (std::int64_t instant = 0; time < end * (1 - 1e-12) && instant < enough; ++instant) {
    double next = end;
    for (int k = 0; k < 3; ++k) {
      if (every[k] > 0) next = std::min(next, every[k] * static_cast<double>(passed[k] + 1));
    }
    for (int k = 0; k < 3; ++k) {
      if (every[k] > 0 && every[k] * static_cast<double>(passed[k] + 1) <= next) ++passed[k];
    }
    steps += whole(std::ceil((next - time) / step * (1 - 1e-9)));
    time = next;
  }
  return steps + whole(std::ceil((end - time) / step * (1 - 1e-9)));
}

}  // namespace

Estimate estimate(const Case& a_case) {
  Estimate size = a_case.dimension == 2 ? estimate_in<2>(a_case) : estimate_in<3>(a_case);
  size.steps = steps_of(a_case);
  size.looks = looks_of(a_case);
  return size;
}

std::string Estimate::text() const {
  if (nodes_are_counted) {
    return fmt::format("{} nodes, {} of memory, {} steps", particles, memory_text(bytes), steps);
  }
  return fmt::format("about {} particles in {} slots, {} of memory, {} steps", particles, slots,
                     memory_text(bytes), steps);
}

void refuse_what_does_not_fit(const Case& a_case, const Estimate& size, std::size_t available) {
  if (size.bytes <= available) return;
  throw InputError(fmt::format(
      "{}: the run needs about {} of memory for {} particles, and {} are available; use "
      "a coarser discretisation.spacing, or --force to try",
      a_case.name, memory_text(size.bytes), size.particles, memory_text(available)));
}

std::string memory_text(std::size_t bytes) {
  const double mega = 1e-6 * static_cast<double>(bytes);
  return mega < 1000 ? fmt::format("{:.0f} MB", mega) : fmt::format("{:.1f} GB", mega / 1000);
}

std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 100 * 3600) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} days", seconds / 86400);
}

}  // namespace pliant
