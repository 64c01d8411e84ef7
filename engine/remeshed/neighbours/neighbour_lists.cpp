#include "engine/remeshed/neighbours/neighbour_lists.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::remeshed {

namespace {

/// A neighbour of a particle.
template <int D>
struct Neighbour {
  Cell<D> offset;  // from the cell of the particle to that of the neighbour
  std::int32_t slot;

  // The order of the stencil.
  friend bool operator<(const Neighbour& a, const Neighbour& b) {
    return std::lexicographical_compare(a.offset.rbegin(), a.offset.rend(), b.offset.rbegin(),
                                        b.offset.rend());
  }
};

/// Calls f(neighbour) for all slots within the search radius of a particle, until a call returns
/// true. Returns whether one did.
template <int D, class F>
bool any_neighbour(const BodyNeighbours<D>& search, const SlotSite<D>& p, F&& f) {
  const double limit = search.radius * search.radius;
  return search.cells.any_near(p.position, [&](const SlotSite<D>& q, const Point<D>& shift) {
    Neighbour<D> neighbour = {{}, q.label.slot};
    double distance2 = 0;
    bool is_itself = true;
    for (int a = 0; a < D; ++a) {
      const double d = q.position[a] + shift[a] - p.position[a];
      distance2 += d * d;
      neighbour.offset[a] = q.label.cell[a] + static_cast<std::int32_t>(shift[a]) - p.label.cell[a];
      is_itself = is_itself && neighbour.offset[a] == 0;
    }
    return distance2 < limit && !is_itself && f(neighbour);
  });
}

/// The lanes of a pack, reused by each thread so that later searches do not allocate.
template <int D>
std::array<std::vector<Neighbour<D>>, Layout<D>::pack>& lane_scratch() {
  thread_local std::array<std::vector<Neighbour<D>>, Layout<D>::pack> lanes;
  return lanes;
}

/// Lists the neighbours of the pack at `first`, lanes interleaved. Missing entries of a lane are
/// the particle itself, which adds nothing to any sum.
template <class T, int D>
void list_pack(Body<T, D>& body, BlockNeighbours<D>& own, std::int64_t first, Cell<D> cell) {
  constexpr int pack = Layout<D>::pack;
  BodyNeighbours<D>& search = body.neighbours;
  auto& lanes = lane_scratch<D>();
  std::size_t longest = 0;
  for (int l = 0; l < pack; ++l, ++cell[0]) {
    lanes[l].clear();
    if (body.population.kind[first + l] != Kind::interior) continue;
    any_neighbour<D>(search, site_of<T, D>(body, first + l, cell), [&](const Neighbour<D>& q) {
      lanes[l].push_back(q);
      return false;
    });
    std::sort(lanes[l].begin(), lanes[l].end());
    longest = std::max(longest, lanes[l].size());
  }
  search.start[first / pack] = static_cast<std::int64_t>(own.slot.size());
  search.length[first / pack] = static_cast<std::int32_t>(longest);
  for (std::size_t k = 0; k < longest; ++k) {
    for (int l = 0; l < pack; ++l) {
      const Neighbour<D> itself = {{}, static_cast<std::int32_t>(first + l)};
      const Neighbour<D>& q = k < lanes[l].size() ? lanes[l][k] : itself;
      own.slot.push_back(q.slot);
      for (int a = 0; a < D; ++a) own.offset[a].push_back(q.offset[a]);
    }
  }
}

// The stencil excludes those corners of its cube that are as far as the nearest slots beyond it.
template <class T, int D>
bool any_beyond_stencil(const Body<T, D>& body, const Block<D>& range, int reach) {
  bool found = false;
  body.population.layout.for_each_slot(range, [&](std::int64_t p, const Cell<D>& cell) {
    if (found || body.population.kind[p] != Kind::interior) return;
    found =
        any_neighbour<D>(body.neighbours, site_of<T, D>(body, p, cell), [&](const Neighbour<D>& q) {
          double distance2 = 0;
          for (const double cells : q.offset) distance2 += cells * cells;
          return distance2 >= (reach + 1) * (reach + 1);
        });
  });
  return found;
}

}  // namespace

// Images are left out: the search handles periods itself, however many a particle has passed.
template <class T, int D>
void find_sites(Body<T, D>& body, int block) {
  BlockNeighbours<D>& own = body.neighbours.blocks[block];
  const Layout<D>& layout = body.population.layout;
  own.sites.clear();
  own.lower.fill(std::numeric_limits<double>::max());
  own.upper.fill(std::numeric_limits<double>::lowest());
  layout.for_each_slot(layout.blocks()[block], [&](std::int64_t p, const Cell<D>& cell) {
    const Kind kind = body.population.kind[p];
    if (kind == Kind::vacant || kind == Kind::image) return;
    own.sites.push_back(site_of<T, D>(body, p, cell));
    for (int a = 0; a < D; ++a) {
      own.lower[a] = std::min(own.lower[a], own.sites.back().position[a]);
      own.upper[a] = std::max(own.upper[a], own.sites.back().position[a]);
    }
  });
}

template <class T, int D>
void sort_sites(Body<T, D>& body) {
  BodyNeighbours<D>& search = body.neighbours;
  Point<D> lower = search.blocks[0].lower, upper = search.blocks[0].upper;
  std::size_t count = 0;
  for (const BlockNeighbours<D>& own : search.blocks) {
    count += own.sites.size();
    for (int a = 0; a < D; ++a) {
      lower[a] = std::min(lower[a], own.lower[a]);
      upper[a] = std::max(upper[a], own.upper[a]);
    }
  }
  search.cells.cover(lower, upper, period_of<D>(body.lattice), search.radius, count);
  search.cells.sort(count, [&](auto&& f) {
    for (const BlockNeighbours<D>& own : search.blocks) {
      for (const SlotSite<D>& site : own.sites) f(site);
    }
  });
}

template <class T, int D>
void list_neighbours(Body<T, D>& body, int block, int reach, bool in_any_case) {
  BlockNeighbours<D>& own = body.neighbours.blocks[block];
  const Layout<D>& layout = body.population.layout;
  const Block<D>& range = layout.blocks()[block];
  own.slot.clear();
  for (auto& component : own.offset) component.clear();
  own.are_listed = in_any_case || any_beyond_stencil(body, range, reach);
  if (!own.are_listed) return;
  constexpr int pack = Layout<D>::pack;
  for (int s = 0; s < range.segment_count; ++s) {
    const kernels::Segment<D>& segment = layout.segments_of(range)[s];
    Cell<D> cell = segment.cell;
    for (std::int64_t p = segment.first; p < segment.first + segment.count; p += pack) {
      if (holds_interior(body.population.pack_state[p / pack])) list_pack<T, D>(body, own, p, cell);
      cell[0] += pack;
    }
  }
}

template void find_sites<double, 2>(Body<double, 2>&, int);
template void find_sites<double, 3>(Body<double, 3>&, int);
template void sort_sites<double, 2>(Body<double, 2>&);
template void sort_sites<double, 3>(Body<double, 3>&);
template void list_neighbours<double, 2>(Body<double, 2>&, int, int, bool);
template void list_neighbours<double, 3>(Body<double, 3>&, int, int, bool);
template void find_sites<float, 2>(Body<float, 2>&, int);
template void find_sites<float, 3>(Body<float, 3>&, int);
template void sort_sites<float, 2>(Body<float, 2>&);
template void sort_sites<float, 3>(Body<float, 3>&);
template void list_neighbours<float, 2>(Body<float, 2>&, int, int, bool);
template void list_neighbours<float, 3>(Body<float, 3>&, int, int, bool);

}  // namespace pliant::remeshed
