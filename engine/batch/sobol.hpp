#pragma once

#include <cstdint>
#include <vector>

namespace pliant::batch {

/// A Sobol sequence in up to `most_dimensions` dimensions, with direction numbers of Joe and Kuo
/// (SIAM J. Sci. Comput. 30, 2008, new-joe-kuo-6). A random digital shift preserves its uniformity
/// and makes it depend on a seed.
class SobolSequence {
 public:
  static constexpr int most_dimensions = 20;

  /// Throws std::invalid_argument for less than 1 or too many dimensions.
  SobolSequence(int dimensions, std::uint64_t seed);

  /// The next point, with coordinates in [0, 1).
  std::vector<double> next();

 private:
  struct Dimension {
    std::uint32_t shift, value;
    std::vector<std::uint32_t> directions;
  };
  std::vector<Dimension> dimensions_;
  std::uint32_t count_ = 0;
};

}  // namespace pliant::batch
