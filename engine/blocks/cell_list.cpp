#include "engine/blocks/cell_list.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace pliant {

namespace {

// Wider by this share, so that rounding never puts two points a radius apart two cubes apart.
constexpr double widening = 1e-6;

}  // namespace

template <int D>
void CellList<D>::cover(const Point<D>& lower, const Point<D>& upper, const Cell<D>& period,
                        double radius, std::size_t sites) {
  const double least = radius * (1 + widening);
  const double most = static_cast<double>(std::max<std::size_t>(sites, 1));
  period_ = period;
  lower_ = lower;
  Point<D> length, count;
  for (int a = 0; a < D; ++a) {
    if (period[a] != 0) lower_[a] = 0;
    length[a] = period[a] != 0 ? period[a] : std::max(least, upper[a] - lower[a]);
    count[a] = std::clamp(std::floor(length[a] / least), 1.0, most);
  }
  const auto all = [&] {
    return std::accumulate(count.begin(), count.end(), 1.0, std::multiplies<>());
  };
  while (all() > most) {
    double& largest = *std::max_element(count.begin(), count.end());
    largest = std::ceil(largest / 2);
  }
  for (int a = 0; a < D; ++a) {
    count_[a] = static_cast<std::int32_t>(count[a]);
    per_size_[a] = count[a] / length[a];
    reach_[a] = static_cast<std::int32_t>(std::ceil(radius * (1 + widening / 2) * per_size_[a]));
  }
}

template <int D>
std::size_t CellList<D>::cubes() const {
  std::size_t cubes = 1;
  for (int a = 0; a < D; ++a) cubes *= count_[a];
  return cubes;
}

// What is not finite goes to the first or the last cube.
template <int D>
std::int32_t CellList<D>::index(int axis, double x) const {
  const double cubes = (x - lower_[axis]) * per_size_[axis];
  if (!(cubes > 0)) return 0;
  return static_cast<std::int32_t>(std::min(cubes, count_[axis] - 1.0));
}

template <int D>
std::size_t CellList<D>::cube_of(const Point<D>& position) const {
  std::size_t at = 0;
  for (int a = D - 1; a >= 0; --a) at = at * count_[a] + index(a, position[a]);
  return at;
}

template class CellList<2>;
template class CellList<3>;

}  // namespace pliant
