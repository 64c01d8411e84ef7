#include <fcntl.h>
#include <fmt/format.h>
#include <pliant/error.hpp>

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "engine/cli/command_line.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/output/colour.hpp"
#include "engine/output/error.hpp"

// The program: prepares the process before files are opened, and converts exceptions to exit
// statuses.

namespace {

using namespace pliant::cli;

constexpr auto stdout_failed =
    "standard output cannot be written; check the disk or the program that reads it";
constexpr auto too_large =
    "the case needs more memory than there is; use a coarser spacing, "
    "--set discretisation.spacing=...";

/// If stderr is closed, the next file to be opened would take its descriptor and receive messages.
void open_standard_streams() {
  for (const int descriptor : {0, 1, 2}) {
    if (::fcntl(descriptor, F_GETFD) < 0) ::open("/dev/null", O_RDWR);
  }
}

ExitStatus fail(ExitStatus status, std::string_view message) {
  const std::string text = pliant::coloured(message, pliant::Colour::red, stderr);
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fputc('\n', stderr);
  return status;
}

/// Prints the present exception. Only user errors are bad input.
ExitStatus report_exception() {
  constexpr auto failed = ExitStatus::run_failed;
  try {
    throw;
  } catch (const pliant::InputError& error) {
    return fail(ExitStatus::bad_input, error.what());
  } catch (const pliant::OutputError& error) {
    return fail(failed, error.what());
  } catch (const pliant::StepFailure& error) {
    return fail(failed, error.what());
  } catch (const pliant::RunError& error) {
    return fail(failed, error.what());
  } catch (const std::bad_alloc&) {
    return fail(failed, too_large);
  } catch (const std::length_error&) {
    return fail(failed, too_large);
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(failed, fmt::format("{}: {}; check the path and its permissions",
                                    error.path1().string(), error.code().message()));
  } catch (const std::system_error& error) {
    if (std::ferror(stdout)) return fail(failed, stdout_failed);
    return fail(failed, fmt::format("the system refused a request: {}; free some memory or disk "
                                    "space, or use fewer --threads",
                                    error.code().message()));
  } catch (const std::exception& error) {
    return fail(failed, fmt::format("internal error: {}; please report it with the case file",
                                    error.what()));
  } catch (...) {
    return fail(failed, "internal error of an unknown kind; please report it with the case file");
  }
}

ExitStatus run_program(int argc, char** argv) {
  try {
    const ExitStatus status = read_command_line(argc, argv)();
    if (std::fflush(stdout) == 0) return status;
    return fail(ExitStatus::run_failed, stdout_failed);
  } catch (...) {
    return report_exception();
  }
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  // Exceeding the file size limit (`ulimit -f`) should be an error like a full disk, not the end of
  // the process.
  std::signal(SIGXFSZ, SIG_IGN);
  return static_cast<int>(run_program(argc, argv));
}
