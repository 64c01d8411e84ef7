#include <fmt/format.h>
#include <pliant/error.hpp>

#include <algorithm>

#include "engine/bench/against.hpp"
#include "engine/bench/comparison.hpp"
#include "engine/bench/standard_set.hpp"
#include "engine/bench/turns.hpp"
#include "engine/cli/accuracy.hpp"
#include "engine/cli/actions.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/simulation/solver_options.hpp"

namespace pliant::cli {

namespace {

using bench::Verdict;

double tolerance_of(const BenchArguments& arguments, double usual) {
  return arguments.tolerance.empty() ? usual : bench::share_of(arguments.tolerance, "--tolerance");
}

/// Prints a comparison; `Row` is the type of its rows.
template <class Row>
ExitStatus end_with(const std::vector<Row>& rows, const BenchArguments& arguments,
                    const std::string& text, const std::string& markdown) {
  if (!arguments.json) fmt::print("\n{}", text);
  if (arguments.markdown) write_atomically(*arguments.markdown, markdown, Durable::no);
  const bool slower =
      std::ranges::any_of(rows, [](const Row& row) { return row.verdict == Verdict::slower; });
  return slower ? ExitStatus::missed : ExitStatus::done;
}

ExitStatus compare_with_program(const BenchArguments& arguments,
                                bench::StandardSetOptions options) {
  options.quick = true;
  if (options.rows.empty()) options.rows = "compact/";
  bench::AgainstOptions against;
  against.other = std::filesystem::absolute(*arguments.against);
  against.rows = names_of_rows(options);
  against.threads = options.threads;
  against.tolerance = tolerance_of(arguments, against.tolerance);
  if (arguments.repetitions) against.most_pairs = *arguments.repetitions;
  const auto found = compare_programs(against);
  return end_with(found, arguments, text_of(found), markdown_of(found));
}

ExitStatus compare_with_record(const BenchArguments& arguments, const bench::Record& before,
                               const bench::Record& now) {
  const double tolerance = tolerance_of(arguments, 0.1);
  const auto found = changes(before, now, tolerance);
  if (found.empty()) {
    throw InputError(
        fmt::format("{}: has none of the rows that were measured; give the same "
                    "--rows, --quick and --threads as for --save",
                    arguments.compare->string()));
  }
  return end_with(found, arguments, text_of(found, tolerance), markdown_of(found, tolerance));
}

void refuse_contradictions(const BenchArguments& arguments) {
  refuse_options_without_accuracy(arguments);
  if (arguments.against && (arguments.compare || arguments.save || arguments.csv)) {
    throw InputError("--against: not with --compare, --save or --csv; take one of them");
  }
  if (arguments.growth && (arguments.ball || arguments.against || arguments.compare)) {
    throw InputError("--growth: not with --ball, --against or --compare; leave them out");
  }
  if (arguments.markdown && !arguments.against && !arguments.compare && !arguments.accuracy &&
      !arguments.growth) {
    throw InputError(
        "--markdown: is for tables of --compare, --against, --accuracy and --growth; give one too");
  }
  if (!arguments.tolerance.empty()) tolerance_of(arguments, 0);
}

}  // namespace

ExitStatus bench(const BenchArguments& arguments) {
  refuse_contradictions(arguments);
  if (arguments.accuracy) return accuracy(arguments);
  bench::StandardSetOptions options;
  options.quick = arguments.quick;
  options.ball = arguments.ball;
  options.largest = arguments.growth;
  if (arguments.growth) options.growth_markdown = arguments.markdown;
  options.csv = arguments.csv;
  options.threads = solver_options(arguments.threads, "").threads;
  options.rows = arguments.rows;
  options.repetitions = arguments.repetitions;
  options.tables = !arguments.json;
  if (arguments.against) return compare_with_program(arguments, options);
  if (arguments.turns) {
    answer_turns(options);
    return ExitStatus::done;
  }
  // Read first, so that a wrong name is reported at once.
  std::optional<bench::Record> before;
  if (arguments.compare) before = bench::read_record(*arguments.compare);
  const bench::Record now = run_standard_set(options);
  if (arguments.json) fmt::print("{}", json_of(now));
  if (arguments.save) write_atomically(*arguments.save, json_of(now), Durable::no);
  return before ? compare_with_record(arguments, *before, now) : ExitStatus::done;
}

}  // namespace pliant::cli
