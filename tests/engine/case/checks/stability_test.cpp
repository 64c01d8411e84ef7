#include "engine/case/checks/stability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "engine/point_based/parameters.hpp"
#include "engine/simulation/methods.hpp"
#include "engine/total_lagrangian/parameters.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::tests {
namespace {

constexpr int nodes = 16;  // wave numbers along a side of the zone

/// (RP.15)-(RP.17) and (RP.18), as functions of the square of the distance over h.
double weight(kernels::Kernel kind, double s2) {
  const double s = std::sqrt(s2), t = std::max(0., 1 - s2 / 6.25);
  const auto cube = [](double a) { return a > 0 ? a * a * a : 0; };
  switch (kind) {
    case kernels::Kernel::quartic_spline:
      return (cube(2.5 - s) - 5 * cube(1.5 - s) + 10 * cube(0.5 - s)) / (6 * s);
    case kernels::Kernel::quartic_spline_fit:
      return t * t * t * (0.76443 - 2.31468 * t + 2.5554 * t * t);
    case kernels::Kernel::compact:
      return std::pow(std::max(0., 1 - s2 / 3.0625), 4);
    default:
      return t * t *
             (0.63557631 +
              t * (-6.64257139 + t * (21.97914170 + t * (-30.39422150 + t * 15.42207486))));
  }
}

/// Whether Runge-Kutta 4 does not amplify exp(z).
bool is_stable(std::complex<double> z) {
  return std::abs(1. + z * (1. + z / 2. * (1. + z / 3. * (1. + z / 4.)))) <= 1 + 1e-9;
}

/// Largest CFL number at which no plane wave in an infinite lattice grows, from (RP.20), (RP.21)
/// and (RP.23).
double lattice_limit(kernels::Kernel kind, int dimension, double of_velocity, double of_stress) {
  std::vector<std::complex<double>> rates;  // times h/c
  for (int n = 0; n < std::pow(nodes + 1, dimension); ++n) {
    const int index[3] = {n % (nodes + 1), n / (nodes + 1) % (nodes + 1),
                          n / (nodes + 1) / (nodes + 1)};
    double moment = 0, response[3] = {}, differences = 0;
    for (int z = dimension == 3 ? -2 : 0; z <= (dimension == 3 ? 2 : 0); ++z) {
      for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
          const int d[3] = {x, y, z}, s2 = x * x + y * y + z * z;
          if (s2 == 0) continue;
          const double omega = weight(kind, s2);
          moment += omega * x * x;  // A is isotropic on a cubic lattice
          const double phase = M_PI / nodes * (index[0] * x + index[1] * y + index[2] * z);
          for (int a = 0; a < dimension; ++a) response[a] += omega * d[a] * std::sin(phase);
        }
      }
    }
    for (int a = 0; a < dimension; ++a) {
      differences += std::pow(2 * std::sin(M_PI / nodes * index[a] / 2), 4);
    }
    // du/dt = -a u + i g s, ds/dt = -b s + i g u in units of c/h
    const double a = of_velocity / 16 * differences, b = of_stress / 16 * differences;
    const double g = std::hypot(response[0], response[1], response[2]) / moment;
    const std::complex<double> root =
        std::sqrt(std::complex<double>((a - b) * (a - b) / 4 - g * g));
    rates.push_back(-(a + b) / 2 + root);
    rates.push_back(-(a + b) / 2 - root);
  }
  double cfl = 0;
  const auto stands = [&](double at) {
    return std::all_of(rates.begin(), rates.end(),
                       [&](const std::complex<double>& rate) { return is_stable(at * rate); });
  };
  while (cfl < 12 && stands(cfl + 0.01)) cfl += 0.01;
  return cfl;
}

TEST(stability, limits_are_three_quarters_of_those_of_plane_waves) {
  Case a_case = read_text(block_case);
  for (const int dimension : {2, 3}) {
    for (const auto kind : {kernels::Kernel::quartic_spline, kernels::Kernel::quartic_spline_fit,
                            kernels::Kernel::compact, kernels::Kernel::fourth_order}) {
      for (const auto& [of_velocity, of_stress] :
           {std::pair(0., 0.), std::pair(0.25, 0.25), std::pair(1., 1.), std::pair(1., 0.),
            std::pair(0.5, 0.025), std::pair(0.025, 1.)}) {
        a_case.dimension = dimension;
        a_case.discretisation.kernel = kind;
        a_case.discretisation.dissipation = {of_velocity, of_stress};
        const double of_waves = lattice_limit(kind, dimension, of_velocity, of_stress);
        // Damping shifts the limit of the waves by up to 4 %.
        EXPECT_NEAR(stable_cfl(a_case) / (0.75 * of_waves), 1, 0.04)
            << dimension << "D, kernel " << static_cast<int>(kind) << ", " << of_velocity << ", "
            << of_stress;
      }
    }
  }
}

// Waves at sqrt((K + 4 mu/3)/rho) with K = 250/3 and mu = 500/13.
TEST(stability, steps_follow_from_the_fastest_body_at_rest) {
  const Case a_case = read_text(block_case);
  const double speed = std::sqrt((250. / 3 + 2000. / 39) / 2);
  ASSERT_TRUE(stable_step(a_case));
  EXPECT_NEAR(*stable_step(a_case), stable_cfl(a_case) * 0.1 / speed, 1e-12);
}

TEST(stability, steps_above_the_limit_are_warned_of_with_the_key_that_sets_them) {
  EXPECT_EQ(stability_warning(read_text(block_case)), "");
  EXPECT_EQ(stability_warning(read_text(block_case, {"time.step=0.02"})), "");
  EXPECT_EQ(stability_warning(read_text(block_case, {"time.step=0.05"})),
            "the time step 0.05 s is above the stability limit of 0.0207 s (CFL number 1.7); set "
            "time.step = \"cfl\", or to less than the limit");
  EXPECT_EQ(stability_warning(
                read_text(block_case, {"time.cfl=1.5", "discretisation.kernel=fourth_order"})),
            "the CFL number 1.5 is above the stability limit of 1.2; set time.cfl to less than the "
            "limit");
}

// At twice the wave speed at rest the limit is half as long.
TEST(stability, steps_above_the_limit_of_the_present_state_are_warned_of) {
  const Case a_case = read_text(block_case, {"time.step=0.02"});
  EXPECT_EQ(stability_warning(a_case, 8), "");
  EXPECT_EQ(stability_warning(a_case, 16.408),
            "the time step 0.02 s is above the stability limit of 0.0103 s (CFL number 1.7) at the "
            "present wave speed of 16.41 m/s; set time.step = \"cfl\", or to less than the limit");
}

TEST(stability, the_default_cfl_number_is_stable_and_smaller_with_contact_between_bodies) {
  Case a_case = read_text(block_case);
  EXPECT_EQ(cfl_number(a_case), 1);
  a_case.discretisation.dissipation = {2, 0};
  EXPECT_EQ(cfl_number(a_case), stable_cfl(a_case));
  a_case.discretisation.dissipation = {};
  a_case.contacts.emplace_back();
  EXPECT_EQ(cfl_number(a_case), 0.5);
  a_case.time.cfl = 1.5;
  EXPECT_EQ(cfl_number(a_case), 1.5);
  for (const auto& [method, cfl] :
       {std::pair("sph", 0.5), std::pair("total_lagrangian", 0.5), std::pair("point_based", 0.6)}) {
    a_case.rules = &methods().find(method).rules;
    a_case.time.cfl.reset();
    EXPECT_EQ(cfl_number(a_case), cfl) << method;
  }
  a_case.contacts.clear();
  EXPECT_EQ(cfl_number(a_case), 0.9);
  a_case.parameters.as<point_based::Parameters>().cut_contact = 0;
  EXPECT_EQ(cfl_number(a_case), 0.3);
}

TEST(stability, a_mass_that_is_scaled_to_the_step_has_no_limit) {
  Case a_case = read_text(block_case);
  a_case.rules = &methods().find("total_lagrangian").rules;
  a_case.time.step = 1;
  EXPECT_NE(stability_warning(a_case), "");
  a_case.parameters.as<total_lagrangian::Parameters>().mass_scaling.reset();
  EXPECT_EQ(stability_warning(a_case), "");
}

}  // namespace
}  // namespace pliant::tests
