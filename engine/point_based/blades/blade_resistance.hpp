#pragma once

#include <array>
#include <vector>

#include "engine/point_based/blades/blade_load.hpp"
#include "engine/point_based/body.hpp"
#include "engine/point_based/bonds/nearest_nodes.hpp"
#include "engine/point_based/cutting/cut_front.hpp"
#include "engine/point_based/cutting/swept_tissue.hpp"

namespace pliant::point_based {

/// The tissue that blades can meet: nodes, the inside of the body, and what has been swept.
template <int D>
struct TissueMap {
  template <class T>
  TissueMap(const Body<T, D>& body, InsideTest<D> inside);

  std::vector<std::int32_t> slot;  ///< [node]
  std::vector<Point<D>> start;     ///< [node] [m]
  NearestNodes<D> nodes;
  InsideTest<D> is_inside;
  double size;  ///< H [m]
  SweptTissue<D> swept;
};

/// The force of one blade on the tissue, (PB.18): the resistance of new cut faces and friction. It
/// acts on the nodes around the edge, along the motion of the edge relative to the tissue.
///
/// After each move of the edge, its segments find their nodes and whether uncut tissue is ahead.
/// Between moves a step does not allocate.
template <class T, int D>
class BladeResistance {
 public:
  using Station = std::vector<MaterialPoint<D>>;

  explicit BladeResistance(const CutCase& cut) : cut_(cut) {}

  bool acts() const { return cut_.resists(); }
  /// The edge has moved from `before` (empty where the cut begins) to `now`.
  void follow(const Station& before, const Station& now, TissueMap<D>& tissue);
  /// Adds the forces to the nodes of `body`, and their sum to `sum`. `velocity` [m/s] is that of
  /// the points of the station in the undeformed body.
  void load(const Station& velocity, Body<T, D>& body, BladeLoad<D>& sum) const;

 private:
  static constexpr int carriers = 2 * D + 2;  // nodes that a segment acts on
  struct Segment {
    MaterialPoint<D> middle;
    Point<D> along;      ///< unit vector; 0 in 2D
    double length;       ///< [m]; 1 in 2D
    std::size_t point;   ///< point of the station before the middle
    double share;        ///< share of the way to the next point
    bool is_new = true;  ///< whether it cuts tissue that was whole
    std::array<std::int32_t, carriers> slot;
    std::array<double, carriers> weight;
  };

  static std::vector<Segment> divide(const Station& station, double longest);
  static Point<D> between(const Station& values, const Segment& segment);
  static void find_nodes(Segment& segment, const TissueMap<D>& tissue);

  CutCase cut_;
  std::vector<Segment> segments_;  ///< inside the body
};

extern template class BladeResistance<double, 2>;
extern template class BladeResistance<double, 3>;
extern template class BladeResistance<float, 2>;
extern template class BladeResistance<float, 3>;

}  // namespace pliant::point_based
