#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/output/archive/archive.hpp"
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

/// The cuts of a case in one body. Blades move between steps. In a step, block by block, only the
/// nodes whose bonds they change get new bonds.
///
/// New bonds would fit another deformation than the old ones, and so change the strain energy at
/// once. A node therefore keeps its gradient as F_fit D, where D = F_fit^-1 F_old at first. D then
/// relaxes to I in steps that never raise the strain energy, (PB.14).
template <class T, int D>
class BodyCuts {
 public:
  /// Takes the cuts of body `body_number`. Keeps `choice`.
  BodyCuts(const Case& settings, int body_number, BondChoice<D> choice, const Body<T, D>& body);
  ~BodyCuts();

  /// Moves the blades to their places at `time` [s], or to where callers have put them. Returns
  /// whether any has moved.
  bool move(double time);
  /// Moves the edge of a cut to the line from `from` to `to` in the deformed body [m]; in 2D, to
  /// the point `from`. From the next `move` on this replaces the motion of the case. The edge is
  /// followed in the undeformed body by points no farther apart than the nodes. `cut` is a cut of
  /// this body.
  void put_blade(std::size_t cut, const Point<D>& from, const Point<D>& to, const Body<T, D>& body);
  /// Takes a blade out at its place in the last step. A new cut begins where it comes back.
  void lift_blade(std::size_t cut);
  /// Adds the forces of the blades to the nodes of `body` in the step that starts at `time` and has
  /// the given `length` [s], and sums them for each cut of the case.
  void load(double time, double length, Body<T, D>& body, std::span<BladeLoad<D>> sums);
  /// Pushes overlapping faces of cuts apart in a step of `length` [s]; for `drift` [s] of it nodes
  /// move at their present velocities.
  void push_faces_apart(Body<T, D>& body, double length, double drift);
  /// Whether faces of cuts are in contact when they meet.
  bool faces_meet() const { return !!faces_; }
  /// Lets blades that have not entered yet push the surface of `body` in the step that starts at
  /// `time`, see Puncture. Sums their loads for each cut of the case. Returns their power [W].
  double press_surface(Body<T, D>& body, double time, const ContactStep& step,
                       std::span<BladeLoad<D>> sums);
  /// Whether any blade has to puncture the surface first.
  bool has_punctures() const;
  /// Relaxes the kept gradients of the nodes of a block by one step, and updates its bonds for
  /// moves of the blades. Blocks are independent of each other.
  void update(int block, Body<T, D>& body);
  /// Whether a node of a block keeps a gradient other than I.
  bool keeps_gradients(int block) const { return !blocks_[block].relaxing.empty(); }
  /// Change of the strain energy by all blocks since the last call [J].
  double fold();

  /// The surface of `body` with the faces of the cuts.
  const OpenedSurface<D>& opened_surface(const Body<T, D>& body);
  /// The parts of volumes of `body` that lie beyond the cuts.
  const CutCells<D>& cut_cells(const Body<T, D>& body);

  /// The surfaces that the blades have cut so far.
  std::span<const CutSurface<D>> surfaces() const { return bonds_.cuts(); }

  void put(ArchiveWriter& archive, const std::string& name) const;
  /// Repeats the cuts of an archive; the fields of the body come from the archive too.
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
    Station velocity = {};   ///< in the last move, in the undeformed body [m/s]
    double moved = 0;        ///< time of the last move [s]
    double moves_until = 0;  ///< [s]
    bool is_done = false;
    bool is_put = false;                     ///< by a caller: it no longer follows the case
    Station target;                          ///< where a caller has put it last; empty: nowhere new
    std::optional<Puncture<T, D>> puncture;  ///< until the blade enters
    Station outside;                         ///< last place before it touched the body
  };
  struct BlockCuts {
    std::vector<std::int32_t> relaxing;  ///< slots, ascending
    double added = 0;                    ///< change of strain energy [J]
  };
  /// All moves of blades, for restarts.
  struct Moves {
    std::vector<std::int64_t> blade;
    std::vector<std::int64_t> points;  ///< points of the station; 0: the blade leaves
    std::vector<double> place;         ///< coordinates of these points, one after another [m]
    std::vector<double> time;          ///< [s]; moves with the same time are followed together
  };

  static bool is_relaxing(const Body<T, D>& body, std::int64_t slot);
  static void find_edge(const CutCase& source, double time, Station& edge);
  Blade& blade_of(std::size_t cut);
  /// Largest distance of a point of `edge` from the blade [m].
  static double way_to(const Blade& blade, const Station& edge);
  void move_by_case(std::size_t blade, double time);
  /// Follows the path from the last place of the blade, or from its start, to edge_ at `until` [s],
  /// (PB.38).
  void follow_path(std::size_t blade, double until, double time);
  /// Whether the blade, whose edge is at edge_, cuts from `time` on. After a puncture the cut
  /// begins where the blade was before it touched the surface.
  bool enters(std::size_t blade, double time);
  void move_by_caller(std::size_t blade, double time);
  void move_blade(std::size_t blade, const Station& station, double time);
  void end_cut(Blade& blade);
  /// The resistance to a blade that moves from its last station to a new one.
  void resist(Blade& blade, const Station& station, double time);
  /// Returns the slots of each block whose bonds or groups have changed.
  std::vector<std::vector<std::int32_t>> repeat(const Moves& moves, Body<T, D>& body);
  void get_punctures(const ArchiveReader& archive, const std::string& name);
  void relax(BlockCuts& cuts, Body<T, D>& body);
  /// Sets new bonds of a node.
  void change_bonds_of(std::int32_t slot, BlockCuts& cuts, Body<T, D>& body);
  /// Whether no cut has changed the bonds of a node.
  bool keeps_bonds_of(std::int32_t slot) const;
  void set_bonds_of(std::int32_t slot, Body<T, D>& body);

  BondChoice<D> choice_;
  double least_advance_, longest_advance_;  ///< distance of stations [m]
  CutBonds<D> bonds_;
  std::vector<Blade> blades_;
  Moves moves_;
  Station edge_, next_edge_;            ///< reused memory for those of a step
  std::optional<TissueMap<D>> tissue_;  ///< only where blades exert forces, or faces meet
  std::optional<FaceContact<T, D>> faces_;
  bool has_moved_ = false;  ///< whether a blade has moved in this step
  std::vector<BlockCuts> blocks_;
  double surface_spacing_;                            ///< [m]
  std::unique_ptr<OpenedSurface<D>> opened_surface_;  ///< once a frame shows it
  std::unique_ptr<CutCells<D>> cut_cells_;            ///< once a measurement needs it
};

extern template class BodyCuts<double, 2>;
extern template class BodyCuts<double, 3>;
extern template class BodyCuts<float, 2>;
extern template class BodyCuts<float, 3>;

}  // namespace pliant::point_based
