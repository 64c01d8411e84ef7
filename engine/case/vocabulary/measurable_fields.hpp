#pragma once

#include <array>
#include <string_view>

namespace pliant {

/// A field that measurements can read. Fields with a z exist only in 3D, except the stress out of
/// the plane.
struct MeasurableField {
  std::string_view name, unit;
};
inline constexpr auto measurable_fields = std::to_array<MeasurableField>({
    {"density", "kg/m^3"},   {"pressure", "Pa"},      {"velocity_x", "m/s"},
    {"velocity_y", "m/s"},   {"velocity_z", "m/s"},   {"displacement_x", "m"},
    {"displacement_y", "m"}, {"displacement_z", "m"}, {"stress_xx", "Pa"},
    {"stress_xy", "Pa"},     {"stress_xz", "Pa"},     {"stress_yy", "Pa"},
    {"stress_yz", "Pa"},     {"stress_zz", "Pa"},     {"von_mises_stress", "Pa"},
    {"strain_xx", "1"},      {"strain_xy", "1"},      {"strain_xz", "1"},
    {"strain_yy", "1"},      {"strain_yz", "1"},      {"strain_zz", "1"},
});

constexpr bool exists_in(const MeasurableField& field, int dimension) {
  const std::string_view name = field.name;
  return dimension == 3 || name == "stress_zz" || name.find('z', name.size() - 2) == name.npos;
}

}  // namespace pliant
