#pragma once

#include "engine/remeshed/state/body.hpp"

/// Images: slots beyond a period, copies of the particles one period away.
namespace pliant::remeshed {

/// Lists the images among the slots of a block, with their sources.
template <class T, int D>
void list_images(const Lattice<D>& lattice, Population<T, D>& population, int block);

/// Drift of a block's images in a stage. The drift is periodic, so positions need no separate copy.
template <class T, int D>
void copy_image_drift(Body<T, D>& body, int block, int stage);

/// Velocity and stress of a block's images in a stage, and their volume if the gradient reads it.
template <class T, int D>
void copy_images(Body<T, D>& body, int block, int stage, bool with_volume);

}  // namespace pliant::remeshed
