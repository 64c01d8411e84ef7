#include "engine/remeshed/surface_area.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <numeric>

namespace pliant::remeshed {

namespace {

template <int D>
using Place = Eigen::Matrix<double, D, 1>;

template <int D>
struct Corner {
  Place<D> place;
  double phi;
};

double size_of(const std::array<Place<2>, 2>& segment) { return (segment[1] - segment[0]).norm(); }

double size_of(const std::array<Place<3>, 3>& triangle) {
  return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm() / 2;
}

// Sums the surface pieces of simplices.
template <int D>
class Pieces {
 public:
  explicit Pieces(const Boundaries<D>& boundaries) : boundaries_(boundaries) {}

  // Where phi changes sign between one corner and all others the surface is one piece; in space,
  // where it changes sign between two and two, it is a quadrilateral.
  void add(std::array<Corner<D>, D + 1> simplex) {
    const auto is_inside = [](const Corner<D>& corner) { return corner.phi < 0; };
    const auto middle = std::stable_partition(simplex.begin(), simplex.end(), is_inside);
    const auto inside = middle - simplex.begin();
    if (inside == 0 || inside == D + 1) return;
    if constexpr (D == 3) {
      if (inside == 2) return add_quadrilateral(simplex);
    }
    const std::size_t alone = inside == 1 ? 0 : D;
    std::array<Place<D>, D> piece;
    for (std::size_t i = 0; i < D; ++i) {
      piece[i] = zero(simplex[alone], simplex[alone == 0 ? i + 1 : i]);
    }
    add_piece(piece);
  }

  double sum() const { return sum_; }

 private:
  // Between two corners inside and two outside.
  void add_quadrilateral(const std::array<Corner<D>, D + 1>& simplex) {
    const Place<D> first = zero(simplex[0], simplex[2]), third = zero(simplex[1], simplex[3]);
    add_piece({first, zero(simplex[0], simplex[3]), third});
    add_piece({first, third, zero(simplex[1], simplex[2])});
  }

  static Place<D> zero(const Corner<D>& a, const Corner<D>& b) {
    return a.place + a.phi / (a.phi - b.phi) * (b.place - a.place);
  }

  void add_piece(const std::array<Place<D>, D>& piece) {
    Place<D> centre = Place<D>::Zero();
    for (const Place<D>& corner : piece) centre += corner / D;
    Point<D> x;
    for (int a = 0; a < D; ++a) x[a] = centre[a];
    if (boundaries_.nearest_wall(x).second > 0) sum_ += size_of(piece);
  }

  const Boundaries<D>& boundaries_;
  double sum_ = 0;
};

template <class T, int D>
std::int64_t particle_at(const LatticeView<T, D>& view, const Cell<D>& cell) {
  const std::int64_t p = view.population.layout.slot(view.body.lattice.wrapped(cell));
  return p >= 0 && view.population.kind[p] != Kind::vacant ? p : -1;
}

// The cube between the node of `cell` and its neighbours; false where one of them is no particle.
template <class T, int D>
bool read_cube(const LatticeView<T, D>& view, const Cell<D>& cell,
               std::array<Corner<D>, 1 << D>& cube) {
  const T* phi = view.fields.get(Field::level_set);
  for (int c = 0; c < (1 << D); ++c) {
    Cell<D> at = cell;
    for (int a = 0; a < D; ++a) at[a] += c >> a & 1;
    const std::int64_t p = particle_at<T, D>(view, at);
    if (p < 0) return false;
    cube[c].phi = phi[p];
    for (int a = 0; a < D; ++a) cube[c].place[a] = view.body.lattice.node(a, at[a]);
  }
  return true;
}

}  // namespace

template <class T, int D>
double surface_area(const LatticeView<T, D>& view, const Boundaries<D>& boundaries) {
  Pieces<D> pieces(boundaries);
  std::array<Corner<D>, 1 << D> cube;
  const auto is_inside = [](const Corner<D>& corner) { return corner.phi < 0; };
  const Layout<D>& layout = view.population.layout;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t, const Cell<D>& cell) {
      if (!view.body.lattice.is_wrapped(cell) || !read_cube<T, D>(view, cell, cube)) return;
      const auto inside = std::count_if(cube.begin(), cube.end(), is_inside);
      if (inside == 0 || inside == (1 << D)) return;
      std::array<int, D> axes;
      std::iota(axes.begin(), axes.end(), 0);
      do {
        std::array<Corner<D>, D + 1> simplex = {cube[0]};
        for (int i = 0, corner = 0; i < D; ++i) simplex[i + 1] = cube[corner |= 1 << axes[i]];
        pieces.add(simplex);
      } while (std::next_permutation(axes.begin(), axes.end()));
    });
  }
  return pieces.sum();
}

template double surface_area<double, 2>(const LatticeView<double, 2>&, const Boundaries<2>&);
template double surface_area<double, 3>(const LatticeView<double, 3>&, const Boundaries<3>&);

}  // namespace pliant::remeshed
