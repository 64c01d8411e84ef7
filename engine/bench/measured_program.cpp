#include "engine/bench/measured_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <pliant/error.hpp>

#include <array>
#include <charconv>
#include <utility>
#include <vector>

namespace pliant::bench {

MeasuredProgram::MeasuredProgram(std::filesystem::path program, std::string row, int threads)
    : program_(std::move(program)), row_(std::move(row)) {
  std::array<int, 2> ends;
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw InputError("no socket can be made; close files");
  }
  connection_ = ends[0];
  std::vector<std::string> command = {
      program_.string(),          "bench",  "--quick", "--rows", row_, "--threads",
      fmt::format("{}", threads), "--turns"};
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  const int error =
      posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (error != 0) process_ = -1;  // turn() reports it
}

MeasuredProgram::~MeasuredProgram() {
  ::close(connection_);
  if (process_ < 0) return;
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

double MeasuredProgram::turn() {
  std::string line;
  char character = '\n';
  if (::send(connection_, &character, 1, MSG_NOSIGNAL) == 1) {
    while (::recv(connection_, &character, 1, 0) == 1 && character != '\n') line += character;
  }
  double rate = 0;
  std::from_chars(line.data(), line.data() + line.size(), rate);
  if (rate > 0) return rate;
  throw InputError(
      fmt::format("{}: cannot measure the row {}; give a pliant that has it, and `bench --turns`",
                  program_.string(), row_));
}

}  // namespace pliant::bench
