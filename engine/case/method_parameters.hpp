#pragma once

#include <any>
#include <vector>

namespace pliant {

/// The values of the keys that methods declare themselves: for each method a struct of its own.
class MethodParameters {
 public:
  /// Those of one method; its defaults where the case has none.
  template <class Parameters>
  const Parameters& as() const {
    static const Parameters defaults;
    for (const std::any& one : values_) {
      if (const auto* values = std::any_cast<Parameters>(&one)) return *values;
    }
    return defaults;
  }

  /// Those of one method, to write to; valid until those of another one are first written to.
  template <class Parameters>
  Parameters& as() {
    for (std::any& one : values_) {
      if (auto* values = std::any_cast<Parameters>(&one)) return *values;
    }
    return values_.emplace_back().emplace<Parameters>();
  }

 private:
  std::vector<std::any> values_;
};

}  // namespace pliant
