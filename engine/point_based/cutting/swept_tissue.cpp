#include "engine/point_based/cutting/swept_tissue.hpp"

#include <cmath>

namespace pliant::point_based {

template <int D>
std::size_t SweptTissue<D>::Hash::operator()(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t index : cell) {
    hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15;
    hash ^= hash >> 29;
  }
  return hash;
}

template <int D>
auto SweptTissue<D>::cell_of(const MaterialPoint<D>& x) const -> Cell {
  Cell cell;
  for (int a = 0; a < D; ++a) cell[a] = static_cast<std::int64_t>(std::floor(x[a] / reach_));
  return cell;
}

template <int D>
void SweptTissue<D>::mark(const MaterialPoint<D>& x) {
  marks_[cell_of(x)].push_back(x);
}

template <int D>
bool SweptTissue<D>::is_cut(const MaterialPoint<D>& x) const {
  const Cell middle = cell_of(x);
  const int cells = D == 2 ? 9 : 27;
  for (int n = 0; n < cells; ++n) {
    Cell cell = middle;
    for (int a = 0, rest = n; a < D; ++a, rest /= 3) cell[a] += rest % 3 - 1;
    const auto found = marks_.find(cell);
    if (found == marks_.end()) continue;
    for (const MaterialPoint<D>& mark : found->second) {
      double square = 0;
      for (int a = 0; a < D; ++a) square += (x[a] - mark[a]) * (x[a] - mark[a]);
      if (square < reach_ * reach_) return true;
    }
  }
  return false;
}

template class SweptTissue<2>;
template class SweptTissue<3>;

}  // namespace pliant::point_based
