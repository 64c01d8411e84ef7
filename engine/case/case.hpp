#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/case/expression.hpp"
#include "kernels/material.hpp"

/// A case as plain values, in SI units: what a case file says after every check of user input.
namespace pliant {

/// Vectors of a case always have three components; in 2D the last is zero.
using Vector = std::array<double, 3>;
using VectorExpression = std::array<Expression, 3>;

class ClosedMesh;

struct Shape {
  enum class Kind { box, ball, cylinder, half_space, mesh, unite, subtract, intersect };
  Kind kind = Kind::box;
  Vector lower = {}, upper = {};   ///< box; may be infinite
  Vector centre = {};              ///< ball (a disc in 2D), cylinder
  double radius = 0;               ///< ball, cylinder
  Vector axis = {0, 0, 1};         ///< cylinder, infinite along it
  Vector point = {}, normal = {};  ///< half_space: the side that `normal` (unit) points away from
  std::string file;                ///< mesh; once read, its full path
  double scale = 1;                ///< mesh; [m] per unit of the file
  Vector translate = {};           ///< mesh; where the file's origin goes [m]
  std::shared_ptr<const ClosedMesh> mesh;  ///< mesh; what the file holds, in place
  std::vector<Shape> operands;  ///< unite, intersect; subtract takes the others from the first
};

struct RigidRotation {
  Vector centre = {};
  Vector angular_velocity = {};  ///< [1/s]; about z in 2D
};
using InitialVelocity = std::variant<VectorExpression, RigidRotation>;

/// Prony series of the bulk modulus, (RP.70).
struct PronyCase {
  enum class Moduli { long_term, instantaneous };
  std::vector<double> ratios;  ///< g_i
  std::vector<double> times;   ///< tau_i [s]
  Moduli moduli = Moduli::long_term;
};

/// A material in the words of case files; `elastic_constants` gives what the kernels read.
struct MaterialCase {
  enum class Model { linear, reduced_polynomial };
  enum class EquationOfState { linear, logarithmic };
  Model model = Model::linear;
  double density = 0;                                           ///< [kg/m^3]
  EquationOfState equation_of_state = EquationOfState::linear;  ///< linear: (RP.5) or (RP.6)
  double youngs_modulus = 0;                                    ///< linear: E [Pa]
  double poissons_ratio = 0;                                    ///< linear: nu
  std::vector<double> coefficients;  ///< reduced polynomial: C_10, C_20, ... [Pa]
  double compressibility = 0;        ///< reduced polynomial: D [1/Pa]
  PronyCase prony;                   ///< reduced polynomial
};

struct BodyCase {
  std::string name;
  Shape geometry;
  kernels::Material<double> material;
  std::vector<kernels::PronyTerm<double>> prony;
  InitialVelocity velocity;
  Vector stretch = {1, 1, 1};      ///< along the axes, at t = 0 from rest
  MaterialCase material_as_given;  ///< what `material` and `prony` were computed from
};

struct BoundaryCase {
  /// "fixed" and "moving_wall" are walls; all but contact walls are attached to the body.
  enum class Kind { wall, slip_wall, contact_wall, pressure };
  enum class Friction { frictionless, no_slip };
  std::string name;
  Kind kind = Kind::wall;
  Shape geometry;             ///< the wall's solid at t = 0, or the region that pressure acts in
  VectorExpression velocity;  ///< of t, walls [m/s]
  Friction friction = Friction::frictionless;  ///< contact walls
  Expression pressure;                         ///< of t, positive pushes on the body [Pa]
};

/// How two bodies act on each other where they meet; bodies without a contact pass through each
/// other.
struct ContactCase {
  enum class Kind { frictionless, no_slip, tied };
  std::array<int, 2> bodies = {-1, -1};
  Kind kind = Kind::frictionless;
};

struct MeasurementCase {
  enum class Kind {
    extent,              ///< farthest free surface along an axis, minus `reference`
    surface_distance,    ///< from `point` along `direction`, minus `reference`
    mean_radius,         ///< of the surface around `point`, over `directions`
    point_displacement,  ///< of the material point that started at `point`, along `axis`
    point_value,         ///< of `field` at `point`
    mass,
    momentum,          ///< along `axis`
    angular_momentum,  ///< about `point`; about z in 2D, along `axis` in 3D
    kinetic_energy,
    strain_energy,
    total_energy,
    energy_ratio,   ///< kinetic over strain energy
    wall_force,     ///< of contact wall `boundary` along `axis`, mean since the last sample
    contact_force,  ///< on the first of `bodies` from the second, likewise
    volume,         ///< of {phi < 0}; an area in 2D
    surface_area,   ///< of {phi = 0}; a length in 2D
    minimum_particle_distance,  ///< over the spacing
    velocity_error,             ///< against `exact`, over `reference` (the amplitude)
    period,                     ///< twice the mean spacing of zero crossings of measurement `of`
    amplitude_ratio,            ///< mean ratio of successive same-sign maxima of measurement `of`
    peak_moving_average,        ///< largest mean of measurement `of` over a time `window`
    last_time_above,  ///< last time at which measurement `of` exceeds a thousandth of its peak
  };
  enum class Norm { maximum, root_mean_square };
  std::string name;
  Kind kind = Kind::mass;
  int body = 0;
  int boundary = -1;
  std::array<int, 2> bodies = {-1, -1};  ///< contact_force
  int axis = 0;
  bool lower_side = false;          ///< extent: towards -axis
  std::optional<Expression> where;  ///< extent: only surface points where this is not zero
  double reference = 0;
  bool relative = false;  ///< conserved quantities: over the value at the start
  Vector point = {}, direction = {};
  int directions = 64;
  std::string field;
  VectorExpression exact;
  Norm norm = Norm::maximum;
  int of = -1;        ///< position of the measurement whose history the last four kinds read
  double window = 0;  ///< peak_moving_average [s]

  bool reads_history() const { return of >= 0; }
  /// Forces are means between samples: what an impulse has changed by, over the time.
  bool is_force() const { return kind == Kind::wall_force || kind == Kind::contact_force; }
};

enum class GhostTreatment { linear, averaged, rigid };
enum class Method { remeshed, total_lagrangian };
/// Volume of remeshed particles: that of a cell (RP.24), or conserved (RP.25).
enum class VolumeRule { reset, conserved };
enum class Operators { moment_matrix, symmetric_sph };
/// Scalar type of the fields.
enum class Precision { binary64, binary32 };

struct Case {
  std::string name;  ///< of the folder or the file, unless the file says
  std::string title;
  int dimension = 2;
  Precision precision = Precision::binary64;
  Method method = Method::remeshed;

  struct {
    double spacing = 0;  ///< h [m]
    kernels::Weight kernel = kernels::Weight::quartic_polynomial;
    double dissipation = 0.25;  ///< gamma_d of (RP.43)
    Operators operators = Operators::moment_matrix;
    double artificial_viscosity = 1;  ///< symmetric_sph: alpha of (RP.75)
    double artificial_stress = 0.3;   ///< symmetric_sph: epsilon of (RP.76)
  } discretisation;

  struct {
    double end = 0;
    std::optional<double> step;  ///< none: "cfl"
    double cfl = 0.5;
  } time;

  struct {
    double hourglass_stiffness = 0.8;     ///< kappa of (TL.6)
    double mass_scaling = 1;              ///< inertia over mass
    bool match_time_step = false;         ///< scale the mass as `time.step` needs it instead
    std::optional<double> damping = 0.0;  ///< alpha of (TL.8) [1/s]; none: adaptive, (TL.10)
  } total_lagrangian;

  struct {
    enum class Policy { every, adaptive, never };
    Policy policy = Policy::adaptive;
    int every = 10;                  ///< steps
    double strain_threshold = 0.18;  ///< of (RP.28)
    double filter = 0.2;             ///< gamma of (RP.27)
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

  std::vector<BodyCase> bodies;
  std::vector<BoundaryCase> boundaries;
  std::vector<ContactCase> contacts;
  std::vector<MeasurementCase> measurements;

  struct {
    double every = 0;             ///< between frames [s]; 0: first and last only
    double checkpoint_every = 0;  ///< between checkpoints [s]; 0: only when interrupted
    bool ghosts = false;          ///< frames hold ghost particles too
    bool surface = false;         ///< frames hold the free surface
    double measure_every = 0;     ///< [s]; 0: at every remeshing and at the end
  } output;
};

}  // namespace pliant
