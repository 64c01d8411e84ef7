#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <pliant/pliant.hpp>
#include <string>
#include <vector>

// A surgical simulator without a screen: plays a recorded session of a scalpel on soft tissue at 60
// frames per second, and reports whether it met its deadlines.
//
//     scalpel [SESSION.csv [SPACING [THREADS]]]
namespace {

constexpr double frame_time = 1. / 60;  // [s]

/// 24 x 23 x 22 nodes at a spacing of 4.5 mm, stretched by walls on the left and right, so that
/// cuts open. Sides are multiples of the spacing, so that nodes are on the surface, where walls
/// hold them.
pliant::CaseFile tissue(double spacing) {
  pliant::CaseFile tissue;
  tissue.set("dimension", 3).set("method", "point_based").set("precision", "single");
  tissue.set("discretisation.spacing", spacing).set("time.end", 100).set("point_based.damping", 20);
  tissue.set("material.tissue", R"({ model = "neo_hookean", density = 1000,
                                     youngs_modulus = 10e3, poissons_ratio = 0.45 })");
  tissue.add("body", "tissue").set("body.tissue.material", "tissue");
  const auto side = [spacing](double length) { return spacing * std::round(length / spacing); };
  const double width = side(0.1035);
  tissue.set("body.tissue.geometry", R"({ shape = "box", lower = [0, 0, 0] })");
  tissue.set("body.tissue.geometry.upper", {width, side(0.099), side(0.0945)});
  for (const std::string wall : {"left", "right"}) {
    const bool is_left = wall == "left";
    const std::string key = "boundary." + wall, sign = is_left ? "-" : "";
    tissue.add("boundary", wall).set(key + ".kind", "moving_wall");
    tissue.set(key + ".geometry", R"({ shape = "half_space" })");
    tissue.set(key + ".geometry.point", {is_left ? 0. : width, 0, 0});
    tissue.set(key + ".geometry.normal", {is_left ? 1. : -1., 0, 0});
    tissue.set(key + ".displacement", "[\"" + sign + "0.005*min(t/0.3, 1)\", 0, 0]");
  }
  // The session moves the blade, so its path here is only a placeholder.
  tissue.add("cut", "scalpel").set("cut.scalpel.from", {0.056, -0.01, 0.05});
  tissue.set("cut.scalpel.to", {0.056, -0.01, 0.11}).set("cut.scalpel.path", {0, 0, 0});
  tissue.set("cut.scalpel.start", 99).set("cut.scalpel.end", 100);
  tissue.add("measurement", "strain_energy").set("measurement.strain_energy.kind", "strain_energy");
  return tissue;
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

void print_times(const char* name, const std::vector<double>& times) {
  std::printf("%s [ms]: p50 %.2f, p99 %.2f, p99.9 %.2f\n", name, 1e3 * percentile(times, 0.5),
              1e3 * percentile(times, 0.99), 1e3 * percentile(times, 0.999));
}

bool are_equal(const pliant::Simulation& one, const pliant::Simulation& other) {
  return one.positions(0) == other.positions(0);
}

int play(const std::string& file, double spacing, int threads) {
  const std::vector<pliant::Input> session = pliant::read_inputs(file);
  pliant::SimulationOptions options;
  options.threads = threads;
  pliant::Simulation simulation(tissue(spacing), options);
  for (const pliant::Input& input : session) simulation.enter(input);

  std::vector<double> wall, processor;
  double most_lag = 0;
  int missed = 0;
  const int frames = static_cast<int>(std::ceil(session.back().time / frame_time)) + 30;
  for (int frame = 1; frame <= frames; ++frame) {
    const std::clock_t start = std::clock();
    const pliant::Progress progress = simulation.advance(frame * frame_time, frame_time);
    processor.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    wall.push_back(progress.wall_time);
    most_lag = std::max(most_lag, progress.lag);
    if (progress.wall_time > frame_time) ++missed;
  }
  std::printf("%lld nodes, %lld steps, %.2f s\n",
              static_cast<long long>(simulation.particle_count()),
              static_cast<long long>(simulation.step_count()), simulation.time());
  print_times("wall time of a frame", wall);
  print_times("processor time of a frame, all threads", processor);
  std::printf("missed deadlines: %d of %d; simulated time was late by %.1f ms at most\n", missed,
              frames, 1e3 * most_lag);
  std::printf("strain energy at the end: %.4g J\n", simulation.measurement("strain_energy"));

  pliant::Simulation again(tissue(spacing), options);
  again.play(simulation.session());
  const bool same = are_equal(simulation, again);
  std::printf("played again: %s\n", same ? "the same bits" : "DIFFERENT");
  return same ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return play(count > 1 ? arguments[1] : SESSION, count > 2 ? std::stod(arguments[2]) : 0.0045,
                count > 3 ? std::stoi(arguments[3]) : 0);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
