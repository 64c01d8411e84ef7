#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "engine/point_based/blades/blade_resistance.hpp"
#include "engine/point_based/cutting/cut_bonds.hpp"
#include "engine/undeformed/contact/carried_points.hpp"

// Contact of the two faces of a cut, (PB.20).
//
//       above   o   o   o      A point of a cut stands for a point on each of its faces. A linear
//               - - - - -      fit to the nodes on the same side gives the present place x of
//               - - - - -      each and the tangents of the face. Where the upper point lies
//       below   o   o   o      behind the lower face, both faces are pushed apart.
//
// When faces have slid, the upper point is paired with the point of the lower face that is now
// below it. Equal and opposite impulses then act along one line. Momentum is conserved exactly, and
// angular momentum but for the product of slip and corrected overlap.
namespace pliant::point_based {

/// Contact between the faces of all cuts of one body.
template <class T, int D>
class FaceContact {
 public:
  /// `friction` is the coefficient of Coulomb's law.
  FaceContact(const Body<T, D>& body, double friction);

  /// Adds the pieces between the last two stations of a cut.
  void add(const CutSurface<D>& cut, std::int32_t number);
  /// Activates contact of faces that no bond crosses any more, with the front of their cut far
  /// ahead; not along the rims of cuts that end inside the body.
  void follow(const CutBonds<D>& bonds);
  /// Updates the nodes of each side after bonds of the nodes `changed` have changed.
  void find_nodes(const Body<T, D>& body, const TissueMap<D>& tissue,
                  std::span<const std::int32_t> changed);
  void find_nodes(const Body<T, D>& body, const TissueMap<D>& tissue);
  /// Pushes overlapping faces apart in a step of `length` [s]; for `drift` [s] of it nodes move at
  /// their present velocities.
  void apply(Body<T, D>& body, const TissueMap<D>& tissue, double length, double drift);

 private:
  static constexpr int most = D == 2 ? 8 : 20;  // nodes of a side, at most
  struct Side {
    int count = 0;  ///< 0 where there is no node
    std::int32_t seed = -1;
    std::array<undeformed::Share, most> share;
    std::array<std::array<double, most>, D - 1> slope;  ///< of the weights along the tangents

    std::span<const undeformed::Share> shares() const { return std::span(share).first(count); }
  };
  struct Pair {
    MaterialPoint<D> place;
    Point<D> normal;                      ///< from below to above, undeformed
    std::array<Point<D>, D - 1> tangent;  ///< unit vectors
    Side below, above;
  };
  struct Waiting {
    MaterialPoint<D> place;
    Point<D> normal;
    std::int32_t cut;
    int tries;
  };
  /// The present faces of a pair.
  struct Faces {
    Side below;       ///< of the point below the upper one
    Point<D> normal;  ///< unit vector
    double gap;       ///< [m], negative where they overlap
  };

  /// A pair whose faces overlap in this step.
  struct ContactPair {
    std::size_t pair = 0;
    double impulse = 0;  ///< sum over the sweeps, along the normals [N s]
    double moved = 0;    ///< the same for the shifts [kg m]
    Point<D> drag = {};  ///< impulse of friction, along the faces [N s]
  };

  /// The lower face at an upper point that lies behind it.
  struct Opposite {
    Point<D> normal;                 ///< unit vector
    double gap;                      ///< [m]
    std::array<double, D - 1> slid;  ///< sliding of the upper point along the tangents [m]
  };

  /// Whether no other pair of the same cut and of a similar direction is in the cell around a
  /// point. Blades move by a small part of H at a time, and nodes cannot resolve so many points.
  bool occupies_cell(const Waiting& waiting);
  std::optional<Opposite> opposite(const Body<T, D>& body, const Point<D>& upper, const Side& below,
                                   bool have_met) const;
  Side side_of(const Body<T, D>& body, const TissueMap<D>& tissue, const Pair& pair,
               const MaterialPoint<D>& place, double sign) const;
  static void fit(const Body<T, D>& body, const Pair& pair, const MaterialPoint<D>& place,
                  double size, Side& side);
  std::optional<Faces> faces_of(const Body<T, D>& body, const TissueMap<D>& tissue,
                                const Pair& pair, bool have_met) const;
  /// Pushes the faces of a pair apart; a sweep also corrects excess impulses of earlier ones, as in
  /// (TL.16). Returns the distance by which they are pushed [m].
  double push(Body<T, D>& body, const Side& above, const Faces& faces, double length, double drift,
              ContactPair& meeting);

  double size_;  ///< H [m]
  double friction_;
  undeformed::HeldDirections<D> held_;
  std::vector<Waiting> waiting_;
  std::vector<Pair> pairs_;
  /// Normals of the pairs in a cell, by the number of the cut and the place of the cell.
  std::map<std::array<std::int64_t, D + 1>, std::vector<Point<D>>> cells_;
  std::size_t found_ = 0;              ///< pairs that have found their nodes
  std::vector<bool> has_changed_;      ///< [slot] reused memory
  std::vector<ContactPair> meetings_;  ///< reused memory
};

extern template class FaceContact<double, 2>;
extern template class FaceContact<double, 3>;
extern template class FaceContact<float, 2>;
extern template class FaceContact<float, 3>;

}  // namespace pliant::point_based
