#pragma once

#include "engine/total_lagrangian/body.hpp"

namespace pliant::total_lagrangian {

/// A place in the undeformed body: a cell, and the place in it from 0 to 1 along each axis.
template <int D>
struct PlaceInCell {
  Cell<D> cell;
  Point<D> at;

  /// Weight of a corner of the cell in linear interpolation.
  double weight(int corner) const {
    double weight = 1;
    for (int a = 0; a < D; ++a) weight *= corner >> a & 1 ? at[a] : 1 - at[a];
    return weight;
  }
};

/// The cell that contains x. Where corners have moved from their nodes, (TL.11), the one of those
/// around in which interpolation between the places of the corners gives x.
template <class T, int D>
PlaceInCell<D> place_in_cell(const Body<T, D>& body, const Point<D>& x);

}  // namespace pliant::total_lagrangian
