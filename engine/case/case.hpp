#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/case/expression.hpp"
#include "engine/case/method_parameters.hpp"
#include "engine/geometry/shape.hpp"
#include "kernels/material.hpp"

/// A case as plain values in SI units: the content of a case file after all checks of user input.
namespace pliant {

struct MethodRules;

using VectorExpression = std::array<Expression, 3>;

/// A rigid rotation about a fixed point.
struct RigidRotation {
  Vector centre = {};
  Vector angular_velocity = {};  ///< [1/s]; about z in 2D
};
/// A velocity plus a rotation.
struct InitialVelocity {
  VectorExpression translation;  ///< of x, y, z [m/s]
  std::optional<RigidRotation> rotation;
};

/// Rotation of a wall about an axis through a point that moves with the wall.
struct WallRotation {
  Vector centre = {};       ///< at t = 0 [m]
  Vector axis = {0, 0, 1};  ///< any length
  Expression angle;         ///< of t, since t = 0 [rad]
};

/// Components of a stress, of x, y, z [Pa].
struct StressExpression {
  Expression xx, yy, zz, xy, yz, xz;
};

/// Prony series of a modulus, (RP.10) or (TL.24).
struct PronyCase {
  enum class Moduli { long_term, instantaneous };
  std::vector<double> ratios;  ///< g_i
  std::vector<double> times;   ///< tau_i [s]
  Moduli moduli = Moduli::long_term;
};

/// A material in the words of case files; `elastic_constants` converts it for kernels.
struct MaterialCase {
  enum class Model { linear, reduced_polynomial, neo_hookean, st_venant_kirchhoff };
  enum class EquationOfState { linear, logarithmic };
  Model model = Model::linear;
  double density = 0;                                           ///< [kg/m^3]
  EquationOfState equation_of_state = EquationOfState::linear;  ///< linear: (RP.5) or (RP.6)
  double youngs_modulus = 0;         ///< all models but the polynomial: E [Pa]
  double poissons_ratio = 0;         ///< likewise: nu
  std::vector<double> coefficients;  ///< reduced polynomial: C_10, C_20, ... [Pa]
  double compressibility = 0;        ///< reduced polynomial: D [1/Pa]
  PronyCase prony;                   ///< reduced polynomial: for its bulk modulus
  PronyCase prony_shear;             ///< reduced polynomial: for its shear modulus
};

/// A `[[body]]` table.
struct BodyCase {
  std::string name;
  Shape geometry;
  kernels::Material<double> material;
  std::vector<kernels::PronyTerm<double>> prony;        ///< of the bulk modulus
  std::vector<kernels::PronyTerm<double>> prony_shear;  ///< of the shear modulus
  InitialVelocity velocity;
  Vector stretch = {1, 1, 1};              ///< along the axes at t = 0, at rest
  std::optional<StressExpression> stress;  ///< at t = 0
  MaterialCase material_as_given;          ///< source of the constants above
};

/// How surfaces in contact act on each other; see contact_laws.hpp.
enum class ContactLaw { frictionless, no_slip, tied, coulomb };

/// A `[[boundary]]` table: a wall, or a load on the free surface.
struct BoundaryCase {
  enum class Kind {
    fixed,
    moving_wall,
    slip_wall,
    contact_wall,
    pressure,
    traction
  };  ///< boundary_kinds.hpp
  /// The area to which a traction refers.
  enum class LoadedArea { present, undeformed };
  std::string name;
  Kind kind = Kind::fixed;
  Shape geometry;             ///< the wall's solid at t = 0, or the region of a load
  VectorExpression velocity;  ///< of t, walls [m/s]
  std::optional<VectorExpression> displacement;  ///< of t, walls, instead of `velocity` [m]
  std::optional<WallRotation> rotation;  ///< walls, in addition to `velocity` or `displacement`
  double time_increment =
      0;  ///< of the differences that give velocities from displacement and angle [s]
  ContactLaw friction = ContactLaw::frictionless;  ///< contact walls
  std::optional<double>
      friction_coefficient;               ///< of Coulomb; none: `friction` applies without limit
  Expression pressure;                    ///< of t, positive pushes on the body [Pa]
  VectorExpression traction;              ///< of x, y, z, t [Pa]
  LoadedArea area = LoadedArea::present;  ///< of a traction
};

/// How two bodies act on each other in contact. Bodies without a contact pass through each other.
struct ContactCase {
  std::array<int, 2> bodies = {-1, -1};
  ContactLaw law = ContactLaw::frictionless;
  double friction = 0;  ///< coefficient of Coulomb friction
};

/// The recorded places of a blade in the undeformed body; linear in between.
struct BladeTrack {
  std::string file;
  std::vector<double> time;      ///< [s], ascending, two or more
  std::vector<Vector> from, to;  ///< ends of the edge [m]; in 2D the edge is `from`
};

/// A blade that cuts a body: its edge sweeps a surface of the undeformed body.
struct CutCase {
  std::string name;
  int body = 0;
  Vector from = {}, to = {};  ///< ends of the edge at `start` (in 2D the edge is `from`) [m]
  VectorExpression path;      ///< displacement of the edge since `start`, of t [m]
  std::optional<VectorExpression> edge;  ///< from the start of the edge to its end, of t [m]
  BladeTrack track;                      ///< replaces all of these, if it has a file
  double start = 0, end = 0;             ///< times at which it cuts [s]
  double resistance = 0;                 ///< G_c of (PB.18) [J/m^2]
  double friction = 0;                   ///< f_0 of (PB.18) [N/m]
  double drag = 0;                       ///< b of (PB.18) [Pa s]
  double puncture_force = 0;             ///< F_p of (PB.35) [N]; 0: enters at once

  bool resists() const { return resistance > 0 || friction > 0 || drag > 0; }
};

/// A `[[measurement]]` table; its kind determines which members are used.
struct MeasurementCase {
  /// See measurement_kinds.hpp.
  enum class Kind {
    extent,
    surface_distance,
    mean_radius,
    point_displacement,
    point_value,
    material_value,
    mean_value,
    mass,
    centre_of_mass,
    momentum,
    angular_momentum,
    kinetic_energy,
    strain_energy,
    total_energy,
    energy_ratio,
    wall_force,
    wall_moment,
    contact_force,
    blade_force,
    cutting_work,
    volume,
    surface_area,
    connected_parts,
    largest_part_volume,
    minimum_particle_distance,
    velocity_error,
    period,
    amplitude_ratio,
    peak_moving_average,
    last_time_above,
    smallest,
    largest,
    value_at_time,
    weighted_sum,
  };
  enum class Norm { maximum, root_mean_square };
  std::string name;
  Kind kind = Kind::mass;
  int body = 0;
  int boundary = -1;
  int cut = -1;
  std::array<int, 2> bodies = {-1, -1};  ///< contact_force
  int axis = 0;
  bool lower_side = false;          ///< extent: towards -axis
  std::optional<Expression> where;  ///< extent: only surface points where this is not zero
  double reference = 0;
  bool relative = false;  ///< conserved quantities: relative to the value at the start
  Vector point = {}, direction = {};
  int directions = 64;
  std::string field;
  VectorExpression exact;
  Norm norm = Norm::maximum;
  int of = -1;        ///< position of the measurement whose history the last four kinds evaluate
  double window = 0;  ///< peak_moving_average [s]

  double fraction = 0.001;      ///< last_time_above
  double time = 0;              ///< value_at_time [s]
  std::vector<int> terms;       ///< weighted_sum: positions of other measurements
  std::vector<double> factors;  ///< weighted_sum: of the terms; empty: all 1

  bool reads_history() const { return of >= 0 || !terms.empty(); }
};

enum class GhostTreatment { linear, averaged, rigid };
/// Volume of remeshed particles: that of a cell (RP.34), or the conserved one (RP.35).
enum class VolumeRule { reset, conserved };
/// What a run does when one of its checks fails.
enum class CheckResponse { off, warn, stop };
/// Scalar type of the fields.
enum class Precision { binary64, binary32 };

/// Strengths of the dissipation (RP.23).
struct DissipationCase {
  double velocity = 0.5;  ///< gamma_u
  double stress = 0.025;  ///< gamma_sigma
};

/// A whole case in plain values, read and checked; the keys of case files set its members.
struct Case {
  std::string name;  ///< that of the folder or the file, unless the file sets it
  std::string title;
  int dimension = 2;
  std::string method = "remeshed";  ///< word of a registered method
  const MethodRules* rules =
      nullptr;  ///< rules of the method, from the registry with which the case was read
  MethodParameters parameters;  ///< of the method
  Precision precision = Precision::binary64;

  struct {
    double spacing = 0;  ///< h [m]
    kernels::Kernel kernel = kernels::Kernel::compact;
    DissipationCase dissipation;
    std::optional<double> damping = 0.;  ///< of all methods [1/s]; none: adaptive
  } discretisation;

  struct {
    double end = 0;
    std::optional<double> step;  ///< none: "cfl"
    std::optional<double> cfl;   ///< none: that of stability.hpp
    double strain = 0.02;        ///< of a step, (RP.29)
  } time;

  struct {
    enum class Policy { every, adaptive, never };
    Policy policy = Policy::adaptive;
    int every = 10;                      ///< steps
    double strain_threshold = 0.18;      ///< of (RP.39)
    double deformation_threshold = 0.2;  ///< of (RP.39)
    double filter = 0;                   ///< gamma of (RP.37)
    VolumeRule volume = VolumeRule::reset;
  } remeshing;

  struct {
    int reinitialise_every = 20;  ///< steps
  } level_set;

  GhostTreatment ghosts = GhostTreatment::linear;

  struct {
    std::array<bool, 3> axis = {};
    Vector lower = {}, upper = {};  ///< of the periodic cell
  } periodic;

  VectorExpression gravity;  ///< acceleration of all bodies by a body force, of x, y, z, t [m/s^2]
  std::vector<BodyCase> bodies;
  std::vector<BoundaryCase> boundaries;
  std::vector<ContactCase> contacts;
  std::vector<CutCase> cuts;
  std::vector<MeasurementCase> measurements;

  struct {
    double every = 0;             ///< between frames [s]; 0: first and last only
    double checkpoint_every = 0;  ///< between checkpoints [s]; 0: only when interrupted
    bool ghosts = false;          ///< frames contain ghosts too
    bool surface = false;         ///< frames contain the free surface
    double measure_every = 0;  ///< between samples [s]; 0: as the method and the measurements need
  } output;

  struct {
    CheckResponse energy = CheckResponse::warn;
    CheckResponse mass = CheckResponse::warn;
    CheckResponse momentum = CheckResponse::warn;
  } checks;
};

}  // namespace pliant
