#include "engine/undeformed/solver.hpp"

#include <algorithm>
#include <vector>

#include "engine/method/field_views.hpp"

namespace pliant::undeformed {

template <class T, int D>
std::int64_t Solver<T, D>::particles() const {
  std::int64_t sum = 0;
  for (int b = 0; b < body_count(); ++b) sum += body(b).particles;
  return sum;
}

template <class T, int D>
std::optional<EnergyBudget> Solver<T, D>::energy_budget() const {
  EnergyBudget present = shared().energy;
  add(present, shared().power, shared().clock.lag());
  return present;
}

// The kinetic energy grows with the square of the time from rest, so that a budget extrapolated
// from the middle or the end of a step misses all of it in a run of one step.
template <class T, int D>
Balance Solver<T, D>::balance() {
  Clock& clock = shared().clock;
  const double time = clock.time;
  const T back = static_cast<T>(clock.lag());
  std::vector<std::vector<T>> present;
  for (int b = 0; b < body_count(); ++b) {
    Body<T, D>& of = body(b);
    for (int a = 0; a < D; ++a) {
      T* const displacement = of.displacement[a].get();
      present.emplace_back(displacement, displacement + of.slots);
      for (std::int64_t p = 0; p < of.slots; ++p) displacement[p] -= back * of.velocity[a][p];
    }
  }
  clock.time = clock.velocity_time;
  const Balance balance = {integrals(), energy_budget()};
  clock.time = time;
  auto kept = present.begin();
  for (int b = 0; b < body_count(); ++b) {
    for (Buffer<T>& component : body(b).displacement) {
      std::copy(kept->begin(), kept->end(), component.get());
      ++kept;
    }
  }
  return balance;
}

template <class T, int D>
std::vector<FieldView> Solver<T, D>::fields(int number) const {
  const Body<T, D>& shown = body(number);
  return {field_view<T>("displacement", "m", shown.displacement, shown.slots),
          field_view<T>("velocity", "m/s", shown.velocity, shown.slots),
          field_view<T>("mass", "kg", std::span(&shown.mass, 1), shown.slots)};
}

template <class T, int D>
void Solver<T, D>::take_step(double dt) {
  Clock& clock = shared().clock;
  const double rest = clock.rest();
  const bool begins = rest == 0;
  if (begins) begin_step();
  clock.time = begins || dt < rest - clock.rounding() ? clock.time + dt : clock.step_end;
  if (begins && clock.rest() > 0) store_end();
  if (!begins || clock.rest() > 0) move_to_output();
  show();
}

// Kept apart, as the way back from an output time would be rounded.
template <class T, int D>
void Solver<T, D>::store_end() {
  for (int b = 0; b < body_count(); ++b) {
    Body<T, D>& of = body(b);
    for (int a = 0; a < D; ++a) {
      std::copy_n(of.displacement[a].get(), of.slots, of.end_displacement[a].get());
    }
  }
}

template <class T, int D>
void Solver<T, D>::move_to_output() {
  const T back = static_cast<T>(shared().clock.rest());
  for (int b = 0; b < body_count(); ++b) {
    Body<T, D>& of = body(b);
    for (int a = 0; a < D; ++a) {
      const T* const end = of.end_displacement[a].get();
      const T* const velocity = of.velocity[a].get();
      T* const displacement = of.displacement[a].get();
      for (std::int64_t p = 0; p < of.slots; ++p) displacement[p] = end[p] - back * velocity[p];
    }
  }
}

template class Solver<double, 2>;
template class Solver<double, 3>;
template class Solver<float, 2>;
template class Solver<float, 3>;

}  // namespace pliant::undeformed
