#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "engine/point_based/cutting/cut_surface.hpp"

namespace pliant::point_based {

/// The tissue that blades have swept, as marks in the cells of a grid. The cost of a query does not
/// depend on how much has been cut.
template <int D>
class SweptTissue {
 public:
  /// Tissue within `reach` [m] of a mark counts as cut.
  explicit SweptTissue(double reach) : reach_(reach) {}

  void mark(const MaterialPoint<D>& x);
  bool is_cut(const MaterialPoint<D>& x) const;

 private:
  using Cell = std::array<std::int64_t, D>;
  struct Hash {
    std::size_t operator()(const Cell& cell) const;
  };
  Cell cell_of(const MaterialPoint<D>& x) const;

  double reach_;
  std::unordered_map<Cell, std::vector<MaterialPoint<D>>, Hash> marks_;
};

extern template class SweptTissue<2>;
extern template class SweptTissue<3>;

}  // namespace pliant::point_based
