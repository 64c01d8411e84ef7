#include "engine/method/phase_rows.hpp"
#include "engine/remeshed/ghosts/record_loads.hpp"
#include "engine/remeshed/loads/loaded_surface.hpp"
#include "engine/remeshed/loads/shear_patches.hpp"
#include "engine/remeshed/remeshing/remesh.hpp"
#include "engine/remeshed/state/resources.hpp"

// Part of the remeshing: the kinds of the new slots, their ghosts, and the loads on these.
namespace pliant::remeshed {

using namespace resource;
using enum Group;

// Only nodes that will be used get ghosts. Fits of all neighbouring blocks mark the surface
// particles of a block.
template <class T, int D>
void Remeshing<T, D>::add_ghosts(PhaseRows& rows) {
  rows.each("ghosts: corners", near(with_images(new_kinds) + whole(closest, 1) + whole(extended)),
            own(whole(new_corners)), [this](int b) {
              if (!is_final_) return;
              find_reentrant_corners<T, D>(body_.lattice, body_.spare, level_set_, b, corners_[b]);
            });
  rows.reduce("ghosts: corners", all(whole(new_corners)), all(whole(new_corners)), [this] {
    if (is_final_) all_corners_.collect(corners_, corner_reach * body_.lattice.spacing);
  });
  rows.each("ghosts: fits",
            near(with_images(new_kinds) + with_images(new_state) + whole(extended)) +
                own(whole(closest, 1)) + all(whole(kinds) + whole(new_corners)),
            own(whole(new_fits) + whole(used)), [this](int b) {
              if (is_final_) fit_block(b);
            });
  rows.each("ghosts: surface", near(whole(used)), own(whole(surface_packs)), [this](int b) {
    if (is_final_) list_surface_particles(body_.spare, b, body_.record_of_slot.get());
  });
  rows.reduce("ghosts: surface", all(whole(surface_packs) + whole(extended)),
              all(whole(surface_packs) + whole(record_numbers)), [this] {
                if (!is_final_) return;
                number_records(body_.spare, level_set_, body_.lattice.spacing,
                               body_.record_of_slot.get());
              });
  rows.each("ghosts: surface", near(whole(record_numbers)) + own(whole(new_fits)),
            own(whole(new_fits)), [this](int b) {
              if (is_final_) resolve_records(body_.spare, b, body_.record_of_slot.get());
            });
  if (!boundaries_.pressures.empty()) add_loads(rows);
}

template <class T, int D>
void Remeshing<T, D>::add_loads(PhaseRows& rows) {
  rows.each("ghosts: loads",
            near(with_images(new_state)) + own(whole(surface_packs) + whole(record_numbers)),
            own(whole(new_loads)), [this](int b) {
              if (!is_final_) return;
              find_record_loads(body_.lattice, body_.stage[1], initial_surface_, boundaries_, b,
                                body_.spare);
            });
  rows.each("ghosts: loads",
            near(with_images(new_state) + whole(new_loads) + whole(record_numbers)) +
                own(whole(new_fits)),
            own(whole(new_fits)), [this](int b) {
              if (!is_final_) return;
              find_ghost_loads(body_.lattice, body_.stage[1], initial_surface_, boundaries_, b,
                               body_.spare);
            });
  rows.each("loaded facets", near(with_images(new_state) + with_images(new_kinds)),
            own(whole(loaded_facets)), [this](int b) {
              if (is_final_) find_facets({body_, body_.spare, body_.stage[1]}, b);
            });
  rows.each("shear shares", near(whole(loaded_facets)), own(whole(shear_shares)), [this](int b) {
    if (is_final_) list_shear_shares(body_, body_.spare.layout, b);
  });
}

template <class T, int D>
void Remeshing<T, D>::find_facets(const LatticeView<T, D>& view, int block) {
  BlockShear<D>& shear = body_.shear[block];
  find_loaded_facets<T, D>(view, block, initial_surface_, boundaries_, body_.loaded[block],
                           shear.patches);
  find_shear_shares<T, D>(view, boundaries_, body_.loaded[block], shear);
}

template <class T, int D>
void Remeshing<T, D>::find_kinds(int block) {
  if (body_.has_surface) level_set_.finish(body_.spare.layout.blocks()[block]);
  if (kernels::carries_deformation(body_.material.model) &&
      parameters_.determinant == Determinant::from_density) {
    fields_.match_volumes(block);
  }
  particles_[block] = classify<T, D>(body_, body_.spare, body_.stage[1], block, boundaries_,
                                     fields_.valid(), outside_);
}

template <class T, int D>
void Remeshing<T, D>::fit_block(int block) {
  fit_ghosts<T, D>({body_, body_.spare, level_set_, boundaries_, all_corners_, treatment_,
                    stencil_reach_, kernels_},
                   block, body_.record_of_slot.get());
}

template void Remeshing<double, 2>::add_ghosts(PhaseRows&);
template void Remeshing<double, 2>::add_loads(PhaseRows&);
template void Remeshing<double, 2>::find_facets(const LatticeView<double, 2>&, int);
template void Remeshing<double, 2>::find_kinds(int);
template void Remeshing<double, 2>::fit_block(int);
template void Remeshing<double, 3>::add_ghosts(PhaseRows&);
template void Remeshing<double, 3>::add_loads(PhaseRows&);
template void Remeshing<double, 3>::find_facets(const LatticeView<double, 3>&, int);
template void Remeshing<double, 3>::find_kinds(int);
template void Remeshing<double, 3>::fit_block(int);
template void Remeshing<float, 2>::add_ghosts(PhaseRows&);
template void Remeshing<float, 2>::add_loads(PhaseRows&);
template void Remeshing<float, 2>::find_facets(const LatticeView<float, 2>&, int);
template void Remeshing<float, 2>::find_kinds(int);
template void Remeshing<float, 2>::fit_block(int);
template void Remeshing<float, 3>::add_ghosts(PhaseRows&);
template void Remeshing<float, 3>::add_loads(PhaseRows&);
template void Remeshing<float, 3>::find_facets(const LatticeView<float, 3>&, int);
template void Remeshing<float, 3>::find_kinds(int);
template void Remeshing<float, 3>::fit_block(int);

}  // namespace pliant::remeshed
