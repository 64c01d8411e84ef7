#include "engine/method/initial_velocity.hpp"

namespace pliant {

Vector initial_velocity(const BodyCase& body, const Vector& x) {
  if (const auto* formula = std::get_if<VectorExpression>(&body.velocity)) {
    return {(*formula)[0](x[0], x[1], x[2], 0), (*formula)[1](x[0], x[1], x[2], 0),
            (*formula)[2](x[0], x[1], x[2], 0)};
  }
  const auto& rotation = std::get<RigidRotation>(body.velocity);
  const Vector& w = rotation.angular_velocity;
  const Vector r = {x[0] - rotation.centre[0], x[1] - rotation.centre[1],
                    x[2] - rotation.centre[2]};
  return {w[1] * r[2] - w[2] * r[1], w[2] * r[0] - w[0] * r[2], w[0] * r[1] - w[1] * r[0]};
}

}  // namespace pliant
