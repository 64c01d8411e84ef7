#include "engine/bench/against.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <pliant/error.hpp>

#include <array>
#include <cstdio>

namespace pliant::bench {

namespace {

constexpr int least_pairs = 16;

/// Standard output of a program that ends with status 0; what it says on stderr is dropped.
std::string output_of(std::vector<std::string> command) {
  std::array<int, 2> pipe;
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw InputError("no pipe can be made; close files");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], 1);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  std::string text;
  std::array<char, 4096> part;
  ssize_t size = 0;
  while (error == 0 && (size = ::read(pipe[0], part.data(), part.size())) > 0) {
    text.append(part.data(), static_cast<std::size_t>(size));
  }
  ::close(pipe[0]);
  int status = -1;
  if (error == 0) ::waitpid(child, &status, 0);
  if (status == 0) return text;
  throw InputError(
      fmt::format("{}: cannot measure a row; give a pliant that has `bench --rows`", command[0]));
}

/// What one program measures of a row [particle-stages/s].
double rate_of(const std::filesystem::path& program, const std::string& row, int threads) {
  const std::string text = output_of({program.string(), "bench", "--rows", row, "--repetitions",
                                      "1", "--threads", fmt::format("{}", threads), "--json"});
  const Record record = parse_record(text, program.string());
  for (const RecordedRow& found : record.rows) {
    if (found.name == row) return found.samples[0].rate;
  }
  throw InputError(fmt::format("{}: does not know the row {}; give --rows that both programs have",
                               program.string(), row));
}

class Pairs {
 public:
  Pairs(const AgainstOptions& options, std::string row) : options_(options), row_(std::move(row)) {}

  bool is_decided() const {
    const int pairs = count();
    if (pairs >= options_.most_pairs) return true;
    if (pairs < least_pairs) return false;
    const Interval ratio = paired_ratio(other_, own_);
    return ratio.upper - ratio.lower < 2 * options_.width * ratio.value;
  }

  // The order alternates, so that a machine that becomes slower wrongs neither.
  void measure() {
    const bool own_first = count() % 2 == 0;
    if (own_first) own_.push_back(rate_of(options_.program, row_, options_.threads));
    other_.push_back(rate_of(options_.other, row_, options_.threads));
    if (!own_first) own_.push_back(rate_of(options_.program, row_, options_.threads));
    if (options_.quiet) return;
    fmt::print(stderr, "{}, pair {}: {:.2f} and {:.2f} M/s\n", row_, count(), 1e-6 * own_.back(),
               1e-6 * other_.back());
  }

  Against result() const {
    const Interval ratio = paired_ratio(other_, own_);
    return {row_, count(), ratio, judge(ratio, options_.tolerance)};
  }

 private:
  int count() const { return static_cast<int>(other_.size()); }

  const AgainstOptions& options_;
  std::string row_;
  std::vector<double> own_, other_;
};

}  // namespace

std::vector<Against> compare_programs(const AgainstOptions& options) {
  std::vector<Pairs> rows;
  rows.reserve(options.rows.size());
  for (const std::string& row : options.rows) rows.emplace_back(options, row);
  for (bool is_decided = false; !is_decided;) {
    is_decided = true;
    for (Pairs& row : rows) {
      if (row.is_decided()) continue;
      row.measure();
      is_decided = false;
    }
  }
  std::vector<Against> found;
  found.reserve(rows.size());
  for (const Pairs& row : rows) found.push_back(row.result());
  return found;
}

std::string text_of(const std::vector<Against>& found) {
  std::string text = fmt::format("{:<52}{:>7}{:>9}{:>20}  {}\n", "row", "pairs", "ratio",
                                 "99.9 % interval", "verdict");
  for (const Against& row : found) {
    text += fmt::format("{:<52}{:>7}{:>9.4f}{:>20}  {}\n", row.name, row.pairs, row.ratio.value,
                        fmt::format("{:.4f}..{:.4f}", row.ratio.lower, row.ratio.upper),
                        text_of(row.verdict));
  }
  return text + "Ratio: speed of this program over that of the other one.\n";
}

std::string markdown_of(const std::vector<Against>& found) {
  std::string text =
      "| row | pairs | ratio of speeds | 99.9 % interval | verdict |\n| --- | --- | --- | --- | "
      "--- |\n";
  for (const Against& row : found) {
    text += fmt::format("| {} | {} | {:.4f} | {:.4f} to {:.4f} | {} |\n", row.name, row.pairs,
                        row.ratio.value, row.ratio.lower, row.ratio.upper, text_of(row.verdict));
  }
  return text + "\nRatio: speed of this build over that of the other one, measured in turns.\n";
}

}  // namespace pliant::bench
