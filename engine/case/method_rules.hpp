#pragma once

#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.hpp"

namespace pliant {

struct Check;
class MethodKeys;

/// Limits of the steps of a method, from the waves of the material, (RP.29) and (RP.30).
struct StepLimits {
  double stable_cfl = std::numeric_limits<double>::infinity();  ///< largest stable CFL number
  double default_cfl = 1;                                       ///< for cases without a CFL number
  bool bounds_given_steps = false;  ///< whether `stable_cfl` also limits steps given in seconds
  bool mass_follows_step = false;   ///< whether the mass is scaled until the given step is stable
  double mass_scaling = 1;          ///< inertia over mass
};

/// Where particles are in a body, and their memory, for estimates.
struct Footprint {
  bool on_corners = false;  ///< on corners of lattice cells, not at their centres
  double margin = 0;        ///< largest signed distance of particles from the surface [spacing]
  double reach = 0;         ///< distance up to which there are slots around particles [spacing]
  double bytes_per_slot = 0, bytes_per_ghost = 0, bytes_per_particle = 0;
};

/// What programs know about a method before there is a solver. A comment gives the meaning of a
/// function that is null.
struct MethodRules {
  std::string_view word;     ///< as case files write it
  std::string_view meaning;  ///< for the reference of case files
  /// Adds problems for what the case requires and the method cannot do.
  void (*check)(const Check& check);
  /// Visits the keys of the table [NAME], whose values are a struct of the method. Null: none.
  void (*keys)(MethodKeys& visit, MethodParameters& parameters) = nullptr;
  /// Where the method keeps the damping rate of its own table; none: adaptive. Null: it has none.
  std::optional<double>& (*damping)(MethodParameters& parameters) = nullptr;
  /// Null: `StepLimits{}`.
  StepLimits (*step_limits)(const Case& a_case) = nullptr;
  /// The method and its parameters in a few words, for `pliant check`. Null: the word.
  std::string (*summary)(const Case& a_case) = nullptr;
  /// Adds warnings of `run` and `check`, each one sentence. Null: none.
  void (*warn)(const Case& a_case, std::vector<std::string>& warnings) = nullptr;
  /// Null: estimates ignore the bodies.
  Footprint (*footprint)(const Case& a_case, const BodyCase& body) = nullptr;
  /// Whether the particles of a body of this shape are the nodes of its mesh. Null: they never are.
  bool (*has_elements)(const Shape& shape) = nullptr;
  /// Whether particles are remeshed. The case then has a kernel, dissipation of the lattice,
  /// `time.strain`, and the tables [remeshing], [level_set] and [ghosts].
  bool remeshes = false;
  /// Whether parts of one body can be in contact with each other.
  bool has_self_contact = false;
  /// Whether outputs show a state inside a step, so that no step has to end there.
  bool shows_states_within_steps = false;
};

/// For `MethodRules::damping` of a method with these parameters.
template <class Parameters>
std::optional<double>& damping_of(MethodParameters& parameters) {
  return parameters.as<Parameters>().damping;
}

/// The methods that a case may name.
using MethodList = std::span<const MethodRules>;

/// The rules of the method with this word; null if there is none.
const MethodRules* rules_of(MethodList methods, std::string_view word);

/// Whether the method of a case is known and remeshes particles.
inline bool is_remeshed(const Case& a_case) {
  return a_case.rules != nullptr && a_case.rules->remeshes;
}

/// Whether the method of a case is known and takes the nodes of a body's mesh as they are.
inline bool has_elements(const Case& a_case, const BodyCase& body) {
  return a_case.rules != nullptr && a_case.rules->has_elements != nullptr &&
         a_case.rules->has_elements(body.geometry);
}

/// Whether the damping rate of a case is that of the present motion.
inline bool is_damped_adaptively(const Case& a_case) {
  if (a_case.rules == nullptr || a_case.rules->damping == nullptr) {
    return !a_case.discretisation.damping;
  }
  MethodParameters parameters = a_case.parameters;
  return !a_case.rules->damping(parameters);
}

/// The warnings of the method of a case.
std::vector<std::string> warnings_of_method(const Case& a_case);

/// Adds a problem for each measurement that the method cannot evaluate, except those that evaluate
/// the history of another one.
void refuse_measurements(const Check& check, bool (*is_measured)(MeasurementCase::Kind kind));

/// Adds a problem for each boundary of this kind.
void refuse_boundaries(const Check& check, BoundaryCase::Kind kind);

/// Adds a problem for a key at the top level of the case.
void refuse_key(const Check& check, std::string_view key);

/// Adds a problem for each body whose shear modulus relaxes.
void refuse_prony_shear(const Check& check);

/// Adds a problem for each of these tables that the case contains.
void refuse_tables(const Check& check, std::initializer_list<std::string_view> tables);

}  // namespace pliant
