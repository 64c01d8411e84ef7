#pragma once

#include <memory>
#include <optional>
#include <span>

#include "engine/blocks/box_tree.hpp"
#include "engine/point_based/cutting/cut_front.hpp"
#include "engine/point_based/cutting/enrichment.hpp"

namespace pliant::point_based {

/// How a cut changes the weights of bonds.
enum class CutRule {
  visibility,      ///< a crossed bond has no weight
  transparency,    ///< (CU.1): a crossed bond loses its weight as the front moves on
  product,         ///< (CU.3), (CU.4) for each piece, multiplied
  enrichment_grid  ///< (CU.3), (CU.5) for each cut
};

/// The bonds of all nodes by rows: node i has the bonds first[i] .. first[i + 1] - 1.
struct BondRows {
  std::vector<std::int64_t> first;
  std::vector<std::int32_t> neighbour;  ///< [bond]
};

/// The factor in [0, 1] that cuts leave of the weight of each bond. Under `visibility` and
/// `transparency` it never grows.
///
/// Each bond is tested once against each new piece of a cut, in the undeformed body. The rows may
/// hold unused bonds, so that a node can replace severed bonds by bonds to farther nodes on its own
/// side.
///
/// First all blades move; then the nodes are updated, part by part. A part is a run of nodes.
/// Several threads may update parts at once, since only moves change what parts share.
template <int D>
class CutBonds {
 public:
  using Point = MaterialPoint<D>;

  /// `sizes` are the nodes' spacings [m], such as V^(1/D). Nodes that are close in the list should
  /// be close in the body, or searches are slow. A part begins at each of `first_nodes`, in
  /// ascending order from 0.
  CutBonds(std::vector<Point> positions, std::vector<double> sizes, BondRows bonds, CutRule rule,
           InsideTest<D> is_inside, const std::vector<std::int32_t>& first_nodes = {0});

  /// A new cut; returns its number.
  std::int32_t add_cut();
  /// Starts a new set of moves; all parts must have followed the earlier ones.
  void begin_moves();
  /// Moves the blade of a cut to `station` (see CutSurface). Throws std::invalid_argument for a cut
  /// that the enrichment grid cannot represent.
  void move(std::int32_t cut, const std::vector<Point>& station);
  /// Updates a part after moves. Returns, in ascending order, its nodes with bonds whose factors
  /// have changed.
  const std::vector<std::int32_t>& update(std::size_t part);
  /// Makes one move and updates all parts.
  const std::vector<std::int32_t>& advance(std::int32_t cut, const std::vector<Point>& station);

  /// The result of the last update of a part.
  const std::vector<std::int32_t>& changed(std::size_t part) const { return parts_[part].changed; }

  std::span<const double> factors() const { return factors_; }  ///< [bond]
  const BondRows& bonds() const { return bonds_; }
  std::span<const CutSurface<D>> cuts() const { return cuts_; }
  CutRule rule() const { return rule_; }
  /// Distance [m] from a place to the front of a cut, at most `most`. Only `transparency` has
  /// fronts.
  double front_distance(std::int32_t cut, const Point& place, double most) const {
    return rule_ == CutRule::transparency ? fronts_[cut].distance(place, most) : most;
  }
  bool is_inside(const Point& place) const { return is_inside_(place); }

 private:
  struct Crossing {
    std::int64_t bond;
    std::int32_t node, cut;
    Point place;
    double size;  ///< H of (CU.1) [m]
    bool is_new = true;
  };
  struct Part {
    std::int32_t first, last;           ///< nodes
    BoxTree<D> boxes;                   ///< [node of the part] boxes around its bonds
    std::vector<Crossing> open;         ///< crossings of bonds that still have weight
    std::vector<std::int32_t> changed;  ///< nodes
  };

  template <class F>
  void for_each_near(const Part& part, std::int32_t cut, std::size_t first_piece, F&& f) const;
  template <class F>
  void for_each_crossed(const Part& part, F&& f);
  void set(Part& part, std::int32_t node, std::int64_t bond, double factor);
  void cut_visible(Part& part);
  void cut_transparent(Part& part);
  void cut_product(Part& part);
  void cut_grid(Part& part);

  std::vector<Point> positions_;
  std::vector<double> sizes_;
  BondRows bonds_;
  CutRule rule_;
  InsideTest<D> is_inside_;
  double least_size_;
  std::vector<double> factors_;
  std::vector<Part> parts_;
  std::vector<CutSurface<D>> cuts_;
  std::vector<std::size_t> first_new_;  ///< [cut] first piece that moves have added
  std::vector<CutFront<D>> fronts_;     ///< [cut] only for transparency
  std::vector<std::optional<EnrichmentGrid<D>>> grids_;  ///< [cut] only for the enrichment grid
  std::vector<std::int32_t> changed_;
};

extern template class CutBonds<2>;
extern template class CutBonds<3>;

}  // namespace pliant::point_based
