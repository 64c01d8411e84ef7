#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

/// Parts of plane cases that are turned against the lattice.
namespace pliant::test {

/// A turn of the plane.
class Turned {
 public:
  explicit Turned(double degrees)
      : c_(std::cos(degrees * std::numbers::pi / 180)),
        s_(std::sin(degrees * std::numbers::pi / 180)) {}

  std::string place(double x, double y) const {
    return fmt::format("{}, {}", x * c_ - y * s_, x * s_ + y * c_);
  }

  /// The components of a vector of formulas of which the y component is `text`, x is 0.
  std::string along_y(const std::string& text) const {
    return fmt::format("\"{}*({})\", \"{}*({})\"", -s_, text, c_, text);
  }

  /// The coordinates of the body as formulas.
  std::string x() const { return fmt::format("({}*x + {}*y)", c_, s_); }

  std::string rectangle(double left, double lower, double right, double upper) const {
    const auto side = [this](double px, double py, double nx, double ny) {
      return fmt::format("{{ shape = \"half_space\", point = [{}], normal = [{}] }}", place(px, py),
                         place(nx, ny));
    };
    return fmt::format(
        "{{ shape = \"intersection\", of = [{}, {}, {}, {}, "
        "{{ shape = \"box\", lower = [-9, -9], upper = [9, 9] }}] }}",
        side(left, lower, -1, 0), side(right, lower, 1, 0), side(left, lower, 0, -1),
        side(left, upper, 0, 1));
  }

 private:
  double c_, s_;
};

inline std::string body_of(const std::string& shape) {
  return fmt::format(R"toml([[body]]
name = "body"
material = {{ model = "linear", youngs_modulus = 1000, poissons_ratio = 0.3, density = 1 }}
geometry = {}
)toml",
                     shape);
}

inline std::string clamp_below(const Turned& turned) {
  return fmt::format(R"toml([[boundary]]
name = "clamp"
kind = "fixed"
geometry = {{ shape = "half_space", point = [0, 0], normal = [{}] }}
)toml",
                     turned.place(0, 1));
}

/// A traction along the upper end of a block of 1 m by 3 m; `size` is a formula [Pa].
inline std::string shear_of_block(double degrees, const std::string& size) {
  return fmt::format(R"toml([[boundary]]
name = "load"
kind = "traction"
geometry = {}
traction = [{}]
)toml",
                     Turned(degrees).rectangle(-0.2, 2.99, 1.2, 3.5),
                     Turned(degrees - 90).along_y(size));
}

}  // namespace pliant::test
