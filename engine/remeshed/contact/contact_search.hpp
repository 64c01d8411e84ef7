#pragma once

#include <vector>

#include "engine/remeshed/contact/facing_surfaces.hpp"
#include "engine/remeshed/contact/surface_sampler.hpp"
#include "engine/remeshed/state/state.hpp"
#include "scheduler/phase.hpp"

namespace pliant::remeshed {

template <class T, int D>
class OpposingFit;

/// How the traction at a contact point acts, (RP.57).
template <int D>
struct ContactDirection {
  Point<D> normal;  ///< unit vector from the own body to the other one
  double cover;     ///< share of the surface that the other body covers
  Point<D> parted;  ///< of tied bodies: how far the other one has moved away since t = 0 [m]
};

/// Finds where bodies touch, (RP.58), at the start of each step: the ghosts whose foot points lie
/// on another body, and the fit of that body there. The phases of SurfaceSampler come first.
template <class T, int D>
class ContactSearch {
 public:
  ContactSearch(State<T, D>& state, const std::vector<ContactCase>& contacts);

  /// Makes room for the present blocks, before the phases run.
  void prepare() {
    sampler_.prepare();
    directions_.resize(state_.blocks.size());
  }
  void add_phases(std::vector<scheduler::Phase>& phases);
  /// [contact point] of a block; normal and cover have no meaning for ties.
  const std::vector<ContactDirection<D>>& directions(int block) const { return directions_[block]; }

 private:
  struct GhostPlace {
    Point<D> position, foot;  ///< [m]
    double distance;          ///< from the surface of its body [h]
  };

  struct Found {
    int contact;
    double gap;      ///< [m]; infinite if the contact does not affect the ghost
    Point<D> place;  ///< on the face in contact [m]
    ContactDirection<D> direction;
  };

  const std::vector<SurfaceSamples<D>>& surfaces() const { return sampler_.surfaces(); }
  int other_body(int contact, int body) const {
    const std::array<int, 2>& pair = contacts_[contact].bodies;
    return pair[0] == body ? pair[1] : pair[0];
  }
  void find_contact_points(int block);
  bool may_be_in_contact(int owner, const BlockGhosts<T, D>& ghosts, std::int32_t ghost) const;
  Found look(int contact, int owner, const GhostPlace& ghost, OpposingFit<T, D>& opposing) const;
  bool find_faces(int owner, int other, Point<D>& x, FacingSurfaces<D>& faces) const;
  void add_contact_point(int block, std::int32_t ghost, OpposingFit<T, D>& opposing);
  /// A vector field of the particles of a ghost's fit at its foot point; value(slot, axis).
  template <class F>
  Point<D> at_foot(const Body<T, D>& body, const BlockGhosts<T, D>& ghosts, std::int32_t ghost,
                   F&& value) const;

  State<T, D>& state_;
  const std::vector<ContactCase>& contacts_;
  std::vector<std::vector<int>> contacts_of_;  ///< [body] contacts of the body
  SurfaceSampler<T, D> sampler_;
  std::vector<std::vector<ContactDirection<D>>> directions_;  ///< [block][contact point]
};

extern template class ContactSearch<double, 2>;
extern template class ContactSearch<double, 3>;
extern template class ContactSearch<float, 2>;
extern template class ContactSearch<float, 3>;

}  // namespace pliant::remeshed
