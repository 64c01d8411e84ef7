#include "engine/remeshed/setup/regions.hpp"

#include <cstddef>

#include "engine/remeshed/state/resources.hpp"

namespace pliant::remeshed {

namespace {

using Region = std::span<std::byte>;

/// Collects the memory of one resource on one block of a body.
template <class T, int D>
class RegionSearch {
 public:
  RegionSearch(Body<T, D>& body, scheduler::FieldId resource, int block, std::vector<Region>& found)
      : body_(body),
        wanted_(resource_numbers[resource]),
        resource_(resource),
        block_(block),
        found_(found) {}

  void on_present_lattice() {
    for (int copy = 0; copy < std::ssize(body_.stage); ++copy) {
      for (const Declaration& f : state_fields)
        add_slots(f.field, copy, body_.stage[copy][f.field]);
    }
    body_.for_each_array(
        [this](Field field, int copy, auto components) { add_slots(field, copy, components); });
    Population<T, D>& population = body_.population;
    if (wanted_.group == Group::kinds) add_kinds(population);
    if (wanted_.group == Group::image_sources) add(population.images[block_]);
    // In the second graph of a remeshing, the lists of ghosts already belong to the new lattice.
    if (block_ < std::ssize(population.ghosts)) add_ghosts(population);
    add_neighbours();
  }

  void on_new_lattice() {
    Population<T, D>& population = body_.spare;
    switch (wanted_.group) {
      case Group::new_state:
        for (const Declaration& f : state_fields) add_new(body_.stage[1][f.field]);
        break;
      case Group::marks:
        for (int a = 0; a < 2; ++a) add_new(std::span(&body_.stage[1][Field::drift][a], 1));
        break;
      case Group::new_kinds:
        add_new(std::span(&population.kind, 1));
        break;
      case Group::filtered:
        add_new(body_.stage[2][Field::volume]);
        [[fallthrough]];
      case Group::extended:
        add_new(body_.stage[2][Field::material]);
        if (wanted_.group == Group::extended) break;
        [[fallthrough]];
      case Group::closest:
        add_new(body_.stage[2][Field::velocity]);
        break;
      case Group::used:
      case Group::record_numbers:
        add(body_.record_of_slot.get(), population.layout.slots());
        break;
      case Group::surface_packs:
        add_packs(population.ghosts[block_]);
        break;
      case Group::new_fits:
        add_lists(population.ghosts[block_]);
        break;
      default:
        break;
    }
  }

 private:
  bool is_wanted(Field field, int copy = 0, Part part = Part::particles) const {
    return resource_numbers(stored({field_list[field].group, copy, part})) == resource_;
  }

  template <class V>
  void add(V* values, std::size_t count) {
    if (count > 0) found_.push_back(std::as_writable_bytes(std::span(values, count)));
  }
  template <class V>
  void add(std::vector<V>& values) {
    add(values.data(), values.size());
  }

  std::span<const kernels::Segment<D>> segments(const Layout<D>& layout) const {
    const Block<D>& block = layout.blocks()[block_];
    return {layout.segments_of(block), static_cast<std::size_t>(block.segment_count)};
  }

  static Part part_of(Kind kind) {
    if (kind == Kind::image) return Part::images;
    return kind == Kind::free_ghost || kind == Kind::wall_ghost ? Part::ghosts : Part::particles;
  }

  /// Calls f(first, count) for ranges of slots with `part_of_slot(slot, cell)` == `part`.
  template <class Which, class F>
  void for_each_stretch(const Layout<D>& layout, Part part, const Which& part_of_slot,
                        F&& f) const {
    std::int64_t first = -1, next = -1;
    layout.for_each_slot(layout.blocks()[block_], [&](std::int64_t slot, const Cell<D>& cell) {
      if (part_of_slot(slot, cell) != part) return;
      if (slot != next && first >= 0) f(first, next - first);
      if (slot != next) first = slot;
      next = slot + 1;
    });
    if (first >= 0) f(first, next - first);
  }

  template <class Components>
  void add_slots(Field field, int copy, Components&& components) {
    const Layout<D>& layout = body_.population.layout;
    const bool has_parts = group_list[field_list[field].group].has_parts;
    if (!is_wanted(field, copy, has_parts ? wanted_.part : Part::particles)) return;
    const auto part = [&](std::int64_t slot, const Cell<D>&) {
      return has_parts ? part_of(body_.population.kind[slot]) : Part::particles;
    };
    for (auto& component : components) {
      for_each_stretch(layout, wanted_.part, part, [&](std::int64_t first, std::int64_t count) {
        add(component.get() + first, count);
      });
    }
  }

  template <class V>
  void add_new(std::span<Buffer<V>> components) {
    const bool has_parts = group_list[wanted_.group].has_parts;
    const auto part = [&](std::int64_t, const Cell<D>& cell) {
      return has_parts && !body_.lattice.is_wrapped(cell) ? Part::images : Part::particles;
    };
    for (Buffer<V>& component : components) {
      for_each_stretch(
          body_.spare.layout, wanted_.part, part,
          [&](std::int64_t first, std::int64_t count) { add(component.get() + first, count); });
    }
  }
  template <class V>
  void add_new(std::vector<Buffer<V>>& components) {
    add_new(std::span(components));
  }

  void add_kinds(Population<T, D>& population) {
    constexpr int pack = Layout<D>::pack;
    for (const kernels::Segment<D>& segment : segments(population.layout)) {
      add(population.kind.get() + segment.first, segment.count);
      add(population.pack_state.get() + segment.first / pack, segment.count / pack);
    }
  }

  void add_lists(BlockGhosts<T, D>& ghosts) {
    BlockGhosts<T, D>::for_each_list([&](Field, auto list) { add(ghosts.*list); });
  }

  // Excludes their padding, whose contents are arbitrary.
  void add_packs(BlockGhosts<T, D>& ghosts) {
    constexpr std::size_t size = offsetof(kernels::SurfacePack, lanes) + sizeof(std::uint16_t);
    for (kernels::SurfacePack& pack : ghosts.packs) add(reinterpret_cast<std::byte*>(&pack), size);
  }

  void add_ghosts(Population<T, D>& population) {
    BlockGhosts<T, D>& ghosts = population.ghosts[block_];
    BlockGhosts<T, D>::for_each_list([&](Field field, auto list) {
      if (is_wanted(field)) add(ghosts.*list);
    });
    ContactPoints<T, D>::for_each_list([&](Field field, auto list) {
      if (is_wanted(field)) add(ghosts.contact_points.*list);
    });
    if (is_wanted(Field::surface_pack)) add_packs(ghosts);
    const std::size_t first = ghosts.first_record, count = ghosts.record_count;
    if (is_wanted(Field::record_slot)) add(population.slot_of_record.data() + first, count);
    if (is_wanted(Field::surface_distance)) add(population.surface_distance.data() + first, count);
    constexpr int width = kernels::record_width<D>;
    if (is_wanted(Field::record)) add(body_.records.get() + first * width, count * width);
  }

  void add_neighbours() {
    if (!is_wanted(Field::neighbours) || !body_.neighbours.are_listed) return;
    constexpr int pack = Layout<D>::pack;
    BlockNeighbours<D>& own = body_.neighbours.blocks[block_];
    for (const kernels::Segment<D>& segment : segments(body_.population.layout)) {
      add(body_.neighbours.start.data() + segment.first / pack, segment.count / pack);
      add(body_.neighbours.length.data() + segment.first / pack, segment.count / pack);
    }
    add(own.slot);
    for (auto& component : own.offset) add(component);
  }

  Body<T, D>& body_;
  Resource<Group> wanted_;
  scheduler::FieldId resource_;
  int block_;
  std::vector<Region>& found_;
};

}  // namespace

template <class T, int D>
std::vector<Region> regions(State<T, D>& state, scheduler::FieldId resource, int block) {
  const Group group = resource_numbers[resource].group;
  const bool is_new = group >= Group::new_state && group != Group::particle_counts;
  std::vector<Region> found;
  for (Body<T, D>& body : state.bodies) {
    const int blocks =
        static_cast<int>((is_new ? body.spare : body.population).layout.blocks().size());
    if (block < blocks) {
      RegionSearch<T, D> search(body, resource, block, found);
      is_new ? search.on_new_lattice() : search.on_present_lattice();
      break;
    }
    block -= blocks;
  }
  return found;
}

template std::vector<Region> regions<double, 2>(State<double, 2>&, scheduler::FieldId, int);
template std::vector<Region> regions<double, 3>(State<double, 3>&, scheduler::FieldId, int);
template std::vector<Region> regions<float, 2>(State<float, 2>&, scheduler::FieldId, int);
template std::vector<Region> regions<float, 3>(State<float, 3>&, scheduler::FieldId, int);

}  // namespace pliant::remeshed
