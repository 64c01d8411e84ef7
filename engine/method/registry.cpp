#include "engine/method/registry.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace pliant {

MethodRegistry::MethodRegistry(std::vector<RegisteredMethod> methods)
    : methods_(std::move(methods)) {
  for (const RegisteredMethod& method : methods_) rules_.push_back(method.rules);
}

const RegisteredMethod& MethodRegistry::find(std::string_view word) const {
  for (const RegisteredMethod& method : methods_) {
    if (method.rules.word == word) return method;
  }
  std::string known;
  for (const RegisteredMethod& method : methods_) {
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", method.rules.word);
  }
  throw std::invalid_argument(
      fmt::format("there is no method \"{}\"; take one of {}", word, known));
}

std::unique_ptr<Solver> MethodRegistry::make(const Case& settings,
                                             const SolverOptions& options) const {
  const RegisteredMethod& method = find(settings.method);
  Case with_rules = settings;
  with_rules.rules = &method.rules;
  return method.make(with_rules, options);
}

}  // namespace pliant
