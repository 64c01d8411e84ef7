#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Designs: sets of parameter values.
namespace pliant::batch {

/// The parameters of a run: keys of the case, with values as TOML.
using Assignment = std::vector<std::pair<std::string, std::string>>;

/// A parameter and a list of its values, as TOML.
struct ValueList {
  std::string key;
  std::vector<std::string> values;
};

/// A parameter with any value between two ends.
struct Interval {
  std::string key;
  double from = 0, to = 1;
  bool logarithmic = false;

  /// The value at a position from 0 to 1.
  double at(double position) const;
};

/// The shortest TOML number that reads back to the same value; equal for 0.1 and 0.10.
std::string number_text(double value);

/// `count` values from one end to the other, including both.
ValueList range_of(const Interval& interval, int count);

/// All combinations; the last parameter changes fastest.
std::vector<Assignment> product_of(const std::vector<ValueList>& lists);
/// The first values of all parameters, then the second ones, and so on; all lists have the same
/// length.
std::vector<Assignment> zip_of(const std::vector<ValueList>& lists);
/// Divides each interval into `samples` equal parts, each of which contains one sample.
std::vector<Assignment> latin_hypercube(const std::vector<Interval>& intervals, int samples,
                                        std::uint64_t seed);
/// The first points of a Sobol sequence; a larger number keeps the earlier points.
std::vector<Assignment> sobol(const std::vector<Interval>& intervals, int samples,
                              std::uint64_t seed);

/// A name that depends only on the assignment, not on the order of its parameters.
std::string name_of(const Assignment& assignment);

}  // namespace pliant::batch
