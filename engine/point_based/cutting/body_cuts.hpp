#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/output/archive.hpp"
#include "engine/point_based/blades/blade_resistance.hpp"
#include "engine/point_based/blades/puncture.hpp"
#include "engine/point_based/bonds/bonds.hpp"
#include "engine/point_based/cut_faces/face_contact.hpp"
#include "engine/point_based/cutting/cut_bonds.hpp"
#include "engine/point_based/cutting/tissue_at.hpp"

namespace pliant::point_based {

template <int D>
class CutCells;
template <int D>
class OpenedSurface;

/// The cuts of a case in one body. Blades move between steps; in a step, the nodes whose bonds they
/// change get their bonds anew, and only those, block by block.
///
/// New bonds would see another deformation than the old ones, and so change the strain energy at
/// once. A node therefore keeps the gradient that it had, F_fit D with D = F_fit^-1 F_old, and D
/// relaxes to I by steps that never raise the strain energy, (PB.14).
template <class T, int D>
class BodyCuts {
 public:
  /// Of the cuts whose body has this number. Keeps `choice`.
  BodyCuts(const Case& settings, int body_number, BondChoice<D> choice, const Body<T, D>& body);
  ~BodyCuts();

  /// Moves the blades on to where they are at `time` [s], or to where callers have put them.
  /// Whether any has moved.
  bool move(double time);
  /// Puts the edge of a cut of the case from `from` to `to`, present places [m], in 2D the first of
  /// them; in the place of what the case says, from the next `move` on. The edge is followed in the
  /// undeformed body by points no farther apart than the nodes. `cut` is one of this body.
  void put_blade(std::size_t cut, const Point<D>& from, const Point<D>& to, const Body<T, D>& body);
  /// The blade leaves the body from where it was in the last step: where it comes back, a new cut
  /// begins.
  void lift_blade(std::size_t cut);
  /// Pushes the nodes of `body` with the forces of the blades in the step from `time` on, of
  /// `length` [s], and adds these up for each cut of the case.
  void load(double time, double length, Body<T, D>& body, std::span<BladeLoad<D>> sums);
  /// Pushes the faces of cuts apart where they have moved into each other in a step of `length`
  /// [s], for `drift` [s] of it at the velocities that the nodes have now.
  void meet(Body<T, D>& body, double length, double drift);
  /// Whether they can.
  bool faces_meet() const { return !!faces_; }
  /// Lets blades that have not entered push the surface of `body` in the step from `time` on, as
  /// Puncture does, and adds what they exert up for each cut of the case. Returns their power [W].
  double dent(Body<T, D>& body, double time, const ContactStep& step, std::span<BladeLoad<D>> sums);
  /// Whether any blade starts as one of these.
  bool has_punctures() const;
  /// Relaxes the gradients that nodes of a block have kept, by one step, and lets its bonds follow
  /// the blades. Blocks do not depend on each other.
  void update(int block, Body<T, D>& body);
  /// Whether a node of a block keeps a gradient other than I.
  bool keeps_gradients(int block) const { return !blocks_[block].relaxing.empty(); }
  /// By how much all blocks together have changed the strain energy since the last call [J].
  double fold();

  /// The surface of `body` with the faces of the cuts.
  const OpenedSurface<D>& opened_surface(const Body<T, D>& body);
  /// What nodes of `body` hold beyond the cuts.
  const CutCells<D>& cut_cells(const Body<T, D>& body);

  /// What the blades have cut so far.
  std::span<const CutSurface<D>> surfaces() const { return bonds_.cuts(); }

  void put(ArchiveWriter& archive, const std::string& name) const;
  /// Repeats the cuts of an archive; the fields of the body are those of the archive.
  void get(const ArchiveReader& archive, const std::string& name, Body<T, D>& body);

 private:
  using Station = std::vector<MaterialPoint<D>>;
  struct Blade {
    std::size_t number;  ///< in the case
    CutCase source;
    std::int32_t cut = -1;  ///< -1 before it cuts
    Station station;
    BladeResistance<T, D> resistance;
    double followed = 0;     ///< time of the station [s]
    Station velocity = {};   ///< of the last move, in the undeformed body [m/s]
    double moved = 0;        ///< when that was [s]
    double moves_until = 0;  ///< [s]
    bool is_done = false;
    bool is_put = false;                     ///< by callers: the case moves it no more
    Station target;                          ///< where callers have put it; empty: nowhere new
    std::optional<Puncture<T, D>> puncture;  ///< until the blade has entered
    Station outside;                         ///< where it was before it touched the body
  };
  struct BlockCuts {
    std::vector<std::int32_t> relaxing;  ///< slots, ascending
    double added = 0;                    ///< strain energy [J]
  };
  /// What blades have done, move by move, for restarts.
  struct Moves {
    std::vector<std::int64_t> blade;
    std::vector<std::int64_t> points;  ///< of the station; 0: the blade leaves
    std::vector<double> place;         ///< of these points, one after another [m]
    std::vector<double> time;          ///< [s]; moves of one time are followed together
  };

  static bool is_relaxing(const Body<T, D>& body, std::int64_t slot);
  static void find_edge(const CutCase& source, double time, Station& edge);
  Blade& blade_of(std::size_t cut);
  /// How far the point of an edge is that is farthest from where the blade is [m].
  static double way_to(const Blade& blade, const Station& edge);
  void move_by_case(std::size_t blade, double time);
  /// Follows the path from where the blade was last, or from its start, to edge_ at `until` [s],
  /// (PB.38).
  void follow_path(std::size_t blade, double until, double time);
  /// Whether the blade, whose edge is at edge_, cuts from `time` on; where the surface has given
  /// way, the cut begins where the blade was before it touched it.
  bool enters(std::size_t blade, double time);
  void move_by_caller(std::size_t blade, double time);
  void move_blade(std::size_t blade, const Station& station, double time);
  void end_cut(Blade& blade);
  /// The force of a blade that moves from the last station to a new one.
  void resist(Blade& blade, const Station& station, double time);
  /// Returns the slots of each block whose bonds or groups have changed.
  std::vector<std::vector<std::int32_t>> repeat(const Moves& moves, Body<T, D>& body);
  void get_punctures(const ArchiveReader& archive, const std::string& name);
  void relax(BlockCuts& cuts, Body<T, D>& body);
  /// Gives a node its bonds anew.
  void change_bonds_of(std::int32_t slot, BlockCuts& cuts, Body<T, D>& body);
  /// Whether no cut has changed the bonds of a node.
  bool keeps_bonds_of(std::int32_t slot) const;
  void set_bonds_of(std::int32_t slot, Body<T, D>& body);

  BondChoice<D> choice_;
  double least_advance_, longest_advance_;  ///< from station to station [m]
  CutBonds<D> bonds_;
  std::vector<Blade> blades_;
  Moves moves_;
  Station edge_, next_edge_;            ///< room for those of a step
  std::optional<TissueMap<D>> tissue_;  ///< where blades exert forces, or faces meet
  std::optional<FaceContact<T, D>> faces_;
  bool has_moved_ = false;  ///< in this step
  std::vector<BlockCuts> blocks_;
  double surface_spacing_;                            ///< [m]
  std::unique_ptr<OpenedSurface<D>> opened_surface_;  ///< once a frame has shown it
  std::unique_ptr<CutCells<D>> cut_cells_;            ///< once a measurement has asked for it
};

extern template class BodyCuts<double, 2>;
extern template class BodyCuts<double, 3>;
extern template class BodyCuts<float, 2>;
extern template class BodyCuts<float, 3>;

}  // namespace pliant::point_based
