#include <cstdio>
#include <pliant/pliant.hpp>

// A rubber disc, spinning freely, built in code: every key is one of docs/case-reference.md.
int main() {
  pliant::CaseFile disc;
  disc.set("discretisation.spacing", 0.05).set("time.end", 0.1);
  disc.set("material.rubber.model", "linear").set("material.rubber.density", 1000);
  disc.set("material.rubber.youngs_modulus", 1e6).set("material.rubber.poissons_ratio", 0.4);
  disc.add("body", "disc").set("body.disc.material", "rubber");
  disc.set("body.disc.geometry", R"({ shape = "disc", centre = [0, 0], radius = 1 })");
  disc.set("body.disc.rotation", "{ centre = [0, 0], angular_velocity = 3 }");

  pliant::Simulation simulation(disc);
  const double start = simulation.totals().angular_momentum[2];
  simulation.advance(0.1);
  const pliant::Totals totals = simulation.totals();
  std::printf("%lld particles, %lld steps, t = %g s\n",
              static_cast<long long>(simulation.particle_count()),
              static_cast<long long>(simulation.step_count()), simulation.time());
  std::printf("angular momentum: %.6f of its start\n", totals.angular_momentum[2] / start);
}
