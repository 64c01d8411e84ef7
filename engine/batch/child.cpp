#include "engine/batch/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string_view>

#include "engine/output/descriptor.hpp"

namespace pliant::batch {

namespace {

constexpr std::string_view parent_variable = "PLIANT_PARENT=";

/// Settings of a child process before it becomes another program.
class SpawnSettings {
 public:
  SpawnSettings(int lock, const std::filesystem::path& log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&actions_, 1, 2);
    // A descriptor that is duplicated onto itself stays open in the program.
    posix_spawn_file_actions_adddup2(&actions_, lock, lock);
    posix_spawnattr_init(&attributes_);
    sigset_t none, usual;
    sigemptyset(&none);
    sigemptyset(&usual);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD, SIGXFSZ})
      sigaddset(&usual, signal);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &usual);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_ = {};
  posix_spawnattr_t attributes_ = {};
};

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> environment() {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (!std::string_view(*variable).starts_with(parent_variable))
      variables.emplace_back(*variable);
  }
  variables.push_back(fmt::format("{}{}", parent_variable, ::getpid()));
  return variables;
}

}  // namespace

pid_t spawn(const std::vector<std::string>& command, const std::filesystem::path& log,
            const std::filesystem::path& lock) {
  const Descriptor held(lock, O_RDWR | O_CREAT);
  if (::flock(held.number(), LOCK_EX | LOCK_NB) != 0) {
    throw OutputError::system(lock, "lock it", errno);
  }
  const SpawnSettings settings(held.number(), log);
  std::vector<std::string> arguments = command, variables = environment();
  pid_t child = 0;
  const int error =
      posix_spawn(&child, command[0].c_str(), settings.actions(), settings.attributes(),
                  pointers(arguments).data(), pointers(variables).data());
  if (error != 0) throw OutputError::system(log, "start a program with its output there", error);
  return child;
}

bool is_locked(const std::filesystem::path& lock) {
  std::error_code unreadable;
  if (!std::filesystem::exists(lock, unreadable)) return false;
  const Descriptor file(lock, O_RDWR);
  return ::flock(file.number(), LOCK_EX | LOCK_NB) != 0;
}

bool lock_for_life(const std::filesystem::path& lock) {
  // Stays open until the process ends.
  const int file = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) throw OutputError::system(lock, "open it", errno);
  return ::flock(file, LOCK_EX | LOCK_NB) == 0;
}

void end_with_parent() {
  const char* parent =
      std::getenv(std::string(parent_variable.substr(0, parent_variable.size() - 1)).c_str());
  if (parent == nullptr) return;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  // The parent may already have ended.
  if (std::strtol(parent, nullptr, 10) != ::getppid()) ::raise(SIGTERM);
}

}  // namespace pliant::batch
