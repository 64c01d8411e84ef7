#include "engine/cli/commands.hpp"

namespace pliant::cli {

namespace {

void add_comparison(CLI::App& command, BenchArguments& arguments) {
  command
      .add_option("--rows", arguments.rows,
                  "measure only rows with this in their name, as in\n"
                  "rotating_cylinder/compact (case/kernel/spacing/threads)")
      ->type_name("TEXT");
  command.add_option("--repetitions", arguments.repetitions, "measure each row this many times")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  command.add_option("--save", arguments.save, "write the figures for --compare to this file")
      ->type_name("FILE");
  command
      .add_option("--compare", arguments.compare,
                  "compare with the figures in this file; exit status 1\n"
                  "where a row is slower")
      ->type_name("FILE");
  command
      .add_option("--against", arguments.against,
                  "compare with another build of pliant, in turns; exit status 1\n"
                  "where a row is slower; default rows: --quick, compact kernel")
      ->type_name("PROGRAM");
  command
      .add_option("--tolerance", arguments.tolerance,
                  "by how much a row may be slower (default: 10%, with --against 1%)")
      ->type_name("SHARE");
  command.add_flag("--turns", arguments.turns,
                   "measure a piece of the row --rows for each byte on standard\n"
                   "input; the other side of --against");
  command.add_option("--markdown", arguments.markdown, "write the comparison as a Markdown table")
      ->type_name("FILE");
  command.add_flag("--json", arguments.json, "print what --save writes, and no tables");
}

void add_accuracy(CLI::App& command, BenchArguments& arguments) {
  command.add_flag("--accuracy", arguments.accuracy,
                   "measure the time to a given error instead: problems with\n"
                   "known answers over ladders of spacings");
  command
      .add_option("--ladders", arguments.ladders,
                  "problems and ladders of --accuracy (default: bench/accuracy.toml)")
      ->type_name("FILE");
  command
      .add_option("--out", arguments.folder,
                  "folder for the runs of --accuracy (default: results/accuracy)")
      ->type_name("FOLDER");
  command
      .add_option("--time-limit", arguments.time_limit,
                  "wall time of a run of --accuracy [s]; 0: none (default: that\n"
                  "of the ladders, with --quick 15)")
      ->check(CLI::Range(0.0, 1e9))
      ->type_name("SECONDS");
  command.add_flag("--resume", arguments.resume, "keep the runs of --accuracy that --out holds");
}

void add_bench(Commands& commands) {
  const auto arguments = std::make_shared<BenchArguments>();
  CLI::App& command =
      commands.add("bench", "Measure this machine and the speed of the program on it",
                   "bench --quick --csv speed.csv", arguments, &bench);
  command.add_flag("--quick", arguments->quick,
                   "fewer repetitions, and no more than 131 072 particles");
  command
      .add_option("--ball", arguments->ball, "measure only spinning balls of this many particles")
      ->check(CLI::Range(1000, 100'000'000))
      ->type_name("N");
  command
      .add_option("--growth", arguments->growth,
                  "measure set-up, memory and speed of free bodies of 10^4,\n"
                  "10^5, ... up to N particles, for each method")
      ->check(CLI::Range(10'000, 100'000'000))
      ->type_name("N");
  command.add_option("--csv", arguments->csv, "write all figures to this file")->type_name("FILE");
  command
      .add_option("--threads", arguments->threads,
                  "threads to compare with one (default: one per processor)")
      ->type_name("N");
  add_comparison(command, *arguments);
  add_accuracy(command, *arguments);
}

void add_machine(CLI::App& command, ProfileArguments& arguments) {
  command.add_option("--threads", arguments.threads, "worker threads (default: one per processor)")
      ->type_name("N");
  command
      .add_option("--isa", arguments.isa,
                  "instruction set: sse2, avx2 or avx512 (default: widest supported)")
      ->type_name("NAME");
}

void add_profile(Commands& commands) {
  const auto arguments = std::make_shared<ProfileArguments>();
  CLI::App& command = commands.add(
      "profile", "Measure whether a case holds a time budget for each frame",
      "profile cases/rotating_cylinder --budget 16.7ms --trace trace.json", arguments, &profile);
  add_case(command, arguments->source);
  const auto add = [&](const char* name, auto& value, const char* meaning, const char* type) {
    command.add_option(name, value, meaning)->type_name(type);
  };
  add("--budget", arguments->budget, "wall time for a frame (default: the frame time)", "TIME");
  add("--frame-time", arguments->frame_time,
      "simulated time of a frame (default: 1/60 s), as in 10ms", "TIME");
  command
      .add_option("--frames", arguments->frames,
                  "frames to measure, also beyond the end of the case\n"
                  "(default: all frames of the case, at most 600)")
      ->check(CLI::Range(1, 10'000'000))
      ->type_name("N");
  command
      .add_option("--warm-up", arguments->warm_up, "earlier frames that do not count (default: 10)")
      ->check(CLI::Range(0, 1'000'000))
      ->type_name("N");
  command
      .add_option("--at", arguments->percentile,
                  "share of the frames that must hold the budget [%]; 100: all")
      ->check(CLI::Range(1.0, 100.0))
      ->type_name("PERCENT")
      ->capture_default_str();
  command.add_flag("--fit", arguments->fit, "find the finest spacing that holds the budget");
  add("--trace", arguments->trace, "write what each thread ran, for Perfetto", "FILE");
  add("--report", arguments->report, "write all figures as JSON", "FILE");
  command.add_flag("--json", arguments->json, "print all figures as JSON");
  command.add_flag("--quiet", arguments->quiet, "show no progress");
  add_machine(command, *arguments);
  command.footer(
      "Exit status: 0 the budget is held, 1 it is missed; else as for other commands.\n\n" +
      command.get_footer());
}

}  // namespace

void add_measuring_commands(Commands& commands) {
  add_bench(commands);
  add_profile(commands);
}

}  // namespace pliant::cli
