#include "engine/method/initial_velocity.hpp"

namespace pliant {

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

}  // namespace pliant
