#include <algorithm>
#include <cmath>
#include <cstdio>
#include <pliant/pliant.hpp>
#include <string>

// A load rolls over a block of rubber. The top of the block is divided into strips, each with its
// own pressure, which the loop sets between frames. A surgical simulator can apply tools in this
// way.
namespace {

constexpr int strips = 8;
constexpr double length = 0.4, height = 0.1;  // [m]

pliant::CaseFile block() {
  pliant::CaseFile block;
  block.set("method", "total_lagrangian").set("discretisation.spacing", height / 16);
  block.set("time.end", 1).set("total_lagrangian.damping", 20);
  block.set("material.rubber", R"({ model = "reduced_polynomial", density = 1000,
                                    coefficients = [5000], compressibility = 2e-5 })");
  block.add("body", "block").set("body.block.material", "rubber");
  block.set("body.block.geometry", R"({ shape = "box", lower = [0, 0], upper = [0.4, 0.1] })");
  block.add("boundary", "ground").set("boundary.ground.kind", "fixed");
  block.set("boundary.ground.geometry",
            R"({ shape = "half_space", point = [0, 0], normal = [0, 1] })");
  for (int i = 0; i < strips; ++i) {
    const std::string name = "strip" + std::to_string(i), key = "boundary." + name;
    const double lower = i * length / strips, upper = (i + 1) * length / strips;
    block.add("boundary", name).set(key + ".kind", "pressure").set(key + ".pressure", 0);
    block.set(key + ".geometry", "{ shape = \"box\", lower = [" + std::to_string(lower) +
                                     ", 0.05], upper = [" + std::to_string(upper) + ", 0.2] }");
  }
  block.add("measurement", "middle").set("measurement.middle.kind", "point_displacement");
  block.set("measurement.middle.point", {length / 2, height});
  block.set("measurement.middle.axis", "y");
  return block;
}

}  // namespace

int main() {
  pliant::Simulation simulation(block());
  constexpr double speed = 0.8, weight = 2000;  // [m/s], [Pa]
  constexpr int frames = 30;
  for (int frame = 1; frame <= frames; ++frame) {
    const double load = speed * simulation.time() * strips / length;
    for (int i = 0; i < strips; ++i) {
      const double share = std::max(0.0, 1 - std::abs(load - (i + 0.5)));
      simulation.set_pressure("strip" + std::to_string(i), weight * share);
    }
    simulation.advance(frame / 60.);
    std::printf("t = %.3f s: the middle of the top has moved by %+.5f m\n", simulation.time(),
                simulation.measurement("middle"));
  }
}
