#include "engine/point_based/cut_faces/divided_surface.hpp"

#include <algorithm>
#include <map>

#include "engine/point_based/cut_faces/divided_edges.hpp"
#include "engine/point_based/cut_faces/meeting_point.hpp"
#include "engine/point_based/cutting/subdivide.hpp"

namespace pliant::point_based {

namespace {

constexpr int front_halvings = 20;  // locate the front in a facet to 1e-6 of its size
constexpr double at_vertex = 1e-9;  // points of an edge that count as its end [length of the edge]

template <int D>
class SurfaceDivider {
 public:
  SurfaceDivider(const Simplices<D>& body, std::int32_t corners,
                 const std::vector<std::array<std::int32_t, D>>& facets, const CutPieces<D>& pieces)
      : body_(body), pieces_(pieces), edges_(body, facets, pieces) {
    for (std::int32_t c = 0; c < corners; ++c) {
      vertex_of_[{c, none, none, none, c}] = c;
      surface_.vertices.push_back({body.places[c], c, {}});
    }
    for (const auto& facet : facets) divide(facet);
    for (const auto& simplex : body.simplices) add_faces(simplex);
  }

  DividedSurface<D> take() { return std::move(surface_); }

 private:
  static constexpr std::int32_t none = -1;
  using Crossings = std::vector<typename CutPieces<D>::Crossed>;
  using Facet = std::array<std::int32_t, D>;
  using Triangle = std::array<std::int32_t, 3>;
  /// Identifies a vertex: the vertices of a simplex in ascending order, padded with `none`, and the
  /// first vertex of the part on whose side the point is.
  using Name = std::array<std::int32_t, 5>;

  /// A point of a cut, on both sides of it.
  struct Pair {
    std::int32_t lower, upper;
  };
  /// The line of a cut in a triangle, between the parts of `lower` and `upper`.
  struct Line {
    std::int32_t lower, upper;  ///< vertices on its sides
    Pair from, to;
  };

  void add(const Facet& facet) {
    for (int v = 0; v < D; ++v) {
      for (int w = 0; w < v; ++w) {
        if (facet[v] == facet[w]) return;
      }
    }
    surface_.facets.push_back(facet);
  }

  template <std::size_t N>
  static Name name_of(std::array<std::int32_t, N> vertices, std::int32_t part) {
    std::sort(vertices.begin(), vertices.end());
    Name name = {none, none, none, none, part};
    std::copy(vertices.begin(), vertices.end(), name.begin());
    return name;
  }

  /// The vertex with this name. If it is new, `place()` gives its place and crossings.
  template <class F>
  std::int32_t vertex(const Name& name, F&& place) {
    const auto known = vertex_of_.find(name);
    if (known != vertex_of_.end()) return known->second;
    const auto [x, crossings] = place();
    const auto number = static_cast<std::int32_t>(surface_.vertices.size());
    vertex_of_[name] = number;
    SurfaceVertex<D>& vertex = surface_.vertices.emplace_back();
    Eigen::Map<Column<D>>(vertex.place.data()) = x;
    vertex.side = name.back();
    mark(crossings, vertex);
    return number;
  }

  static void mark(const Crossings& crossings, SurfaceVertex<D>& vertex) {
    for (const auto& crossed : crossings) vertex.cuts.push_back(crossed.cut);
    std::sort(vertex.cuts.begin(), vertex.cuts.end());
    vertex.cuts.erase(std::unique(vertex.cuts.begin(), vertex.cuts.end()), vertex.cuts.end());
  }

  /// The point of a divided edge on the side of its end `end`; that end itself if the cut passes
  /// through it.
  std::int32_t edge_point(std::int32_t end, std::int32_t other) {
    const DividedEdge<D>& edge = *edges_.find(end, other);
    const Column<D> x = column<D>(body_.places[end]);
    const double length = (column<D>(body_.places[other]) - x).norm();
    if ((edge.point - x).norm() > at_vertex * length) {
      return vertex(name_of<2>({end, other}, end),
                    [&edge] { return std::pair(edge.point, edge.crossings); });
    }
    const std::int32_t at =
        vertex(name_of<1>({end}, end), [&] { return std::pair(x, edge.crossings); });
    mark(edge.crossings, surface_.vertices[at]);
    return at;
  }
  Pair edge_points(std::int32_t lower, std::int32_t upper) {
    return {edge_point(lower, upper), edge_point(upper, lower)};
  }

  template <std::size_t N>
  Crossings crossings_of(const std::array<std::int32_t, N>& vertices) const {
    Crossings all;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const DividedEdge<D>* edge = edges_.find(vertices[i], vertices[j]);
        if (edge) all.insert(all.end(), edge->crossings.begin(), edge->crossings.end());
      }
    }
    return all;
  }

  int divided_edges(const Triangle& triangle) const {
    int count = 0;
    for (int v = 0; v < 3; ++v) count += edges_.find(triangle[v], triangle[(v + 1) % 3]) ? 1 : 0;
    return count;
  }

  /// Where the cut that crosses one edge of a triangle ends: at the last crossing with lines
  /// parallel to that edge.
  Column<D> front_point(const Triangle& triangle) const {
    int v = 0;
    while (!edges_.find(triangle[v], triangle[(v + 1) % 3])) ++v;
    const Point<D>&a = body_.places[triangle[v]], &b = body_.places[triangle[(v + 1) % 3]],
          &c = body_.places[triangle[(v + 2) % 3]];
    Column<D> last = edges_.find(triangle[v], triangle[(v + 1) % 3])->point;
    double crossed = 0, whole = 1;
    for (int i = 0; i < front_halvings; ++i) {
      const double share = (crossed + whole) / 2;
      const auto found = pieces_.crossings(between<D>(a, c, share), between<D>(b, c, share));
      (found.empty() ? whole : crossed) = share;
      if (!found.empty()) last = column<D>(found.front().place);
    }
    return last;
  }

  /// The point inside a triangle where a cut ends or cuts meet, on the side of `part`; `held` as in
  /// meeting_point. Facets of the body's surface compute theirs first.
  std::int32_t centre(const Triangle& triangle, std::int32_t part,
                      std::span<const Column<D>> held = {}) {
    return vertex(name_of<3>(triangle, part), [&] {
      const Crossings crossings = crossings_of(triangle);
      if (divided_edges(triangle) == 1) return std::pair(front_point(triangle), crossings);
      return std::pair(meeting_point<D>(crossings, held, size_of(triangle)), crossings);
    });
  }
  bool has_centre(const Triangle& triangle) const { return divided_edges(triangle) % 2 == 1; }

  template <std::size_t N>
  double size_of(const std::array<std::int32_t, N>& vertices) const {
    double longest = 0;
    for (std::size_t i = 1; i < N; ++i) {
      longest = std::max(
          longest,
          (column<D>(body_.places[vertices[i]]) - column<D>(body_.places[vertices[0]])).norm());
    }
    return longest;
  }

  /// Calls f(line) for the lines of cuts in a triangle, each with `lower` to its left.
  template <class F>
  void for_each_line(const Triangle& triangle, F&& f) {
    if (divided_edges(triangle) == 0) return;
    const bool ends_inside = has_centre(triangle);
    const Triangle parts = edges_.template parts<3>(triangle);
    for (int v = 0; v < 3; ++v) {
      const std::int32_t a = triangle[v], b = triangle[(v + 1) % 3], c = triangle[(v + 2) % 3];
      if (ends_inside && edges_.find(a, b)) {
        f(Line{a,
               b,
               edge_points(a, b),
               {centre(triangle, parts[v]), centre(triangle, parts[(v + 1) % 3])}});
      }
      if (!ends_inside && !edges_.find(b, c)) {
        f(Line{a, b, edge_points(a, b), edge_points(a, c)});
      }
    }
  }

  void divide(const std::array<std::int32_t, 2>& segment) {
    const auto [a, b] = segment;
    if (!edges_.find(a, b)) return add({a, b});
    add({a, edge_point(a, b)});
    add({edge_point(b, a), b});
  }
  void divide(const Triangle& triangle) {
    if (divided_edges(triangle) == 0) return add(triangle);
    const bool ends_inside = has_centre(triangle);
    const Triangle parts = edges_.template parts<3>(triangle);
    const std::array<Column<D>, 1> normal = {facet_normal<D>(body_.places, triangle)};
    const auto centre_at = [&](int v) { return centre(triangle, parts[v], normal); };
    for (int v = 0; v < 3; ++v) {
      const std::int32_t a = triangle[v], b = triangle[(v + 1) % 3], c = triangle[(v + 2) % 3];
      const bool is_whole = !edges_.find(a, b);
      if (ends_inside && is_whole) add({a, b, centre_at(v)});
      if (ends_inside && !is_whole) {
        add({a, edge_point(a, b), centre_at(v)});
        add({edge_point(b, a), b, centre_at((v + 1) % 3)});
      }
      if (!ends_inside && !edges_.find(b, c)) {
        add({a, edge_point(a, b), edge_point(a, c)});
        add({edge_point(b, a), b, c});
        add({edge_point(b, a), c, edge_point(c, a)});
      }
    }
  }

  void add_faces(const std::array<std::int32_t, 3>& triangle) {
    for_each_line(triangle, [&](const Line& line) {
      add({line.from.lower, line.to.lower});
      add({line.to.upper, line.from.upper});
    });
  }

  // The faces in a tetrahedron form a cone from the lines in its facets to a point inside, or on an
  // edge if a single cut passes through.
  void add_faces(const std::array<std::int32_t, 4>& simplex) {
    const std::array<Triangle, 4> facets = {{{simplex[0], simplex[1], simplex[2]},
                                             {simplex[0], simplex[3], simplex[1]},
                                             {simplex[0], simplex[2], simplex[3]},
                                             {simplex[1], simplex[3], simplex[2]}}};
    const bool is_plain = std::none_of(facets.begin(), facets.end(),
                                       [this](const Triangle& t) { return has_centre(t); });
    const auto parts = edges_.template parts<4>(simplex);
    const auto part_of = [&](std::int32_t vertex) {
      return parts[std::find(simplex.begin(), simplex.end(), vertex) - simplex.begin()];
    };
    std::array<std::int32_t, 2> first = {none, none};
    for (int i = 0; i < 4 && first[0] == none; ++i) {
      for (int j = 0; j < i && first[0] == none; ++j) {
        if (edges_.find(simplex[i], simplex[j])) first = {simplex[i], simplex[j]};
      }
    }
    if (first[0] == none) return;
    const auto apex = [&](std::int32_t vertex) {
      if (!is_plain) return inner_point(simplex, facets, part_of(vertex));
      const bool is_first = part_of(first[0]) == part_of(vertex);
      return edge_point(first[is_first ? 0 : 1], first[is_first ? 1 : 0]);
    };
    for (const Triangle& facet : facets) {
      for_each_line(facet, [&](const Line& line) {
        add({line.from.lower, line.to.lower, apex(line.lower)});
        add({line.to.upper, line.from.upper, apex(line.upper)});
      });
    }
  }

  /// Halfway between the ends of fronts in the facets, or else the point where the cuts meet.
  std::int32_t inner_point(const std::array<std::int32_t, 4>& simplex,
                           const std::array<Triangle, 4>& facets, std::int32_t part) {
    return vertex(name_of<4>(simplex, part), [&] {
      const Crossings crossings = crossings_of(simplex);
      Column<D> sum = Column<D>::Zero();
      int fronts = 0;
      for (const Triangle& facet : facets) {
        if (divided_edges(facet) != 1) continue;
        sum +=
            column<D>(surface_.vertices[centre(facet, edges_.template parts<3>(facet)[0])].place);
        ++fronts;
      }
      const Column<D> x =
          fronts > 0 ? Column<D>(sum / fronts)
                     : meeting_point<D>(crossings, std::span<const Column<D>>(), size_of(simplex));
      return std::pair(x, crossings);
    });
  }

  const Simplices<D>& body_;
  const CutPieces<D>& pieces_;
  DividedEdges<D> edges_;
  DividedSurface<D> surface_;
  std::map<Name, std::int32_t> vertex_of_;
};

}  // namespace

template <int D>
DividedSurface<D> divide_surface(const Simplices<D>& body, std::int32_t corners,
                                 const std::vector<std::array<std::int32_t, D>>& facets,
                                 const CutPieces<D>& pieces) {
  return SurfaceDivider<D>(body, corners, facets, pieces).take();
}

template DividedSurface<2> divide_surface<2>(const Simplices<2>&, std::int32_t,
                                             const std::vector<std::array<std::int32_t, 2>>&,
                                             const CutPieces<2>&);
template DividedSurface<3> divide_surface<3>(const Simplices<3>&, std::int32_t,
                                             const std::vector<std::array<std::int32_t, 3>>&,
                                             const CutPieces<3>&);

}  // namespace pliant::point_based
