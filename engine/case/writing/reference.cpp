#include "engine/case/writing/reference.hpp"

#include <fmt/format.h>

#include "engine/case/vocabulary/vocabulary.hpp"
#include "engine/case/writing/table_describer.hpp"

namespace pliant {
namespace {

template <class Keys>
std::string describe_table(Keys&& keys) {
  TableDescriber table;
  table.walk(keys);
  return table.text();
}

/// Visits the whole case and writes one section for each of its tables.
class CaseDescriber {
 public:
  explicit CaseDescriber(MethodList methods) : methods_(methods) {}

  template <class Value>
  bool operator()(std::string_view key, Value&& value, const Notes& notes) {
    return top_level_(key, value, notes);
  }

  template <class Keys>
  void table(std::string_view key, std::string_view meaning, Keys&& keys) {
    section(fmt::format("[{}]", key), meaning, describe_table(keys));
  }

  template <class Keys>
  void optional_table(std::string_view key, std::string_view meaning, bool, Keys&& keys) {
    table(key, meaning, keys);
  }

  template <class Element, class Keys>
  void list(std::string_view key, std::string_view meaning, std::vector<Element>&, Keys&& keys) {
    section(fmt::format("[[{}]]", key), meaning, describe_table([&](auto& visit) {
              Element element;
              keys(visit, element);
            }));
  }

  void materials(std::string_view key, std::string_view meaning) {
    section(fmt::format("[{}.NAME]", key), meaning, describe_table([](auto& visit) {
              MaterialCase material;
              material_keys(visit, material);
            }));
  }

  void section(std::string_view title, std::string_view meaning, const std::string& table) {
    sections_ += fmt::format("\n## {}\n\n{}\n\n{}", title, meaning, table);
  }

  int dimension() const { return top_level_.dimension(); }
  MethodList methods() const { return methods_; }
  std::string text() const { return top_level_.text() + sections_; }

 private:
  MethodList methods_;
  TableDescriber top_level_;
  std::string sections_;
};

constexpr std::string_view introduction = R"md(# Case reference

Every key of a case file. This page is written by the program from the table that it checks case files against.

Units are SI. A *vector* is a list of `dimension` numbers. A *number* may also be a text with a formula of constants, as in
`spacing = "1/32"` or `"sqrt(pi/800)"`. A *formula* is a text of numbers, `x`, `y`, `z` [m], `t` [s], `pi`, `+ - * / ^`, `< > <= >= == !=`,
`&&`, `||`, `condition ? a : b`, and the functions `abs sign sqrt exp ln log10 sin cos tan asin acos atan atan2 sinh cosh tanh min max`
(and others of muParser). A *name* is made of letters, digits, `_` and `-`.

Any key can be set on the command line: `--set time.end=0.01`, and in lists by name or by position from 0:
`--set boundary.upper.velocity=[0,-10]`, `--set body.0.material.youngs_modulus=200`.

## Top level

)md";

}  // namespace

std::string case_reference_markdown(MethodList methods) {
  CaseDescriber describer(methods);
  Case a_case;
  case_keys(describer, a_case);
  describer.section("geometry", "The shape of a body, of a wall or of a region.",
                    describe_table([](auto& visit) {
                      Shape shape;
                      shape_keys(visit, shape);
                    }));
  describer.section("prony",
                    "Relaxation of the bulk modulus (`prony`, RP.10) or of the shear modulus "
                    "(`prony_shear`, TL.24) of a reduced polynomial.",
                    describe_table([](auto& visit) {
                      PronyCase prony;
                      prony_keys(visit, prony);
                    }));
  describer.section("dissipation", "Strengths of the dissipation (RP.23).",
                    describe_table([](auto& visit) {
                      DissipationCase dissipation;
                      dissipation_keys(visit, dissipation);
                    }));
  describer.section("rotation", "An initial rigid rotation of a body.",
                    describe_table([](auto& visit) {
                      RigidRotation rotation;
                      rotation_keys(visit, rotation);
                    }));
  describer.section("rotation of a wall",
                    "How a wall turns about an axis: its material points are at c + R (X - c), R "
                    "the rotation by the angle and c the centre, and move with the wall.",
                    describe_table([](auto& visit) {
                      WallRotation rotation;
                      wall_rotation_keys(visit, rotation);
                    }));
  describer.section("stress", "The stress of a body at t = 0, see [materials](materials.md).",
                    describe_table([](auto& visit) {
                      StressExpression stress;
                      stress_keys(visit, stress);
                    }));
  return std::string(introduction) + describer.text();
}

}  // namespace pliant
