#pragma once

#include <array>
#include <cstdint>

#include "engine/remeshed/level_set/first_order.hpp"
#include "engine/remeshed/level_set/projections.hpp"
#include "engine/remeshed/level_set/wall_extension.hpp"
#include "engine/remeshed/parameters.hpp"
#include "engine/storage/buffer.hpp"

/// The level set of a body on a new lattice: phi < 0 inside, (RP.40).
///
///     near     abs(phi) <= 1.8 h: the remeshed phi is kept or, when reinitialisation is due,
///              replaced by the distance to the closest point of the zero set (RP.41), but not
///              near edges of the body (RP.82)
///     layers   further out, rebuilt at every remeshing: each layer takes the closest point of a
///              neighbour nearer to the surface and polishes it (RP.41)
///     beyond   only the sign, times `far`
///
/// With the option of the paper (RP.74), the layers too keep the remeshed phi, and reinitialisation
/// advances phi towards a distance; closest points are only for ghosts.
///
/// All this is done for phi extended through walls, see wall_extension.hpp.
namespace pliant::remeshed {

/// The passes that rebuild the level set of one body.
template <class T, int D>
class LevelSet {
 public:
  static constexpr double near_band = 1.8;   ///< [h]
  static constexpr double trusted = 2.5;     ///< [h] more distant closest points do not correct phi
  static constexpr int layers = 6;           ///< the near nodes are layer 1
  static constexpr int observed_layers = 4;  ///< what cubic interpolation at the surface reaches
  static constexpr double far = 6.5;         ///< [h]

  explicit LevelSet(Reinitialisation reinitialisation = Reinitialisation::closest_point)
      : is_first_order_(reinitialisation == Reinitialisation::first_order) {}
  bool is_first_order() const { return is_first_order_; }

  /// Layers beyond the `count`-th find no closest points from now on.
  void use_layers(int count) { last_layer_ = count; }
  void prepare(const Lattice<D>& lattice, const Layout<D>& layout, T* phi);
  /// Sets the memory for phi extended through walls and for closest points. It must stay valid from
  /// the first pass to the last query of a closest point.
  void use(T* extended, const std::array<T*, D>& foot) {
    extended_ = extended;
    foot_ = foot;
  }

  /// The passes over one block, in this order; each reads the previous pass in neighbouring blocks.
  /// `valid` is 0 at nodes that remeshing left empty.
  /// `initial_surface` is the free surface at t = 0.
  void extend_through_walls(const Block<D>& block, const Boundaries<D>& boundaries,
                            const Shape& initial_surface, const T* valid) {
    const WallExtension<T, D> extension(*lattice_, *layout_, initial_surface, phi_, valid,
                                        far * lattice_->spacing);
    extension.extend(block, boundaries, extended_);
  }
  void advance(const Block<D>& block, int pass);  ///< (RP.74), 0..first_order_passes - 1
  void find_closest_points(const Block<D>& block, const kernels::RemeshedTable<T, D>& kernels);
  void take_distances(const Block<D>& block);  ///< reinitialises (RP.82)
  void add_layer(const Block<D>& block, int layer,
                 const kernels::RemeshedTable<T, D>& kernels);  ///< 2..layers
  void finish(const Block<D>& block);

  /// Distance of a finished node from the surface, negative inside [m]. phi is a distance only
  /// after a reinitialisation; this one follows from the closest point.
  T surface_distance(std::int64_t slot) const { return extended_[slot]; }
  /// phi at any place, linear between nodes [m]; `far` h if one of them has no slot.
  double phi_at(const Point<D>& x) const;

  /// Closest point of the surface minus the node [m]; false if none was found.
  bool closest_point(std::int64_t slot, Point<D>& offset) const;
  /// Unit vector away from the surface at a node outside, or on it, whose closest point is at
  /// `offset` from it [m]; null where the surface has no direction.
  Point<D> outward(const Cell<D>& cell, const Point<D>& offset) const;

 private:
  /// Values of layer_[0] for near nodes with a closest point: whether (RP.41) found it.
  enum : std::uint8_t { found = 1, guessed = 2 };

  /// Nodes that get a closest point in a layer.
  struct Border {
    Projections<T, D> polished, again;
    std::vector<Point<D>> foot;       ///< [node] in cells
    std::vector<std::size_t> failed;  ///< nodes of `again`

    void clear(const Cell<D>& nearby) {
      polished.clear(nearby);
      again.clear(nearby);
      foot.clear();
      failed.clear();
    }
  };
  bool passes_surface(const Projections<T, D>& near, std::size_t i, Point<D>& nearer) const;
  void place_near(const Projections<T, D>& near, std::size_t i);
  bool lies_near_edge(const kernels::Segment<D>& segment, std::int64_t slot,
                      const Cell<D>& cell) const;
  void find_nearest(const kernels::Segment<D>& segment, std::int64_t slot, const Cell<D>& cell,
                    int layer, Border& border) const;
  void polish(Border& border, const kernels::RemeshedTable<T, D>& kernels) const;
  bool step_to_surface(const Cell<D>& cell, std::int64_t slot, Point<D>& offset) const;
  bool interpolate(const T* values, const Point<D>& x, double& value) const;
  bool gradient(const Cell<D>& cell, Point<D>& g) const;
  /// A mark for each slot of a pack.
  using PackOfMarks = std::array<std::uint8_t, Layout<D>::pack>;
  PackOfMarks borders_of_layer(const kernels::Segment<D>& segment, std::int64_t slot,
                               int layer) const;

  bool is_first_order_;
  int last_layer_ = layers;
  const Lattice<D>* lattice_ = nullptr;
  const Layout<D>* layout_ = nullptr;
  T* phi_ = nullptr;
  /// phi extended through walls, before reinitialisation; for finished nodes, their distance.
  T* extended_ = nullptr;
  std::array<T*, D> foot_ = {};  ///< closest point minus node, in cells
  std::array<Buffer<std::uint8_t>, 2>
      layer_;  ///< 0: no closest point yet; the two alternate between passes
};

extern template class LevelSet<double, 2>;
extern template class LevelSet<double, 3>;
extern template class LevelSet<float, 2>;
extern template class LevelSet<float, 3>;

}  // namespace pliant::remeshed
