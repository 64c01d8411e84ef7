#pragma once

#include <span>
#include <vector>

#include "engine/output/archive.hpp"
#include "engine/point_based/bonds.hpp"
#include "engine/point_based/cutting/cut_bonds.hpp"

namespace pliant::point_based {

/// The cuts of a case in one body. A blade moves between steps; the nodes whose bonds it changes
/// get their bonds anew, and only those.
///
/// New bonds would see another deformation than the old ones, and so change the strain energy at
/// once. A node therefore keeps the gradient that it had, F_fit D with D = F_fit^-1 F_old, and D
/// relaxes to I by steps that never raise the strain energy, (PB.14).
template <class T, int D>
class BodyCuts {
 public:
  /// Of the cuts whose body has this number. Keeps `choice`.
  BodyCuts(const Case& settings, int body_number, BondChoice<D> choice, const Body<T, D>& body);

  /// Moves the blades on to where they are at `time` [s]; returns how much strain energy that adds
  /// [J].
  double advance(double time, Body<T, D>& body);
  /// Relaxes the gradients that nodes have kept, by one step; returns the same, which is never
  /// positive.
  double relax(Body<T, D>& body);

  /// What the blades have cut so far.
  std::span<const CutSurface<D>> surfaces() const { return bonds_.cuts(); }

  void put(ArchiveWriter& archive, const std::string& name) const;
  /// Repeats the cuts of an archive; the fields of the body are those of the archive.
  void get(const ArchiveReader& archive, const std::string& name, Body<T, D>& body);

 private:
  struct Blade {
    CutCase source;
    std::int32_t cut = -1;  ///< -1 before it cuts
    std::vector<MaterialPoint<D>> station;
    bool is_done = false;
  };

  std::vector<MaterialPoint<D>> edge_at(const CutCase& source, double time) const;
  /// Returns the nodes whose bonds have changed.
  const std::vector<std::int32_t>& move(std::size_t blade, double time);
  /// Gives a node its bonds anew; returns how much strain energy that adds [J].
  double change_bonds_of(std::int32_t slot, Body<T, D>& body);
  void set_bonds_of(std::int32_t slot, Body<T, D>& body);

  BondChoice<D> choice_;
  double least_advance_;  ///< [m]
  CutBonds<D> bonds_;
  std::vector<Blade> blades_;
  std::vector<std::int64_t> moved_blade_;  ///< blades in the order of their moves, and when [s]
  std::vector<double> moved_time_;
  std::vector<std::int32_t> relaxing_, none_;  ///< slots
};

extern template class BodyCuts<double, 2>;
extern template class BodyCuts<double, 3>;
extern template class BodyCuts<float, 2>;
extern template class BodyCuts<float, 3>;

}  // namespace pliant::point_based
