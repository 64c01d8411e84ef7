#include "engine/remeshed/ghosts/surface_records.hpp"

#include "engine/remeshed/ghosts/ghost_fits.hpp"
#include "engine/remeshed/ghosts/record_loads.hpp"

// Finds the particles that fits read, and places their records: contiguous, block after block.
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
void number_records(Population<T, D>& population, const LevelSet<T, D>& level_set, double spacing,
                    std::int32_t* record_of_slot) {
  std::int32_t next = 0;
  for (BlockGhosts<T, D>& ghosts : population.ghosts) {
    ghosts.first_record = next;
    for (kernels::SurfacePack& pack : ghosts.packs) pack.record += ghosts.first_record;
    next += ghosts.record_count;
  }
  list_slots_of_records(population);
  population.surface_distance.clear();
  population.load.assign(population.slot_of_record.size(), no_load);
  population.loaded_share.assign(population.slot_of_record.size(), T(1));
  population.face.assign(population.slot_of_record.size(), {});
  population.slope.assign(population.slot_of_record.size(), {});
  for (const std::int32_t slot : population.slot_of_record) {
    record_of_slot[slot] = static_cast<std::int32_t>(population.surface_distance.size());
    population.surface_distance.push_back(
        static_cast<T>(level_set.surface_distance(slot) / spacing));
  }
}

template <class T, int D>
void list_slots_of_records(Population<T, D>& population) {
  population.slot_of_record.clear();
  for (const BlockGhosts<T, D>& ghosts : population.ghosts) {
    for (const kernels::SurfacePack& pack : ghosts.packs) {
      for (int i = 0; i < Layout<D>::pack; ++i) {
        if ((pack.lanes >> i & 1) == 0) continue;
        population.slot_of_record.push_back(static_cast<std::int32_t>(pack.first + i));
      }
    }
  }
}

template <class T, int D>
void resolve_records(Population<T, D>& population, int block, const std::int32_t* record_of_slot) {
  BlockGhosts<T, D>& ghosts = population.ghosts[block];
  for (kernels::FitPair& pair : ghosts.pairs) {
    pair = kernels::with_record(pair, record_of_slot[kernels::record_of(pair)]);
  }
}

template <class T, int D>
void write_surface_records(Body<T, D>& body, int block, int stage, Slopes slopes,
                           const kernels::RemeshedTable<T, D>& kernels) {
  const Layout<D>& layout = body.population.layout;
  const BlockGhosts<T, D>& ghosts = body.population.ghosts[block];
  kernels::SurfaceRecords<T, D> work = {};
  work.segments = layout.segments_of(layout.blocks()[block]);
  work.packs = ghosts.packs.data();
  work.pack_count = static_cast<int>(ghosts.packs.size());
  work.spacing = static_cast<T>(body.lattice.spacing);
  work.material = body.material;
  work.mass = body.stage[0].get(Field::mass);
  work.level_set = body.stage[0].get(Field::level_set);
  work.interior = body.interior.get();
  work.state = body.template evolving<const T>(stage);
  work.stress = std::as_const(body).stress_view(stage % 2);
  work.records = body.records.get();
  work.renews_slopes = slopes.are_renewed;
  work.lead = static_cast<T>(slopes.lead);
  work.relaxes = !body.prony.empty();
  kernels.write_surface_records(work);
}

template void write_surface_records<double, 2>(Body<double, 2>&, int, int, Slopes,
                                               const kernels::RemeshedTable<double, 2>&);
template void write_surface_records<double, 3>(Body<double, 3>&, int, int, Slopes,
                                               const kernels::RemeshedTable<double, 3>&);
template void list_surface_particles<double, 2>(Population<double, 2>&, int, const std::int32_t*);
template void number_records<double, 2>(Population<double, 2>&, const LevelSet<double, 2>&, double,
                                        std::int32_t*);
template void list_slots_of_records<double, 2>(Population<double, 2>&);
template void resolve_records<double, 2>(Population<double, 2>&, int, const std::int32_t*);
template void list_surface_particles<double, 3>(Population<double, 3>&, int, const std::int32_t*);
template void number_records<double, 3>(Population<double, 3>&, const LevelSet<double, 3>&, double,
                                        std::int32_t*);
template void list_slots_of_records<double, 3>(Population<double, 3>&);
template void resolve_records<double, 3>(Population<double, 3>&, int, const std::int32_t*);
template void write_surface_records<float, 2>(Body<float, 2>&, int, int, Slopes,
                                              const kernels::RemeshedTable<float, 2>&);
template void write_surface_records<float, 3>(Body<float, 3>&, int, int, Slopes,
                                              const kernels::RemeshedTable<float, 3>&);
template void list_surface_particles<float, 2>(Population<float, 2>&, int, const std::int32_t*);
template void number_records<float, 2>(Population<float, 2>&, const LevelSet<float, 2>&, double,
                                       std::int32_t*);
template void list_slots_of_records<float, 2>(Population<float, 2>&);
template void resolve_records<float, 2>(Population<float, 2>&, int, const std::int32_t*);
template void list_surface_particles<float, 3>(Population<float, 3>&, int, const std::int32_t*);
template void number_records<float, 3>(Population<float, 3>&, const LevelSet<float, 3>&, double,
                                       std::int32_t*);
template void list_slots_of_records<float, 3>(Population<float, 3>&);
template void resolve_records<float, 3>(Population<float, 3>&, int, const std::int32_t*);

}  // namespace pliant::remeshed
