#include "engine/method/body_integrals.hpp"

#include <limits>

namespace pliant {

double value_of(const MeasurementCase& measurement, const BodyIntegrals& sum, int dimension) {
  using Quantity = MeasurementCase::Kind;
  switch (measurement.kind) {
    case Quantity::mass:
      return sum.mass;
    case Quantity::centre_of_mass:
      return measurement.point[measurement.axis] + sum.first_moment[measurement.axis] / sum.mass -
             measurement.reference;
    case Quantity::momentum:
      return sum.momentum[measurement.axis];
    case Quantity::angular_momentum:
      return sum.angular_momentum[dimension == 2 ? 2 : measurement.axis];
    case Quantity::kinetic_energy:
      return sum.kinetic_energy;
    case Quantity::strain_energy:
      return sum.strain_energy;
    case Quantity::energy_ratio:
      return sum.strain_energy > 0 ? sum.kinetic_energy / sum.strain_energy
                                   : std::numeric_limits<double>::quiet_NaN();
    case Quantity::volume:
      return sum.volume;
    default:
      return sum.kinetic_energy + sum.strain_energy;
  }
}

void add_motion(BodyIntegrals& sum, double mass, const Vector& r, const Vector& u,
                double mass_scaling) {
  const double inertia = mass_scaling * mass;
  double square = 0;
  for (int c = 0; c < 3; ++c) {
    const int a = (c + 1) % 3, b = (c + 2) % 3;
    square += u[c] * u[c];
    sum.first_moment[c] += mass * r[c];
    sum.momentum[c] += inertia * u[c];
    sum.angular_momentum[c] += inertia * (r[a] * u[b] - r[b] * u[a]);
  }
  sum.kinetic_energy += 0.5 * inertia * square;
}

void add(BodyIntegrals& sum, const BodyIntegrals& other) {
  sum.volume += other.volume;
  sum.mass += other.mass;
  sum.kinetic_energy += other.kinetic_energy;
  sum.strain_energy += other.strain_energy;
  for (int c = 0; c < 3; ++c) {
    sum.first_moment[c] += other.first_moment[c];
    sum.momentum[c] += other.momentum[c];
    sum.angular_momentum[c] += other.angular_momentum[c];
  }
}

}  // namespace pliant
