#include <fmt/format.h>

#include "engine/case/check.hpp"

// What a case asks for that its method cannot do.
namespace pliant {

void refuse_tables(const Check& check, std::initializer_list<std::string_view> tables) {
  for (const std::string_view key : tables) {
    const toml::node* node = check.root.get(key);
    if (!node || (node->is_table() && node->as_table()->empty())) continue;
    const std::string title =
        node->is_array() ? fmt::format("[[{}]]", key) : fmt::format("[{}]", key);
    check.problems.add(check.place(key, ""),
                       fmt::format("method \"{}\" has no {}", check.a_case.method, title),
                       "leave the table out, or choose another method");
  }
}

void check_method(const Check& check) {
  for (const MethodRules& method : check.methods) {
    if (method.word == check.a_case.method) {
      method.check(check);
    } else {
      refuse_tables(check, {method.word});
    }
  }
}

}  // namespace pliant
