#include "engine/accuracy/reach.hpp"

#include <algorithm>
#include <cmath>

namespace pliant::accuracy {

namespace {

constexpr double least_error = 1e-12;  ///< a result may agree with all digits of its reference

double straight_in_logarithms(double share, double from, double to) {
  return from * std::pow(to / from, share);
}

}  // namespace

std::vector<double> envelope(std::span<const Rated> rungs) {
  std::vector<double> errors(rungs.size());
  double largest = 0;
  for (std::size_t i = rungs.size(); i-- > 0;) {
    const double error = rungs[i].error;
    if (!std::isnan(error)) largest = std::max(largest, error);
    errors[i] = std::isnan(error) ? error : largest;
  }
  return errors;
}

Cost cost_of(double error, std::span<const Rated> rungs) {
  const std::vector<double> all = envelope(rungs);
  std::vector<Rated> answers;
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    if (!std::isnan(all[i])) answers.push_back({rungs[i].particles, rungs[i].seconds, all[i]});
  }
  std::size_t first = 0;
  while (first < answers.size() && answers[first].error > error) ++first;
  if (first == answers.size()) return {};
  const Rated& good = answers[first];
  const Certainty confirmed = first == 0 ? Certainty::at_most : Certainty::interpolated;
  const Certainty certainty = first + 1 == answers.size() ? Certainty::unconfirmed : confirmed;
  if (first == 0) return {certainty, good.particles, good.seconds};
  const Rated& poor = answers[first - 1];
  const double share =
      std::log(error / poor.error) / std::log(std::max(good.error, least_error) / poor.error);
  return {certainty, straight_in_logarithms(share, poor.particles, good.particles),
          straight_in_logarithms(share, poor.seconds, good.seconds)};
}

}  // namespace pliant::accuracy
