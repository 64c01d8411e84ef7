#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/point_based/blades/blade_resistance.hpp"
#include "engine/point_based/cutting/cut_bonds.hpp"
#include "engine/undeformed/contact/carried_points.hpp"

// Contact of the two faces of a cut, (PB.20).
//
//       above   o   o   o      A point of a cut is a point of either face. Where the faces are now
//               - - - - -      follows from the nodes on its side: the place x, and the tangents of
//               - - - - -      the face, by a linear fit that reaches as far as the cut. Where the
//       below   o   o   o      upper point lies behind the lower face, both faces are pushed apart.
//
// Faces that have slid meet at another point of the lower face: the one below the upper point. So
// equal and opposite impulses act along one line: momentum stays exact, and angular momentum but
// for the product of the slip and the overlap that is taken back.
namespace pliant::point_based {

/// The contact of all cuts of one body with themselves.
template <class T, int D>
class FaceContact {
 public:
  /// `friction` is the coefficient of Coulomb's law.
  FaceContact(const Body<T, D>& body, double friction);

  /// Takes the pieces between the last two stations of a cut.
  void add(const CutSurface<D>& cut, std::int32_t number);
  /// The faces come into contact where the front of their cut has gone on so far that no bond
  /// crosses it; not along the rims of cuts that end inside the body.
  void follow(const CutBonds<D>& bonds);
  /// Nodes whose bonds have changed lose and find others on their side.
  void find_nodes(const Body<T, D>& body, const TissueMap<D>& tissue,
                  std::span<const std::int32_t> changed);
  /// All points find their nodes.
  void find_nodes(const Body<T, D>& body, const TissueMap<D>& tissue);
  /// Pushes faces apart that have moved into each other in a step of `length` [s], for `drift` [s]
  /// of it at the velocities that nodes have now.
  void apply(Body<T, D>& body, const TissueMap<D>& tissue, double length, double drift);

 private:
  static constexpr int most = D == 2 ? 8 : 20;  // nodes of a side
  struct Side {
    int count = 0;  ///< 0 where there is no node
    std::int32_t seed = -1;
    std::array<undeformed::Share, most> share;
    std::array<std::array<double, most>, D - 1> slope;  ///< of the weights along the tangents

    std::span<const undeformed::Share> shares() const { return std::span(share).first(count); }
  };
  struct Pair {
    MaterialPoint<D> place;
    Point<D> normal;                      ///< from below to above, in the undeformed body
    std::array<Point<D>, D - 1> tangent;  ///< unit vectors
    Side below, above;
  };
  struct Waiting {
    MaterialPoint<D> place;
    Point<D> normal;
    std::int32_t cut;
    int tries;
  };
  /// Where the faces of a pair are at present.
  struct Faces {
    Side below;       ///< of the point that is below the upper one
    Point<D> normal;  ///< unit vector
    double gap;       ///< [m], negative where they overlap
  };

  /// A pair whose faces have met in this step.
  struct Meeting {
    std::size_t pair = 0;
    double impulse = 0;  ///< sum over the sweeps, along the normals [N s]
    double moved = 0;    ///< that of the shifts [kg m]
    Point<D> drag = {};  ///< of friction, along the faces [N s]
  };

  /// The lower face at an upper point that lies behind it.
  struct Opposite {
    Point<D> normal;                 ///< unit vector
    double gap;                      ///< [m]
    std::array<double, D - 1> slid;  ///< of the upper point along the tangents [m]
  };

  std::optional<Opposite> opposite(const Body<T, D>& body, const Point<D>& upper, const Side& below,
                                   bool have_met) const;
  Side side_of(const Body<T, D>& body, const TissueMap<D>& tissue, const Pair& pair,
               const MaterialPoint<D>& place, double sign) const;
  static void fit(const Body<T, D>& body, const Pair& pair, const MaterialPoint<D>& place,
                  double size, Side& side);
  std::optional<Faces> faces_of(const Body<T, D>& body, const TissueMap<D>& tissue,
                                const Pair& pair, bool have_met) const;
  /// Faces give back what earlier sweeps have done too much, as in (TL.16). Returns how far they
  /// are pushed [m].
  double push(Body<T, D>& body, const Side& above, const Faces& faces, double length, double drift,
              Meeting& meeting);

  double size_;  ///< H [m]
  double friction_;
  undeformed::HeldDirections<D> held_;
  std::vector<Waiting> waiting_;
  std::vector<Pair> pairs_;
  std::size_t found_ = 0;          ///< pairs that have found their nodes
  std::vector<bool> has_changed_;  ///< [slot], room
  std::vector<Meeting> meetings_;  ///< room
};

extern template class FaceContact<double, 2>;
extern template class FaceContact<double, 3>;
extern template class FaceContact<float, 2>;
extern template class FaceContact<float, 3>;

}  // namespace pliant::point_based
