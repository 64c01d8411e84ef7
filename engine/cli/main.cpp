#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <new>

#include <pliant/version.hpp>
#include "engine/cli/verbs.hpp"
#include "engine/method/step_failure.hpp"
#include "engine/output/error.hpp"

// The command line: options to plain arguments, exceptions to exit statuses.

namespace {

using namespace pliant::cli;

int fail(const std::exception& error, ExitStatus status) {
  std::fprintf(stderr, "%s\n", error.what());
  return static_cast<int>(status);
}

int finish(const std::function<ExitStatus()>& verb) {
  try {
    return static_cast<int>(verb());
  } catch (const pliant::OutputError& error) {
    return fail(error, ExitStatus::run_failed);
  } catch (const pliant::StepFailure& error) {
    return fail(error, ExitStatus::run_failed);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr,
                 "out of memory; use a coarser spacing, --set discretisation.spacing=...\n");
    return static_cast<int>(ExitStatus::run_failed);
  } catch (
      const std::exception& error) {  // what is left is wrong input: CaseError, invalid_argument
    return fail(error, ExitStatus::bad_input);
  }
}

void add_case(CLI::App& verb, CaseArguments& arguments) {
  verb.add_option("CASE", arguments.path, "case file, or folder with a case.toml")->required();
  verb.add_option("--set", arguments.settings,
                  "override a key, as in --set discretisation.spacing=0.01; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::App* add_verb(CLI::App& app, const char* name, const char* description, const char* example) {
  CLI::App* verb = app.add_subcommand(name, description);
  verb->footer(std::string("Example:\n  pliant ") + example);
  return verb;
}

void add_run(CLI::App& app, RunArguments& arguments, std::function<ExitStatus()>& chosen) {
  CLI::App* verb = add_verb(app, "run", "Run a case and write its results",
                            "run cases/rotating_cylinder --set time.end=0.1 --out results/short");
  add_case(*verb, arguments.source);
  verb->add_option("--out", arguments.folder, "folder for the results (default: results/<case>)");
  verb->add_option("--threads", arguments.threads, "worker threads (default: one a processor)");
  verb->add_option("--isa", arguments.isa,
                   "force sse2, avx2 or avx512 (default: widest supported)");
  verb->add_flag("--resume", arguments.resume, "go on from the last checkpoint in the folder");
  verb->add_flag("--quiet", arguments.quiet, "no progress");
  verb->callback([&] { chosen = [&] { return run(arguments); }; });
}

void add_graph(CLI::App& app, GraphArguments& arguments, std::function<ExitStatus()>& chosen) {
  CLI::App* verb = add_verb(app, "graph", "Print the step graph of a case",
                            "graph cases/rotating_cylinder | dot -Tsvg > step.svg");
  add_case(*verb, arguments.source);
  verb->add_option("--format", arguments.format, "dot or json")
      ->check(CLI::IsMember({"dot", "json"}))
      ->capture_default_str();
  verb->add_flag("--blocks", arguments.blocks, "a node for each phase and block (dot)");
  verb->callback([&] { chosen = [&] { return graph(arguments); }; });
}

void add_bench(CLI::App& app, BenchArguments& arguments, std::function<ExitStatus()>& chosen) {
  CLI::App* verb = add_verb(app, "bench", "Measure this machine and the speed of the program on it",
                            "bench --quick --csv speed.csv");
  verb->add_flag("--quick", arguments.quick, "fewer repetitions, no more than 131 072 particles");
  verb->add_option("--ball", arguments.ball,
                   "measure nothing but spinning balls of this many particles")
      ->check(CLI::Range(1000, 100'000'000));
  verb->add_option("--csv", arguments.csv, "write all figures to this file");
  verb->add_option("--threads", arguments.threads,
                   "threads to compare with one (default: one a processor)");
  verb->callback([&] { chosen = [&] { return bench(arguments); }; });
}

int run_program(int argc, char** argv) {
  CLI::App app("Simulates elastic solids and soft tissue with particles.", "pliant");
  app.set_version_flag("--version", "pliant " + std::string(pliant::version));
  app.set_help_flag("-h,--help", "Print this help; `pliant help VERB` explains a verb");
  app.require_subcommand(1);
  std::function<ExitStatus()> chosen;

  RunArguments run_arguments;
  add_run(app, run_arguments, chosen);
  CaseArguments check_arguments;
  CLI::App* check_verb = add_verb(app, "check", "Check a case and say what it would run",
                                  "check cases/rotating_cylinder");
  add_case(*check_verb, check_arguments);
  check_verb->callback([&] { chosen = [&] { return check(check_arguments); }; });
  std::filesystem::path list_folder = "cases";
  CLI::App* list_verb = add_verb(app, "list", "List the cases of a folder", "list cases");
  list_verb->add_option("FOLDER", list_folder, "folder with one folder a case")
      ->capture_default_str();
  list_verb->callback([&] { chosen = [&] { return list(list_folder); }; });
  GraphArguments graph_arguments;
  add_graph(app, graph_arguments, chosen);
  BenchArguments bench_arguments;
  add_bench(app, bench_arguments, chosen);
  CLI::App* reference_verb = add_verb(app, "reference", "Print the reference of case files",
                                      "reference > case-reference.md");
  reference_verb->callback([&] { chosen = [] { return reference(); }; });
  std::string explained;
  CLI::App* help_verb = add_verb(app, "help", "Explain a verb", "help run");
  help_verb->add_option("VERB", explained, "the verb to explain");
  help_verb->callback([&] {
    const CLI::App* about = &app;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
      if (verb->get_name() == explained) about = verb;
    }
    std::fputs(about->help().c_str(), stdout);
    chosen = [] { return ExitStatus::done; };
  });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitStatus::bad_input);
  }
  return finish(chosen);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (...) {
    std::fputs("pliant: the command line could not be set up\n", stderr);
    return static_cast<int>(ExitStatus::run_failed);
  }
}
