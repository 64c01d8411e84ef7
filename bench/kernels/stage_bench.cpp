#include "bench/kernels/measure.hpp"
#include "engine/bench/stage_cost.hpp"
#include "tests/kernels/body.hpp"

namespace pliant::kernels::bench {
namespace {

using pliant::bench::bytes_per_stage;
using pliant::bench::flop_per_stage;
using test::Body;

/// Four stages of a step on one block.
template <int D>
void advance(benchmark::State& state, Isa isa, Model model, Kernel kernel) {
  Body<double, D> body(box<D>(state.range(0)), 0.01, model);
  body.kernel = kernel;
  std::int64_t particles = 0;
  body.patch.for_each_interior([&](std::int64_t, const auto&) { ++particles; });
  const RemeshedTable<double, D>& kernels = RemeshedTable<double, D>::of(isa);
  kernels.evaluate_stress(body.stress_of(0));
  const double time_step =
      1e-9;  // small enough that the state does not change in any number of steps
  for (auto _ : state) {
    for (int number = 0; number < 4; ++number) {
      benchmark::DoNotOptimize(
          kernels.advance_stage(body.stage(number, number, (number + 1) % 4, time_step)));
    }
  }
  report(state, 4 * particles, {flop_per_stage(kernel, model, D), bytes_per_stage(model, D)});
}

/// Gradients over neighbour lists that contain the stencil.
void advance_listed(benchmark::State& state, Isa isa) {
  Body<double, 2> body(box<2>(state.range(0)), 0.01, Model::linear);
  const test::BoxLists<2> lists(body.patch, 2);
  const NeighbourLists<2> view = lists.view();
  std::int64_t particles = 0;
  body.patch.for_each_interior([&](std::int64_t, const auto&) { ++particles; });
  Stage<double, 2> stage = body.stage(0, 0, 1, 1e-9);
  stage.neighbours = &view;
  for (auto _ : state) {
    benchmark::DoNotOptimize(RemeshedTable<double, 2>::of(isa).advance_stage(stage));
  }
  const double flop = flop_per_stage(body.kernel, Model::linear);
  report(state, particles, {flop, bytes_per_stage(Model::linear) + 25 * 6});
}

void evaluate(benchmark::State& state, Isa isa, Model model) {
  Body<double, 2> body(box<2>(state.range(0)), 0.01, model);
  std::int64_t slots = 0;
  for (const auto& segment : body.patch.segments) slots += segment.count;
  for (auto _ : state) {
    benchmark::DoNotOptimize(RemeshedTable<double, 2>::of(isa).evaluate_stress(body.stress_of(0)));
  }
  const double flop = model == Model::reduced_polynomial ? 110 : 12;
  report(state, slots, {flop, 8. * (3 + material_component_count<2>(model) + 6)});
}

std::string name_of(Model model) {
  return model == Model::linear ? "rho" : model == Model::linear_logarithmic ? "log" : "polynomial";
}

std::string name_of(Kernel kernel) {
  return kernel == Kernel::quartic_spline       ? "quartic"
         : kernel == Kernel::quartic_spline_fit ? "quartic_spline_fit"
                                                : "compact";
}

const bool registered = [] {
  for (const Kernel kernel :
       {Kernel::quartic_spline, Kernel::quartic_spline_fit, Kernel::compact}) {
    for (const Model model :
         {Model::linear, Model::linear_logarithmic, Model::reduced_polynomial}) {
      if (kernel != Kernel::quartic_spline_fit && model != Model::linear) continue;
      const std::string what = name_of(kernel) + "/" + name_of(model);
      register_sizes("advance_stage/" + what, [=](benchmark::State& state, Isa isa) {
        advance<2>(state, isa, model, kernel);
      });
      register_sizes("advance_stage/space/" + what, [=](benchmark::State& state, Isa isa) {
        advance<3>(state, isa, model, kernel);
      });
    }
  }
  register_sizes("advance_stage/lists", advance_listed);
  for (const Model model : {Model::linear, Model::linear_logarithmic, Model::reduced_polynomial}) {
    register_sizes("evaluate_stress/" + name_of(model),
                   [=](benchmark::State& state, Isa isa) { evaluate(state, isa, model); });
  }
  return true;
}();

}  // namespace
}  // namespace pliant::kernels::bench
