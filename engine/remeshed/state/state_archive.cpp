#include "engine/remeshed/state/state_archive.hpp"

#include <fmt/format.h>

#include <numeric>
#include <type_traits>

#include "engine/method/archived_clock.hpp"
#include "engine/method/archived_points.hpp"
#include "engine/remeshed/ghosts/ghost_fits.hpp"
#include "engine/remeshed/setup/particle_kinds.hpp"

namespace pliant::remeshed {

namespace {

template <class C, class F>
void for_each_rate(C& clock, F&& f) {
  f("accumulated_strain", clock.accumulated_strain);
  f("deformation", clock.deformation);
  f("strain_rate", clock.strain_rate);
  f("damping", clock.damping);
}

template <class C, class F>
void for_each_counter(C& clock, F&& f) {
  f("remeshings", clock.remeshings);
  f("steps_since_remeshing", clock.steps_since_remeshing);
  f("steps_since_reinitialisation", clock.steps_since_reinitialisation);
}

/// Calls f(name, buffer) for every array of slots in a checkpoint: one copy of each.
template <class B, class F>
void for_each_slot_array(B& body, F&& f) {
  const auto visit = [&f](const Declaration& field, auto& components) {
    if (!field.is_saved) return;
    for (std::size_t c = 0; c < components.size(); ++c) {
      f(fmt::format("{}/{}", field.name, c), components[c]);
    }
  };
  for (const Declaration& field : state_fields) {
    visit(field, body.stage[0][field.field]);
  }
  visit(field_list[Field::stress], body.stress);
}

/// The number type of the values of a list.
template <class V>
struct Number {
  using Type = V;
};
template <>
struct Number<std::int8_t> {
  using Type = std::uint8_t;
};
template <class N, std::size_t size>
struct Number<std::array<N, size>> {
  using Type = N;
};
template <class T, int D>
struct Number<kernels::FitTerms<T, D>> {
  using Type = T;
};

template <class V>
auto numbers_of(std::vector<V>& values) {
  using N = typename Number<V>::Type;
  static_assert(sizeof(V) % sizeof(N) == 0 && std::is_trivially_copyable_v<V>);
  const std::size_t bytes = values.size() * sizeof(V);
  return std::span(reinterpret_cast<N*>(values.data()), bytes / sizeof(N));
}

std::string list_name(const std::string& group, Field field) {
  return fmt::format("{}/{}", group, field_list[field].name);
}

// A list of all blocks is one array; another array has the length of each block's part.
template <class T, int D>
void put_ghosts(ArchiveWriter& archive, const std::string& group,
                const Population<T, D>& population) {
  BlockGhosts<T, D>::for_each_list(
      [&]<class V>(Field field, std::vector<V> BlockGhosts<T, D>::*list) {
        if (!field_list[field].is_saved) return;
        const std::string name = list_name(group, field);
        std::vector<std::int64_t> lengths;
        std::vector<V> all;
        for (const BlockGhosts<T, D>& ghosts : population.ghosts) {
          const std::vector<V>& values = ghosts.*list;
          lengths.push_back(static_cast<std::int64_t>(values.size()));
          all.insert(all.end(), values.begin(), values.end());
        }
        const std::span<const typename Number<V>::Type> numbers = numbers_of(all);
        archive.put(name + "/lengths", std::span<const std::int64_t>(lengths));
        archive.put(name + "/values", numbers);
      });
  std::vector<std::int64_t> reached, packs;
  for (const BlockGhosts<T, D>& ghosts : population.ghosts) {
    reached.push_back(static_cast<std::int64_t>(ghosts.reached_count));
    packs.insert(packs.end(), {static_cast<std::int64_t>(ghosts.packs.size()), ghosts.first_record,
                               ghosts.record_count});
    for (const kernels::SurfacePack& p : ghosts.packs) {
      packs.insert(packs.end(), {p.first, p.segment, p.record, p.lanes});
    }
  }
  archive.put(group + "/reached", std::span<const std::int64_t>(reached));
  archive.put(list_name(group, Field::surface_pack), std::span<const std::int64_t>(packs));
  archive.put(list_name(group, Field::surface_distance),
              std::span<const T>(population.surface_distance));
  archive.put(
      list_name(group, Field::record_load),
      std::span<const std::uint8_t>(reinterpret_cast<const std::uint8_t*>(population.load.data()),
                                    population.load.size()));
  archive.put(list_name(group, Field::loaded_share), std::span<const T>(population.loaded_share));
  const auto put_vectors = [&](Field field, const std::vector<std::array<T, D>>& vectors) {
    std::vector<T> values;
    values.reserve(D * vectors.size());
    for (const std::array<T, D>& x : vectors) values.insert(values.end(), x.begin(), x.end());
    archive.put(list_name(group, field), std::span<const T>(values));
  };
  put_vectors(Field::record_face, population.face);
  put_vectors(Field::record_slope, population.slope);
}

template <class T, int D>
void get_ghosts(const ArchiveReader& archive, const std::string& group,
                Population<T, D>& population) {
  BlockGhosts<T, D>::for_each_list(
      [&]<class V>(Field field, std::vector<V> BlockGhosts<T, D>::*list) {
        if (!field_list[field].is_saved) return;
        const std::string name = list_name(group, field);
        const auto lengths = archive.get<std::int64_t>(name + "/lengths");
        std::vector<V> all(std::accumulate(lengths.begin(), lengths.end(), std::int64_t{0}));
        archive.read(name + "/values", numbers_of(all));
        auto first = all.begin();
        for (std::size_t b = 0; b < population.ghosts.size(); first += lengths[b++]) {
          (population.ghosts[b].*list).assign(first, first + lengths.at(b));
        }
      });
  const auto reached = archive.get<std::int64_t>(group + "/reached");
  const auto packs = archive.get<std::int64_t>(list_name(group, Field::surface_pack));
  auto pack = packs.begin();
  const auto next = [&] { return static_cast<std::int32_t>(*pack++); };
  for (std::size_t b = 0; b < population.ghosts.size(); ++b) {
    BlockGhosts<T, D>& ghosts = population.ghosts[b];
    ghosts.contact_points.clear();
    ghosts.correction.assign(ghosts.slot.size(), {});
    ghosts.end_reached(reached[b]);
    ghosts.packs.resize(*pack++);
    ghosts.first_record = next();
    ghosts.record_count = next();
    for (kernels::SurfacePack& p : ghosts.packs) {
      p.first = *pack++;
      p.segment = next();
      p.record = next();
      p.lanes = static_cast<std::uint16_t>(*pack++);
    }
  }
  population.surface_distance = archive.get<T>(list_name(group, Field::surface_distance));
  list_slots_of_records(population);
  population.load.resize(population.slot_of_record.size());
  archive.read(list_name(group, Field::record_load), numbers_of(population.load));
  population.loaded_share = archive.get<T>(list_name(group, Field::loaded_share));
  population.face.resize(population.slot_of_record.size());
  archive.read(list_name(group, Field::record_face), numbers_of(population.face));
  population.slope.resize(population.slot_of_record.size());
  archive.read(list_name(group, Field::record_slope), numbers_of(population.slope));
}

template <int D>
void put_motion_budgets(ArchiveWriter& archive, const std::vector<MotionBudget<D>>& budgets) {
  std::vector<double> values;
  for (const MotionBudget<D>& budget : budgets) {
    values.push_back(budget.mass);
    values.insert(values.end(), budget.momentum.begin(), budget.momentum.end());
    values.insert(values.end(), budget.spin.begin(), budget.spin.end());
    values.push_back(budget.is_known ? 1 : 0);
  }
  archive.put("motion_budgets", std::span<const double>(values));
}

template <int D>
void get_motion_budgets(const ArchiveReader& archive, std::vector<MotionBudget<D>>& budgets) {
  const auto values = archive.get<double>("motion_budgets");
  std::size_t next = 0;
  for (MotionBudget<D>& budget : budgets) {
    budget.mass = values.at(next++);
    for (double& component : budget.momentum) component = values.at(next++);
    for (double& component : budget.spin) component = values.at(next++);
    budget.is_known = values.at(next++) != 0;
  }
}

}  // namespace

template <class T, int D>
void put_state(ArchiveWriter& archive, const State<T, D>& state) {
  put_clock(archive, state.clock);
  for_each_counter(state.clock, [&](const char* name, std::int64_t value) {
    archive.put(std::string("clock/") + name, value);
  });
  for_each_rate(state.clock, [&](const char* name, double value) {
    archive.put(std::string("clock/") + name, value);
  });
  put_energy(archive, "energy", state.energy);
  put_boundaries<D>(archive, state.boundaries);
  put_poses<D>(archive, "walls/remeshed", state.remeshed_poses);
  put_wrenches<D>(archive, "walls/impulse", state.wall_impulse);
  put_points<D>(archive, "contacts/impulse", state.contact_impulse);
  std::vector<double> momentum_budgets;
  for (const MomentumBudget<D>& budget : state.momentum_budgets) {
    momentum_budgets.push_back(budget.mass);
    momentum_budgets.insert(momentum_budgets.end(), budget.momentum.begin(), budget.momentum.end());
  }
  archive.put("momentum_budgets", std::span<const double>(momentum_budgets));
  put_motion_budgets<D>(archive, state.motion_budgets);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const Body<T, D>& body = state.bodies[b];
    const std::string group = fmt::format("body/{}", b);
    const std::size_t slots = body.population.layout.slots();
    const std::vector<std::int32_t> cells = body.population.layout.occupancy().save();
    archive.put(group + "/occupied_cells", std::span<const std::int32_t>(cells));
    archive.put(group + "/lattice_origin", std::span<const double>(body.lattice.origin));
    archive.put(group + "/particles", body.population.particles);
    archive.put(group + "/strain", body.neighbours.strain);
    archive.put(group + "/strain_rate", body.neighbours.strain_rate);
    const auto* kinds = reinterpret_cast<const std::uint8_t*>(body.population.kind.get());
    archive.put(group + "/kind", std::span<const std::uint8_t>(kinds, slots));
    for_each_slot_array(body, [&](const std::string& name, const Buffer<T>& values) {
      archive.put(group + "/" + name, std::span<const T>(values.get(), slots));
    });
    put_ghosts<T, D>(archive, group + "/ghosts", body.population);
  }
}

template <class T, int D>
void get_state(const ArchiveReader& archive, State<T, D>& state, Remeshings<T, D>& remeshings) {
  get_clock(archive, state.clock);
  for_each_counter(state.clock, [&](const char* name, std::int64_t& value) {
    value = archive.scalar<std::int64_t>(std::string("clock/") + name);
  });
  for_each_rate(state.clock, [&](const char* name, double& value) {
    value = archive.scalar<double>(std::string("clock/") + name);
  });
  get_energy(archive, "energy", state.energy);
  get_boundaries<D>(archive, state.boundaries);
  get_poses<D>(archive, "walls/remeshed", state.remeshed_poses);
  get_wrenches<D>(archive, "walls/impulse", state.wall_impulse);
  get_points<D>(archive, "contacts/impulse", state.contact_impulse);
  const auto momentum_budgets = archive.get<double>("momentum_budgets");
  for (std::size_t b = 0; b < state.momentum_budgets.size(); ++b) {
    state.momentum_budgets[b].mass = momentum_budgets.at((D + 1) * b);
    for (int a = 0; a < D; ++a)
      state.momentum_budgets[b].momentum[a] = momentum_budgets.at((D + 1) * b + a + 1);
  }
  get_motion_budgets<D>(archive, state.motion_budgets);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    Body<T, D>& body = state.bodies[b];
    const std::string group = fmt::format("body/{}", b);
    archive.read(group + "/lattice_origin", std::span<double>(body.lattice.origin));
    remeshings[b].lay_out_again(archive.get<std::int32_t>(group + "/occupied_cells"));
    Population<T, D>& population = body.population;
    const std::size_t slots = population.layout.slots();
    body.neighbours.strain = archive.scalar<double>(group + "/strain");
    body.neighbours.strain_rate = archive.scalar<double>(group + "/strain_rate");
    population.particles = archive.scalar<std::int64_t>(group + "/particles");
    archive.read(group + "/kind",
                 std::span(reinterpret_cast<std::uint8_t*>(population.kind.get()), slots));
    for_each_slot_array(body, [&](const std::string& name, Buffer<T>& values) {
      archive.read(group + "/" + name, std::span<T>(values.get(), slots));
    });
    for (const auto& segment : population.layout.segments()) {
      find_pack_states<T, D>(population, segment);
    }
    get_ghosts<T, D>(archive, group + "/ghosts", population);
    remeshings[b].swap_in_restored();
  }
}

template void put_state<double, 2>(ArchiveWriter&, const State<double, 2>&);
template void get_state<double, 2>(const ArchiveReader&, State<double, 2>&, Remeshings<double, 2>&);
template void put_state<double, 3>(ArchiveWriter&, const State<double, 3>&);
template void get_state<double, 3>(const ArchiveReader&, State<double, 3>&, Remeshings<double, 3>&);
template void put_state<float, 2>(ArchiveWriter&, const State<float, 2>&);
template void get_state<float, 2>(const ArchiveReader&, State<float, 2>&, Remeshings<float, 2>&);
template void put_state<float, 3>(ArchiveWriter&, const State<float, 3>&);
template void get_state<float, 3>(const ArchiveReader&, State<float, 3>&, Remeshings<float, 3>&);

}  // namespace pliant::remeshed
