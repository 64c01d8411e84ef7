#include "engine/method/initial_velocity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/case/checks/probes.hpp"
#include "engine/case/checks/resolution.hpp"

namespace pliant {

namespace {

bool depends_on_place(const InitialVelocity& velocity) {
  return velocity.rotation || std::ranges::any_of(velocity.translation, &Expression::uses_place);
}

/// (1/12) h^2 of the mean of the Laplacian of |u|^2 in a body over the mean of |u|^2, (TL.34). If
/// the body has a rotation, u is relative to the mean velocity, so that the result is the same for
/// bodies that also move.
double error_of_energy(const BodyCase& body, int dimension, double h) {
  const Box<3> box = bounding_box(body.geometry);
  const double step = step_of_probes(box, dimension);
  if (!std::isfinite(step)) return 0;
  std::vector<Vector> inside = middles(box, dimension, step);
  std::erase_if(inside,
                [&](const Vector& x) { return signed_distance(body.geometry, x, dimension) > 0; });
  Vector mean = {};
  if (body.velocity.rotation) {
    for (const Vector& x : inside) {
      const Vector u = initial_velocity(body, x);
      for (int a = 0; a < 3; ++a) mean[a] += u[a] / static_cast<double>(inside.size());
    }
  }
  const auto square = [&](const Vector& x) {
    const Vector u = initial_velocity(body, x);
    return std::pow(u[0] - mean[0], 2) + std::pow(u[1] - mean[1], 2) + std::pow(u[2] - mean[2], 2);
  };
  double sum = 0, differences = 0;
  for (const Vector& x : inside) {
    const double here = square(x);
    sum += here;
    for (int a = 0; a < dimension; ++a) {
      Vector before = x, behind = x;
      before[a] -= h;
      behind[a] += h;
      differences += square(before) - 2 * here + square(behind);
    }
  }
  return sum > 0 ? differences / (12 * sum) : 0;
}

}  // namespace

Vector initial_velocity(const BodyCase& body, const Vector& x) {
  const VectorExpression& formula = body.velocity.translation;
  Vector u = {formula[0](x[0], x[1], x[2], 0), formula[1](x[0], x[1], x[2], 0),
              formula[2](x[0], x[1], x[2], 0)};
  if (!body.velocity.rotation) return u;
  const Vector& w = body.velocity.rotation->angular_velocity;
  const Vector& centre = body.velocity.rotation->centre;
  const Vector r = {x[0] - centre[0], x[1] - centre[1], x[2] - centre[2]};
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    u[a] += w[b] * r[c] - w[c] * r[b];
  }
  return u;
}

void warn_of_initial_motion(const Case& a_case, const ExcessOfEnergy& excess,
                            std::vector<std::string>& warnings) {
  constexpr double unmentioned = 0.02;
  for (const BodyCase& body : a_case.bodies) {
    if (!depends_on_place(body.velocity)) continue;
    const Resolution resolution = resolution_of(a_case, body);
    const bool is_box = body.geometry.kind == Shape::Kind::box;
    const double error = (is_box ? excess.boxes : excess.others) *
                         error_of_energy(body, a_case.dimension, resolution.size);
    if (std::abs(error) < unmentioned) continue;
    warnings.push_back(fmt::format(
        "body `{}` starts with up to {:.2g} % too {} kinetic energy{}, as masses of particles on "
        "its surface lie too far outside; {} or method = \"remeshed\"",
        body.name, 100 * std::abs(error), error > 0 ? "much" : "little",
        body.velocity.rotation ? " and angular momentum of its rotation" : "",
        resolution.remedy(resolution.size * std::sqrt(unmentioned / std::abs(error)))));
  }
}

}  // namespace pliant
