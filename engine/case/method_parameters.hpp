#pragma once

#include <any>
#include <vector>

namespace pliant {

/// The values of the keys that methods declare themselves, in one struct for each method.
class MethodParameters {
 public:
  /// The values of one method; defaults if the case has none.
  template <class Parameters>
  const Parameters& as() const {
    static const Parameters defaults;
    for (const std::any& one : values_) {
      if (const auto* values = std::any_cast<Parameters>(&one)) return *values;
    }
    return defaults;
  }

  /// The values of one method, to write; valid until those of another method are first written.
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
