#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// How sets of parameter values are made.
namespace pliant::batch {

/// The parameters of a run: key of the case, value as TOML.
using Assignment = std::vector<std::pair<std::string, std::string>>;

/// A parameter with the values that it takes, as TOML.
struct ValueList {
  std::string key;
  std::vector<std::string> values;
};

/// A parameter that takes any value between two ends.
struct Interval {
  std::string key;
  double from = 0, to = 1;
  bool logarithmic = false;

  /// The value at a position from 0 to 1.
  double at(double position) const;
};

/// The shortest TOML number that reads back to the same value; 0.1 and 0.10 have the same.
std::string number_text(double value);

/// `count` values from one end to the other, both included.
ValueList range_of(const Interval& interval, int count);

/// Every combination, the last parameter changing fastest.
std::vector<Assignment> product_of(const std::vector<ValueList>& lists);
/// The first values of all parameters, then the second ones; all lists have one length.
std::vector<Assignment> zip_of(const std::vector<ValueList>& lists);
/// So many samples that each of as many equal parts of each interval has one.
std::vector<Assignment> latin_hypercube(const std::vector<Interval>& intervals, int samples,
                                        std::uint64_t seed);
/// The first points of a Sobol sequence; more samples keep those that there are.
std::vector<Assignment> sobol(const std::vector<Interval>& intervals, int samples,
                              std::uint64_t seed);

/// A name that depends on the assignment only, whatever the order of its parameters.
std::string name_of(const Assignment& assignment);

}  // namespace pliant::batch
