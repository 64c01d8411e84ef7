#pragma once

#include <array>
#include <string_view>

#include "engine/case/case.hpp"

/// The columns of the table in measurement_kinds.hpp.
namespace pliant {

/// Keys of [[measurement]] besides `name` and `kind`; measurement_keys.hpp has their values.
enum class MeasurementKey {
  none,
  body,
  boundary,
  bodies,
  cut,
  axis,
  rotation_axis,  ///< `axis`, in 3D only
  side,
  where,
  length,     ///< `reference`, a length to subtract
  amplitude,  ///< `reference`, a velocity to divide by
  relative,
  point,
  direction,
  directions,
  field,
  exact,
  norm,
  of,
  window,
  fraction,
  time,
  terms,
  factors,
};

/// A key as one kind uses it.
struct KeyUse {
  MeasurementKey key = MeasurementKey::none;
  std::string_view meaning = {};
  bool required = false;
};

/// SI units of a kind; `other` gives units that depend on more than the dimension.
struct KindUnit {
  std::string_view in_2d, in_3d;
  std::string_view (*other)(const Case&, const MeasurementCase&) = nullptr;
};

/// Units that depend on what a measurement refers to.
std::string_view unit_of_field(const Case& a_case, const MeasurementCase& m);
std::string_view unit_of_source(const Case& a_case, const MeasurementCase& m);
std::string_view unit_of_terms(const Case& a_case, const MeasurementCase& m);

namespace units {
inline constexpr KindUnit one{"1", "1"}, second{"s", "s"}, metre{"m", "m"}, area{"m", "m^2"},
    volume{"m^2", "m^3"}, mass{"kg/m", "kg"}, momentum{"kg m/s/m", "kg m/s"},
    angular_momentum{"kg m^2/s/m", "kg m^2/s"}, energy{"J/m", "J"}, force{"N/m", "N"},
    moment{"N m/m", "N m"}, of_field{{}, {}, unit_of_field}, of_source{{}, {}, unit_of_source},
    of_terms{{}, {}, unit_of_terms};
}  // namespace units

/// Uses of keys that several kinds share.
namespace key_uses {
inline constexpr KeyUse body{MeasurementKey::body}, side{MeasurementKey::side},
    where{MeasurementKey::where}, length{MeasurementKey::length},
    relative{MeasurementKey::relative}, of{MeasurementKey::of, "", true},
    component{MeasurementKey::axis, "component"};
constexpr KeyUse point(std::string_view meaning) { return {MeasurementKey::point, meaning, true}; }
}  // namespace key_uses

/// How samples follow from the values of a method.
enum class Sampling {
  value,         ///< the value itself
  rate,          ///< change since the last sample over the time since then: a force from an impulse
  from_history,  ///< from the history of another measurement, not from the method
};

struct MeasurementKind {
  MeasurementCase::Kind kind;
  std::string_view word;
  KindUnit unit;
  Sampling sampling;
  std::array<KeyUse, 5> keys;
  std::string_view meaning;
  std::string_view missing;  ///< meaning of a missing value
};

}  // namespace pliant
