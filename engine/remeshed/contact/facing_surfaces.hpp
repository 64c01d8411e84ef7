#pragma once

#include <vector>

#include "engine/remeshed/contact/surface_samples.hpp"

// The faces with which two bodies meet near a point, also beside their edges.
//
//             |  body b  |
//             |__________|        x  below an edge of b: particles of its bottom and of its side
//     ____________________x___       are near
//           |    body a
//
// phi rounds edges, and so do its gradient and its closest points. Particles, though, show the face
// that they are nearest to. Those whose grad phi opposes that of the other body are of the face in
// contact, (RP.101), and those of the sides show how far it reaches, (RP.102). Where grad phi is
// smaller than on the faces, its differences straddle the bisector of an edge, and the particle
// shows nothing.
namespace pliant::remeshed {

/// Where two bodies meet near a point of the first one.
template <int D>
struct FacingSurfaces {
  Point<D> normal = {};  ///< unit vector from the first body to the second
  double gap = 0;        ///< along it, negative where they overlap [m]
  double depth = 0;      ///< of the point below the face of the first body [m]
  double cover = 0;      ///< share of that face around the point that the second body covers
};

/// Finds them from the particles of both bodies. Reuses its memory, so that later searches do not
/// allocate.
template <int D>
class FacingSearch {
 public:
  /// A body, as contact sees it.
  struct Side {
    const SurfaceSamples<D>& surface;
    const Lattice<D>& lattice;
  };

  /// False if one of them has no particles near x that face the other one.
  bool find(const Side& own, const Side& other, const Point<D>& x, FacingSurfaces<D>& found);

 private:
  struct Particle {
    double weight;
    double clarity;     ///< whether it shows a face: 0 to 1
    double level_set;   ///< [h]
    Point<D> gradient;  ///< of phi
    Point<D> normal;    ///< its direction
    Point<D> offset;    ///< from x [h]
  };
  using Particles = std::vector<Particle>;

  static void gather(const Side& side, const Point<D>& x, Particles& particles);
  static double share(const Particle& particle, const Point<D>& normal, double least);
  static bool find_face(const Particles& particles, const Point<D>& towards, double least,
                        Point<D>& normal);
  static double height(const Particles& particles, const Point<D>& normal);
  static double beyond_sides(const Particles& particles, const Point<D>& normal);

  Particles own_, other_;
};

extern template class FacingSearch<2>;
extern template class FacingSearch<3>;

}  // namespace pliant::remeshed
