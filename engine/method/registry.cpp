#include "engine/method/registry.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "engine/case/words.hpp"

namespace pliant {

const RegisteredMethod& MethodRegistry::find(std::string_view word) const {
  for (const RegisteredMethod& method : methods_) {
    if (method.word == word) return method;
  }
  std::string known;
  for (const RegisteredMethod& method : methods_) {
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", method.word);
  }
  throw std::invalid_argument(
      fmt::format("there is no method \"{}\"; take one of {}", word, known));
}

std::unique_ptr<Solver> MethodRegistry::make(const Case& settings,
                                             const SolverOptions& options) const {
  return find(words<Method>[static_cast<int>(settings.method)].text).make(settings, options);
}

}  // namespace pliant
