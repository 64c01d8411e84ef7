#pragma once

#include <toml++/toml.h>
#include <string_view>

#include "engine/case/method_rules.hpp"
#include "engine/case/problems.hpp"
#include "engine/case/vocabulary/words.hpp"

/// What the checks of a case have in common.
namespace pliant {

/// A case during its checks: its values, its TOML source for places in messages, and the problems
/// found so far.
struct Check {
  const Case& a_case;
  const toml::table& root;
  const Place& start;
  MethodList methods;
  Problems& problems;

  /// The place of [table] key; if it does not exist, of the table, or of the start of the file.
  Place place(std::string_view table, std::string_view key) const {
    return place_in(root[table], key);
  }

  /// The same in element `index` of [[list]].
  Place place(std::string_view list, std::size_t index, std::string_view key) const {
    return place_in(root[list][index], key);
  }

  Place place_in(toml::node_view<const toml::node> table, std::string_view key) const {
    if (table[key]) return place_of(*table[key].node());
    return table ? place_of(*table.node()) : start;
  }
};

/// False for a shape with problems, which have been reported.
bool is_whole(const Shape& shape, int dimension);

inline std::string_view axis_name(int axis) { return words<Axis>[axis].text; }

/// Checks the combinations of values of a case. Each value is valid, and meshes are loaded.
void check_case(const Check& check);

/// Checks materials, and whether bodies fit the spacing and the periodic cell.
void check_bodies(const Check& check);

/// Finds what the method of the case cannot do, and tables of other methods.
void check_method(const Check& check);

void check_contacts(const Check& check);

void check_measurements(const Check& check);

}  // namespace pliant
