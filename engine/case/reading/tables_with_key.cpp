#include "engine/case/reading/tables_with_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "engine/case/vocabulary/vocabulary.hpp"

namespace pliant {
namespace {

/// Visits the whole case and notes the tables that have one key.
class KeySearch {
 public:
  KeySearch(std::string_view key, MethodList methods) : key_(key), methods_(methods) {}

  template <class Value>
  bool operator()(std::string_view key, Value&&, const Notes&) {
    if (key == key_) titles_.push_back(title_);
    return true;
  }

  template <class Keys>
  void table(std::string_view key, std::string_view, Keys&& keys) {
    look_into(fmt::format("[{}]", key), [&] { keys(*this); });
  }

  template <class Keys>
  void optional_table(std::string_view key, std::string_view meaning, bool, Keys&& keys) {
    table(key, meaning, keys);
  }

  template <class Element, class Keys>
  void list(std::string_view key, std::string_view, std::vector<Element>&, Keys&& keys) {
    Element element;
    look_into(fmt::format("[[{}]]", key), [&] { keys(*this, element); });
  }

  void materials(std::string_view key, std::string_view) {
    MaterialCase material;
    look_into(fmt::format("[{}.NAME]", key), [&] { material_keys(*this, material); });
  }

  int dimension() const { return 3; }
  MethodList methods() const { return methods_; }
  std::string titles() const { return fmt::format("{}", fmt::join(titles_, " or ")); }

 private:
  template <class Look>
  void look_into(std::string title, Look&& look) {
    title_ = std::move(title);
    look();
    title_ = top_level;
  }

  static constexpr const char* top_level = "the case, above its first [table]";

  std::string_view key_;
  MethodList methods_;
  std::string title_ = top_level;
  std::vector<std::string> titles_;
};

}  // namespace

std::string tables_with_key(std::string_view key, MethodList methods) {
  KeySearch search(key, methods);
  Case a_case;
  case_keys(search, a_case);
  return search.titles();
}

}  // namespace pliant
