#include "engine/method/step_failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/case/checks/stability.hpp"

namespace pliant {

StepFailure failed_step(const Case& settings, const StepClock& clock, const std::string& what,
                        const std::vector<std::string>& remedies) {
  const std::string cause = stability_warning(settings, clock.wave_speed);
  if (!cause.empty()) {
    return StepFailure(
        fmt::format("t = {:.6g}, step {}: {}; {}", clock.time, clock.step, what, cause));
  }
  std::string list = remedies.front();
  for (std::size_t i = 1; i < remedies.size(); ++i) {
    list += (i + 1 == remedies.size() ? ", or " : ", ") + remedies[i];
  }
  return StepFailure(
      fmt::format("t = {:.6g}, step {}: {}; {}", clock.time, clock.step, what, list));
}

std::string smaller_step(const Case& settings) {
  if (step_limits(settings).mass_follows_step) return "scale the mass more (a smaller time.cfl)";
  return settings.time.step ? "use a smaller time step (time.step)"
                            : "use a smaller time step (time.cfl)";
}

template <int D>
std::string coordinates(const Point<D>& x) {
  return fmt::format("({:.4g})", fmt::join(x, ", "));
}

template std::string coordinates<2>(const Point<2>&);
template std::string coordinates<3>(const Point<3>&);

}  // namespace pliant
