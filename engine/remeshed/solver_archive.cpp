#include "engine/remeshed/solver_archive.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/body/archived_points.hpp"
#include "engine/remeshed/ghost_fits.hpp"

namespace pliant {

namespace {

using remeshed::BlockGhosts;
using remeshed::Body;
using remeshed::Clock;
using remeshed::Population;

template <class F>
void for_each_counter(Clock& clock, F&& f) {
  f("step", clock.step);
  f("remeshings", clock.remeshings);
  f("steps_since_remeshing", clock.steps_since_remeshing);
  f("steps_since_reinitialisation", clock.steps_since_reinitialisation);
}

template <class F>
void for_each_clock_value(Clock& clock, F&& f) {
  f("time", clock.time);
  f("accumulated_strain", clock.accumulated_strain);
  f("wave_speed", clock.wave_speed);
}

/// Calls f(name, buffer) for every slot array of a body.
template <class T, int D, class F>
void for_each_slot_array(Body<T, D>& body, F&& f) {
  for (const FieldDeclaration& field : fields) {
    auto& components = body.stage[0][field.field];
    for (std::size_t c = 0; c < components.size(); ++c) {
      f(fmt::format("{}/{}", field.name, c), components[c]);
    }
  }
  for (std::size_t c = 0; c < body.stress.size(); ++c) {
    f(fmt::format("stress/{}", c), body.stress[c]);
  }
}

template <class V>
std::vector<V> joined(std::size_t blocks, auto&& part) {
  std::vector<V> all;
  for (std::size_t b = 0; b < blocks; ++b) {
    const auto& values = part(b);
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

/// Calls f(term) for every number of a fit.
template <class Terms, class F>
void for_each_term(Terms& terms, F&& f) {
  std::for_each(terms.start.begin(), terms.start.end(), f);
  f(terms.steepness);
  std::for_each(terms.broad.begin(), terms.broad.end(), f);
  std::for_each(terms.linear.begin(), terms.linear.end(), f);
  std::for_each(terms.surface.begin(), terms.surface.end(), f);
  std::for_each(terms.constrained.begin(), terms.constrained.end(), f);
}

template <class T, int D>
void put_ghosts(ArchiveWriter& archive, const std::string& group,
                const Population<T, D>& population) {
  const std::size_t blocks = population.ghosts.size();
  std::vector<std::int64_t> sizes, reached, begins, packs;
  std::vector<std::int32_t> walls;
  std::vector<double> normals, feet;
  std::vector<T> terms;
  for (const BlockGhosts<T, D>& g : population.ghosts) {
    sizes.insert(sizes.end(), {static_cast<std::int64_t>(g.slot.size()),
                               static_cast<std::int64_t>(g.pairs.size()),
                               static_cast<std::int64_t>(g.packs.size()), g.first_record,
                               g.record_count, static_cast<std::int64_t>(g.contact.size()),
                               static_cast<std::int64_t>(g.wall_distance.size())});
    reached.push_back(static_cast<std::int64_t>(g.reached_count));
    begins.insert(begins.end(), g.begin.begin(), g.begin.end());
    for (std::size_t i = 0; i < g.slot.size(); ++i) {
      walls.insert(walls.end(), {g.wall[i], g.pressure[i]});
      normals.insert(normals.end(), g.normal[i].begin(), g.normal[i].end());
      feet.insert(feet.end(), g.foot[i].begin(), g.foot[i].end());
      for_each_term(g.terms[i], [&](const T& term) { terms.push_back(term); });
    }
    for (const kernels::SurfacePack& p : g.packs) {
      packs.insert(packs.end(), {p.first, p.segment, p.record, p.lanes});
    }
  }
  const auto& all = population.ghosts;
  archive.put(group + "/sizes", std::span<const std::int64_t>(sizes));
  archive.put(group + "/reached", std::span<const std::int64_t>(reached));
  archive.put(group + "/begin", std::span<const std::int64_t>(begins));
  archive.put(group + "/packs", std::span<const std::int64_t>(packs));
  archive.put(group + "/wall_and_pressure", std::span<const std::int32_t>(walls));
  archive.put(group + "/normal", std::span<const double>(normals));
  archive.put(group + "/foot", std::span<const double>(feet));
  archive.put(group + "/terms", std::span<const T>(terms));
  archive.put(group + "/surface_distance", std::span<const T>(population.surface_distance));
  const auto put = [&]<class V>(const char* name, auto member) {
    const std::vector<V> values =
        joined<V>(blocks, [&](std::size_t b) -> const std::vector<V>& { return all[b].*member; });
    archive.put(group + "/" + name, std::span<const V>(values));
  };
  using G = BlockGhosts<T, D>;
  put.template operator()<std::int32_t>("slot", &G::slot);
  put.template operator()<kernels::FitPair>("pairs", &G::pairs);
  put.template operator()<std::int32_t>("contact", &G::contact);
  put.template operator()<std::uint8_t>("active", &G::active);
  put.template operator()<double>("contact_height", &G::contact_height);
  put.template operator()<double>("contact_area", &G::contact_area);
  put.template operator()<std::int64_t>("wall_begin", &G::wall_begin);
  put.template operator()<T>("wall_distance", &G::wall_distance);
  put.template operator()<T>("constrained_sum", &G::constrained_sum);
  put.template operator()<T>("surface_sum", &G::surface_sum);
}

template <class T, int D>
void get_ghosts(const ArchiveReader& archive, const std::string& group,
                Population<T, D>& population) {
  const auto sizes = archive.get<std::int64_t>(group + "/sizes");
  const auto reached = archive.get<std::int64_t>(group + "/reached");
  const auto begins = archive.get<std::int64_t>(group + "/begin");
  const auto packs = archive.get<std::int64_t>(group + "/packs");
  const auto walls = archive.get<std::int32_t>(group + "/wall_and_pressure");
  const auto normals = archive.get<double>(group + "/normal");
  const auto feet = archive.get<double>(group + "/foot");
  const auto slots = archive.get<std::int32_t>(group + "/slot");
  const auto all_pairs = archive.get<kernels::FitPair>(group + "/pairs");
  const auto contact = archive.get<std::int32_t>(group + "/contact");
  const auto active = archive.get<std::uint8_t>(group + "/active");
  const auto contact_heights = archive.get<double>(group + "/contact_height");
  const auto contact_areas = archive.get<double>(group + "/contact_area");
  const auto wall_begins = archive.get<std::int64_t>(group + "/wall_begin");
  const auto wall_distances = archive.get<T>(group + "/wall_distance");
  const auto terms = archive.get<T>(group + "/terms");
  const auto constrained_sums = archive.get<T>(group + "/constrained_sum");
  const auto surface_sums = archive.get<T>(group + "/surface_sum");
  std::size_t ghost = 0, neighbour = 0, pack = 0, begin = 0, touch = 0, wall = 0, term = 0;
  for (std::size_t b = 0; b < population.ghosts.size(); ++b) {
    BlockGhosts<T, D>& g = population.ghosts[b];
    const std::int64_t* size = sizes.data() + 7 * b;
    const std::size_t ghosts = size[0], pairs = size[1], surfaces = size[2], touching = size[5],
                      walled = size[6];
    g.reached_count = reached[b];
    const auto part = [](const auto& all, std::size_t from, std::size_t count) {
      return std::vector(all.begin() + from, all.begin() + from + count);
    };
    g.begin = part(begins, begin, ghosts + 1);
    g.slot = part(slots, ghost, ghosts);
    g.constrained_sum = part(constrained_sums, ghost, ghosts);
    g.surface_sum = part(surface_sums, ghost, ghosts);
    g.pairs = part(all_pairs, neighbour, pairs);
    g.contact = part(contact, touch, touching);
    g.contact_height = part(contact_heights, touch, touching);
    g.contact_area = part(contact_areas, touch, touching);
    g.active = part(active, ghost, ghosts);
    g.wall_begin = part(wall_begins, ghost, ghosts);
    g.wall_distance = part(wall_distances, wall, walled);
    g.terms.resize(ghosts);
    for (auto& fit : g.terms) for_each_term(fit, [&](T& value) { value = terms.at(term++); });
    g.wall.clear();
    g.pressure.clear();
    g.normal.clear();
    g.foot.clear();
    g.touches.clear();
    for (std::size_t i = ghost; i < ghost + ghosts; ++i) {
      g.wall.push_back(static_cast<std::int8_t>(walls[2 * i]));
      g.pressure.push_back(static_cast<std::int8_t>(walls[2 * i + 1]));
      Point<D> normal, foot;
      for (int a = 0; a < D; ++a) {
        normal[a] = normals[D * i + a];
        foot[a] = feet[D * i + a];
      }
      g.normal.push_back(normal);
      g.foot.push_back(foot);
    }
    g.packs.clear();
    for (std::size_t i = pack; i < pack + surfaces; ++i) {
      g.packs.push_back({packs[4 * i], static_cast<std::int32_t>(packs[4 * i + 1]),
                         static_cast<std::int32_t>(packs[4 * i + 2]),
                         static_cast<std::uint16_t>(packs[4 * i + 3])});
    }
    g.first_record = static_cast<std::int32_t>(size[3]);
    g.record_count = static_cast<std::int32_t>(size[4]);
    ghost += ghosts;
    neighbour += pairs;
    pack += surfaces;
    begin += ghosts + 1;
    touch += touching;
    wall += walled;
  }
  population.surface_distance = archive.get<T>(group + "/surface_distance");
  remeshed::list_slots_of_records(population);
}

}  // namespace

template <class T, int D>
void put_solver(ArchiveWriter& archive, remeshed::Solver<T, D>& solver) {
  remeshed::State<T, D>& state = solver.state();
  for_each_counter(state.clock, [&](const char* name, std::int64_t& value) {
    archive.put(std::string("clock/") + name, value);
  });
  for_each_clock_value(state.clock, [&](const char* name, double& value) {
    archive.put(std::string("clock/") + name, value);
  });
  put_offsets<D>(archive, state.boundaries.walls);
  put_points<D>(archive, "walls/impulse", state.wall_impulse);
  put_points<D>(archive, "contacts/impulse", state.contact_impulse);
  std::vector<double> books;
  for (const remeshed::Book<D>& book : state.books) {
    books.push_back(book.mass);
    books.insert(books.end(), book.momentum.begin(), book.momentum.end());
  }
  archive.put("books", std::span<const double>(books));
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    Body<T, D>& body = state.bodies[b];
    const std::string group = fmt::format("body/{}", b);
    const std::size_t slots = body.population.layout.slots();
    const std::vector<std::int32_t> packs = body.population.layout.occupancy().save();
    archive.put(group + "/occupied_packs", std::span<const std::int32_t>(packs));
    archive.put(group + "/particles", body.population.particles);
    archive.put(group + "/strain", body.neighbours.strain);
    archive.put(group + "/strain_rate", body.neighbours.strain_rate);
    const auto* kinds = reinterpret_cast<const std::uint8_t*>(body.population.kind.get());
    archive.put(group + "/kind", std::span<const std::uint8_t>(kinds, slots));
    for_each_slot_array(body, [&](const std::string& name, Buffer<T>& values) {
      archive.put(group + "/" + name, std::span<const T>(values.get(), slots));
    });
    put_ghosts<T, D>(archive, group + "/ghosts", body.population);
  }
}

template <class T, int D>
void get_solver(const ArchiveReader& archive, remeshed::Solver<T, D>& solver) {
  remeshed::State<T, D>& state = solver.state();
  for_each_counter(state.clock, [&](const char* name, std::int64_t& value) {
    value = archive.scalar<std::int64_t>(std::string("clock/") + name);
  });
  for_each_clock_value(state.clock, [&](const char* name, double& value) {
    value = archive.scalar<double>(std::string("clock/") + name);
  });
  get_offsets<D>(archive, state.boundaries.walls);
  get_points<D>(archive, "walls/impulse", state.wall_impulse);
  get_points<D>(archive, "contacts/impulse", state.contact_impulse);
  const auto books = archive.get<double>("books");
  for (std::size_t b = 0; b < state.books.size(); ++b) {
    state.books[b].mass = books.at((D + 1) * b);
    for (int a = 0; a < D; ++a) state.books[b].momentum[a] = books.at((D + 1) * b + a + 1);
  }
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    Body<T, D>& body = state.bodies[b];
    const std::string group = fmt::format("body/{}", b);
    solver.remeshing(static_cast<int>(b))
        .lay_out_again(archive.get<std::int32_t>(group + "/occupied_packs"));
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
      remeshed::find_pack_states<T, D>(population, segment);
    }
    get_ghosts<T, D>(archive, group + "/ghosts", population);
    solver.remeshing(static_cast<int>(b)).adopt_restored();
  }
  solver.restored();
}

template void put_solver<double, 2>(ArchiveWriter&, remeshed::Solver<double, 2>&);
template void get_solver<double, 2>(const ArchiveReader&, remeshed::Solver<double, 2>&);
template void put_solver<double, 3>(ArchiveWriter&, remeshed::Solver<double, 3>&);
template void get_solver<double, 3>(const ArchiveReader&, remeshed::Solver<double, 3>&);

}  // namespace pliant
