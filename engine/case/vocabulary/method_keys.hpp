#pragma once

#include <string_view>
#include <type_traits>

#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/word.hpp"

namespace pliant {

/// A visitor of the keys in the table [NAME] that a method declares. It hides the types of the
/// vocabulary's visitors, so that methods do not depend on reading and writing.
class MethodKeys {
 public:
  MethodKeys() = default;
  MethodKeys(const MethodKeys&) = delete;
  MethodKeys& operator=(const MethodKeys&) = delete;
  virtual ~MethodKeys() = default;

  /// Visits a key and its value; returns false if the value is not usable.
  virtual bool operator()(std::string_view key, double& value, const Notes& notes) = 0;
  virtual bool operator()(std::string_view key, int& value, const Notes& notes) = 0;
  virtual bool operator()(std::string_view key, bool& value, const Notes& notes) = 0;
  virtual bool operator()(std::string_view key, NumberOrWord value, const Notes& notes) = 0;
  virtual bool operator()(std::string_view key, Choice value, const Notes& notes) = 0;

  /// The same for an enumeration with `words<E>`.
  template <class E>
  requires std::is_enum_v<E>
  bool operator()(std::string_view key, E& value, const Notes& notes) {
    int number = static_cast<int>(value);
    const bool is_usable = (*this)(key, Choice{number, words<E>}, notes);
    value = static_cast<E>(number);
    return is_usable;
  }
};

/// Passes each key to a visitor of the vocabulary.
template <class Visitor>
class MethodKeysFor final : public MethodKeys {
 public:
  explicit MethodKeysFor(Visitor& visit) : visit_(visit) {}

  bool operator()(std::string_view key, double& value, const Notes& notes) override {
    return visit_(key, value, notes);
  }
  bool operator()(std::string_view key, int& value, const Notes& notes) override {
    return visit_(key, value, notes);
  }
  bool operator()(std::string_view key, bool& value, const Notes& notes) override {
    return visit_(key, value, notes);
  }
  bool operator()(std::string_view key, NumberOrWord value, const Notes& notes) override {
    return visit_(key, value, notes);
  }
  bool operator()(std::string_view key, Choice value, const Notes& notes) override {
    return visit_(key, value, notes);
  }

 private:
  Visitor& visit_;
};

}  // namespace pliant
