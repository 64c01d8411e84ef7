#pragma once

#include <vector>

#include "engine/boundaries/walls.hpp"
#include "engine/case/checks/check.hpp"
#include "engine/case/vocabulary/method_keys.hpp"
#include "engine/geometry/signed_distance.hpp"
#include "engine/method/archived_clock.hpp"
#include "engine/method/initial_velocity.hpp"
#include "engine/method/registry.hpp"

namespace pliant::test {

/// The table [free_flight] of a case file.
struct FreeFlightParameters {
  double drag = 0;  ///< rate at which the velocity decays [1/s]
};

inline double drag_of(const Case& a_case) {
  return a_case.parameters.as<FreeFlightParameters>().drag;
}

inline void visit_keys(MethodKeys& visit, MethodParameters& parameters) {
  visit("drag", parameters.as<FreeFlightParameters>().drag,
        {.meaning = "rate at which the velocity decays",
         .unit = "1/s",
         .example = "0.5",
         .limits = not_negative});
}

inline void check_flight(const Check& check) {
  refuse_tables(check, {"contact"});
  if (check.a_case.time.step) return;
  check.problems.add(check.place("time", "step"), "free flight has no CFL number",
                     "give time.step in seconds");
}

/// The factor of a step, 1 - drag dt, is unstable above drag dt = 2.
inline StepLimits limits_of_flight(const Case& a_case) {
  StepLimits limits;
  const double waves = kernels::wave_speed_at_rest(a_case.bodies.at(0).material);
  limits.stable_cfl = 2 / drag_of(a_case) * waves / a_case.discretisation.spacing;
  limits.bounds_given_steps = true;
  return limits;
}

/// The smallest method: particles on a grid in every body, which keep their initial velocity apart
/// from drag.
class FreeFlight final : public pliant::Solver {
 public:
  FreeFlight(const Case& a_case, const SolverOptions& options)
      : pliant::Solver(a_case, options), graph_(phases(), scheduler::Blocks{{{}}}, {"position"}) {
    const double h = settings().discretisation.spacing;
    for (const BodyCase& body : settings().bodies) {
      const Box<3> box = bounding_box(body.geometry);
      for (double x = box.lower[0] + h / 2; x < box.upper[0]; x += h) {
        for (double y = box.lower[1] + h / 2; y < box.upper[1]; y += h) {
          position_.push_back({x, y, 0});
          velocity_.push_back(initial_velocity(body, position_.back()));
          mass_.push_back(body.material.density * h * h);
        }
      }
    }
  }

  const StepClock& clock() const override { return clock_; }
  double time_step() const override { return *settings().time.step; }
  std::int64_t particles() const override { return static_cast<std::int64_t>(mass_.size()); }
  std::size_t bytes() const override {
    return mass_.size() * (2 * sizeof(Vector) + sizeof(double));
  }

  BodyIntegrals integrals() override {
    BodyIntegrals sum;
    for (std::size_t p = 0; p < mass_.size(); ++p) {
      sum.mass += mass_[p];
      add_motion(sum, mass_[p], position_[p], velocity_[p]);
    }
    return sum;
  }

  Frame frame(const FrameParts&) override {
    Frame frame;
    frame.time = clock_.time;
    frame.step = clock_.step;
    FrameField velocity{"velocity", "m/s", 3, std::vector<double>()};
    for (std::size_t p = 0; p < mass_.size(); ++p) {
      frame.position.insert(frame.position.end(), position_[p].begin(), position_[p].end());
      auto& values = std::get<std::vector<double>>(velocity.values);
      values.insert(values.end(), velocity_[p].begin(), velocity_[p].end());
    }
    frame.fields.push_back(std::move(velocity));
    return frame;
  }

  Loads& loads() override { return boundaries_; }
  std::vector<SlotRun> particle_runs(int) const override { return {{0, particles()}}; }
  std::vector<FieldView> fields(int) const override { return {}; }
  std::vector<std::array<double, 3>> positions(int) const override { return position_; }

  const scheduler::StepGraph& step_graph() const override { return graph_; }

 private:
  std::vector<scheduler::Phase> phases() {
    return {{.name = "fly", .writes = {{0}}, .run = [this](int) {
               const double decay = 1 - drag_of(settings()) * time_step_;
               for (std::size_t p = 0; p < mass_.size(); ++p) {
                 for (int a = 0; a < 3; ++a) {
                   position_[p][a] += time_step_ * velocity_[p][a];
                   velocity_[p][a] *= decay;
                 }
               }
             }}};
  }

  void take_step(double time_step) override {
    time_step_ = time_step;
    run(graph_);
    clock_.time += time_step;
    ++clock_.step;
    add_particle_stages(particles());
  }

  std::vector<double> measure_each(std::span<const MeasurementCase> measurements) override {
    std::vector<double> values;
    for (const MeasurementCase& m : measurements) {
      values.push_back(value_of(m, integrals(), settings().dimension));
    }
    return values;
  }

  void save_state(ArchiveWriter& archive) const override {
    put_clock(archive, clock_);
    put(archive, "position", position_);
    put(archive, "velocity", velocity_);
  }

  void restore_state(const ArchiveReader& archive) override {
    get_clock(archive, clock_);
    get(archive, "position", position_);
    get(archive, "velocity", velocity_);
  }

  static void put(ArchiveWriter& archive, const char* name, const std::vector<Vector>& field) {
    std::vector<double> numbers;
    for (const Vector& x : field) numbers.insert(numbers.end(), x.begin(), x.end());
    archive.put(name, std::span<const double>(numbers));
  }
  static void get(const ArchiveReader& archive, const char* name, std::vector<Vector>& field) {
    const std::vector<double> numbers = archive.get<double>(name);
    for (std::size_t i = 0; i < numbers.size(); ++i) field.at(i / 3)[i % 3] = numbers[i];
  }

  StepClock clock_;
  Boundaries<2> boundaries_{settings().boundaries};
  double time_step_ = 0;
  std::vector<Vector> position_, velocity_;
  std::vector<double> mass_;
  scheduler::StepGraph graph_;
};

}  // namespace pliant::test
