#include "engine/profile/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/case/vocabulary/words.hpp"
#include "kernels/isa.hpp"

namespace pliant::profile {

namespace {

// Parts below this share of the time are combined in one line.
constexpr double small_share = 0.005;

std::string heading(const Profile& profile) {
  const Case& settings = profile.settings;
  const ProfileOptions& options = profile.options;
  std::string text =
      fmt::format("{}: {}, {} precision, {} particles, spacing {:.4g} m\n", settings.name,
                  settings.method, words<Precision>[static_cast<int>(settings.precision)].text,
                  profile.particles, settings.discretisation.spacing);
  for (const std::string& line : profile.machine) text += line + "\n";
  text += fmt::format("threads: {}, {}; load {:.2f} before, {:.2f} after\n",
                      options.machine.threads, kernels::name(options.machine.isa),
                      profile.load_before, profile.frames.back().load);
  text +=
      fmt::format("{} frames of {} simulated time in {} steps, after a warm-up of {} frames{}\n",
                  profile.frames.size(), short_time(options.frame_seconds), profile.steps.size(),
                  profile.warm_up, profile.interrupted ? "; interrupted" : "");
  text += fmt::format("measuring took {:.2f} % of the time of the steps, which is not counted\n",
                      100 * profile.own_share);
  return text;
}

std::string percentile_name(double percentile) {
  return percentile == 100 ? "every frame" : fmt::format("p{:g}", percentile);
}

std::string result(const Profile& profile, const Verdict& verdict) {
  const ProfileOptions& options = profile.options;
  const auto count = static_cast<double>(profile.frames.size());
  std::string text =
      fmt::format("\nbudget {} at {}: {} ({})\n", short_time(options.budget),
                  percentile_name(options.percentile), verdict.held ? "HELD" : "MISSED",
                  short_time(verdict.at_percentile));
  text += fmt::format("missed deadlines: {} of {} frames ({:.1f} %), at most {} in a row\n",
                      verdict.missed, profile.frames.size(),
                      100 * static_cast<double>(verdict.missed) / count, verdict.longest_streak);
  text += fmt::format("real-time factor: {:.3g} (simulated time over wall time)\n\n",
                      verdict.real_time_factor);
  text += fmt::format("{:<14}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "time [ms]", "mean", "p50",
                      "p95", "p99", "p99.9", "max");
  const auto row = [&](const char* name, const Distribution& times) {
    text += fmt::format("{:<14}{:>11.4g}{:>11.4g}{:>11.4g}{:>11.4g}{:>11.4g}{:>11.4g}\n", name,
                        1e3 * times.mean, 1e3 * times.p50, 1e3 * times.p95, 1e3 * times.p99,
                        1e3 * times.p999, 1e3 * times.most);
  };
  row("frame", verdict.frames);
  row("step", verdict.steps);
  return text;
}

std::string parts_table(const Verdict& verdict) {
  std::string text = fmt::format("\n{:<32}{:>9}{:>13}{:>15}{:>13}\n", "part of a frame", "share %",
                                 "median [ms]", "worst 10 [ms]", "excess [ms]");
  Part rest{"others", 0, 0, 0};
  const auto row = [&](const Part& part) {
    text += fmt::format("{:<32}{:>9.1f}{:>13.4f}{:>15.4f}{:>13.4f}\n", part.name, 100 * part.share,
                        1e3 * part.median, 1e3 * part.in_worst, 1e3 * part.excess());
  };
  for (std::size_t i = 0; i < verdict.parts.size(); ++i) {
    const Part& part = verdict.parts[i];
    if (part.share >= small_share || i == verdict.to_blame) {
      row(part);
    } else {
      rest.share += part.share;
      rest.median += part.median;
      rest.in_worst += part.in_worst;
    }
  }
  if (rest.share > 0) row(rest);
  return text;
}

std::string largest_excess(const Verdict& verdict, const FrameRecord& frame,
                           const std::vector<std::string>& names) {
  const std::vector<double> parts = parts_of(frame);
  std::string name;
  double most = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto part = std::find_if(verdict.parts.begin(), verdict.parts.end(),
                                   [&](const Part& one) { return one.name == names[i]; });
    if (parts[i] - part->median <= most) continue;
    most = parts[i] - part->median;
    name = names[i];
  }
  return name.empty() ? "" : fmt::format("{} +{}", name, short_time(most));
}

std::string worst_table(const Profile& profile, const Verdict& verdict) {
  std::string text = fmt::format("\n{:>12} {:>11} {:>6} {:>7} {:>6} {:>9} {:>7}  {}\n",
                                 "worst, t [s]", "frame [ms]", "steps", "remesh", "CPU %",
                                 "switches", "stolen", "largest excess over the median");
  const auto names = names_of_parts(profile.phases);
  const double threads = profile.options.machine.threads;
  for (const std::size_t index : verdict.worst) {
    const FrameRecord& frame = profile.frames[index];
    text +=
        fmt::format("{:>12.5g} {:>11.4g} {:>6} {:>7} {:>6.0f} {:>9} {:>7.0f}  {}\n",
                    frame.simulated_time, 1e3 * frame.wall_seconds, frame.steps, frame.remeshings,
                    100 * frame.machine.processor_seconds / (threads * frame.wall_seconds),
                    frame.machine.involuntary_switches, 1e3 * frame.machine.stolen_seconds,
                    largest_excess(verdict, frame, names));
  }
  return text +
         "CPU %: processor time over threads x wall time. switches: involuntary context switches.\n"
         "stolen: time that the host gave to other guests [ms, in ticks of 10].\n";
}

/// Ratio of processor time to the time that threads spent in steps without waiting. Below 1, the
/// machine did other work; above 1, waiting threads kept their processors.
double processor_share(const Profile& profile, const std::vector<std::size_t>& frames) {
  double processor = 0, working = 0;
  const double threads = profile.options.machine.threads;
  for (const std::size_t index : frames) {
    const FrameRecord& frame = profile.frames[index];
    processor += frame.machine.processor_seconds;
    working += threads * (frame.wall_seconds - frame.waiting_seconds - frame.serial_seconds) +
               frame.serial_seconds;
  }
  return processor / working;
}

std::string blame(const Profile& profile, const Verdict& verdict) {
  const Part& part = verdict.parts[verdict.to_blame];
  std::string text = fmt::format("\ncause: `{}`, {} longer in the worst frames than its median\n",
                                 part.name, short_time(std::max(0.0, part.excess())));
  const double share = processor_share(profile, verdict.worst);
  constexpr double undisturbed = 0.9;
  if (share < undisturbed) {
    text += fmt::format(
        "the machine was busy with other work: in the worst frames the threads had a processor for "
        "{:.0f} %\nof the time that they worked; repeat this on a quiet machine\n",
        100 * share);
  }
  return text;
}

}  // namespace

std::string short_time(double seconds) {
  if (seconds >= 0.9995) return fmt::format("{:.3g} s", seconds);
  if (seconds >= 0.9995e-3) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} us", 1e6 * seconds);
}

std::string text_of(const Profile& profile, const Verdict& verdict) {
  return heading(profile) + result(profile, verdict) + parts_table(verdict) +
         worst_table(profile, verdict) + blame(profile, verdict);
}

}  // namespace pliant::profile
