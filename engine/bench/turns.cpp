#include "engine/bench/turns.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <cstdio>
#include <utility>

#include "engine/bench/steps.hpp"
#include "engine/simulation/methods.hpp"

namespace pliant::bench {

Turns::Turns(Row row) : row_(std::move(row)) { set_up(); }

void Turns::set_up() {
  solver_ = methods().make(row_.settings, {row_.threads, kernels::widest_supported()});
  advance(*solver_, row_.window.steps_before);
}

double Turns::next() {
  if (is_over(*solver_)) set_up();
  const std::int64_t stages = solver_->particle_stages();
  const double seconds = advance(*solver_, row_.window.turn).compared(row_.threads);
  return static_cast<double>(solver_->particle_stages() - stages) / seconds;
}

void answer_turns(const StandardSetOptions& options) {
  for (Row& row : standard_set(options)) {
    if (row.name() != options.rows) continue;
    Turns turns(std::move(row));
    while (std::getchar() != EOF) {
      fmt::print("{}\n", turns.next());
      std::fflush(stdout);
    }
    return;
  }
  throw InputError(
      fmt::format("--turns: the set has no row of the name {}; give the whole name", options.rows));
}

}  // namespace pliant::bench
