#include "engine/remeshed/ghost_fits.hpp"

// Which particles the fits read, and where their records lie: side by side, block after block.
namespace pliant::remeshed {

template <class T, int D>
void list_surface_particles(Population<T, D>& population, int block, const std::int32_t* used) {
  constexpr int pack = Layout<D>::pack;
  BlockGhosts<T, D>& ghosts = population.ghosts[block];
  ghosts.packs.clear();
  ghosts.record_count = 0;
  const Block<D>& range = population.layout.blocks()[block];
  for (int s = 0; s < range.segment_count; ++s) {
    const kernels::Segment<D>& segment = population.layout.segments()[range.first_segment + s];
    for (std::int64_t p = segment.first; p < segment.first + segment.count; p += pack) {
      unsigned lanes = 0;
      int count = 0;
      for (int i = 0; i < pack; ++i) {
        lanes |= (used[p + i] != 0 ? 1U : 0U) << i;
        count += used[p + i] != 0;
      }
      if (lanes == 0) continue;
      ghosts.packs.push_back({p, s, ghosts.record_count, static_cast<std::uint16_t>(lanes)});
      ghosts.record_count += count;
    }
  }
}

template <class T, int D>
void number_records(Population<T, D>& population, std::int32_t* record_of_slot) {
  std::int32_t next = 0;
  for (BlockGhosts<T, D>& ghosts : population.ghosts) {
    ghosts.first_record = next;
    for (kernels::SurfacePack& pack : ghosts.packs) {
      pack.record += ghosts.first_record;
      std::int32_t record = pack.record;
      for (int i = 0; i < Layout<D>::pack; ++i) {
        if (pack.lanes >> i & 1) record_of_slot[pack.first + i] = record++;
      }
    }
    next += ghosts.record_count;
  }
  population.record_count = next;
}

template <class T, int D>
void resolve_records(Population<T, D>& population, int block, const std::int32_t* record_of_slot) {
  BlockGhosts<T, D>& ghosts = population.ghosts[block];
  for (std::size_t k = 0; k < ghosts.neighbour.size(); ++k) {
    ghosts.record[k] = record_of_slot[ghosts.neighbour[k]];
  }
}

template void list_surface_particles<double, 2>(Population<double, 2>&, int, const std::int32_t*);
template void number_records<double, 2>(Population<double, 2>&, std::int32_t*);
template void resolve_records<double, 2>(Population<double, 2>&, int, const std::int32_t*);
template void list_surface_particles<double, 3>(Population<double, 3>&, int, const std::int32_t*);
template void number_records<double, 3>(Population<double, 3>&, std::int32_t*);
template void resolve_records<double, 3>(Population<double, 3>&, int, const std::int32_t*);

}  // namespace pliant::remeshed
