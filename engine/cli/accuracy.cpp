#include "engine/cli/accuracy.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <csignal>
#include <cstdio>

#include "engine/accuracy/climb.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant::cli {

namespace {

constexpr double quick_time_limit = 15;  ///< [s]

accuracy::Ladders ladders_of(const BenchArguments& arguments) {
  accuracy::Ladders ladders =
      selected(accuracy::read_ladders(arguments.ladders.value_or("bench/accuracy.toml")),
               arguments.rows, arguments.quick);
  if (arguments.quick) ladders.time_limit = quick_time_limit;
  if (arguments.time_limit) ladders.time_limit = *arguments.time_limit;
  return ladders;
}

}  // namespace

void refuse_options_without_accuracy(const BenchArguments& arguments) {
  if (!arguments.accuracy &&
      (arguments.ladders || arguments.folder || arguments.resume || arguments.time_limit)) {
    throw InputError(
        "--ladders, --out, --resume and --time-limit: are for --accuracy; give it too");
  }
  if (arguments.accuracy && (arguments.against || arguments.compare || arguments.csv ||
                             arguments.ball || arguments.growth || !arguments.tolerance.empty())) {
    throw InputError(
        "--accuracy: not with --against, --compare, --csv, --ball, --growth or --tolerance; leave "
        "them out");
  }
}

ExitStatus accuracy(const BenchArguments& arguments) {
  std::signal(SIGPIPE, SIG_IGN);
  const accuracy::Ladders ladders = ladders_of(arguments);
  accuracy::ClimbOptions options;
  options.folder = arguments.folder.value_or("results/accuracy");
  options.threads = solver_options(arguments.threads, "").threads;
  options.repetitions = arguments.repetitions.value_or(1);
  options.resume = arguments.resume;
  const accuracy::AccuracyRecord record = climb(ladders, options);
  if (record.interrupted) {
    fmt::print(stderr, "interrupted; --resume continues it\n");
    return ExitStatus::interrupted;
  }
  fmt::print("{}", arguments.json ? json_of(record) : text_of(record));
  if (arguments.save) write_atomically(*arguments.save, json_of(record), Durable::no);
  if (arguments.markdown) write_atomically(*arguments.markdown, markdown_of(record), Durable::no);
  return ExitStatus::done;
}

}  // namespace pliant::cli
