#include "engine/remeshed/observe/surface.hpp"

#include <cmath>

#include "engine/remeshed/level_set/interpolant.hpp"

namespace pliant::remeshed {

namespace {

template <class T, int D>
class Surface {
 public:
  explicit Surface(const LatticeView<T, D>& view)
      : lattice_(view.body.lattice),
        interpolant_(lattice_, view.population.layout, view.fields.get(Field::level_set)) {}

  std::optional<double> phi(const Vector& x) const {
    Point<D> slope;
    return phi(x, slope);
  }

  // The zero of phi between two distances along a ray, with phi < 0 at the first, to rounding
  // accuracy: by Newton's method, or by bisection if that leaves the bracket.
  double zero(const Vector& origin, const Vector& direction, double inside, double outside) const {
    const double negligible = 1e-12 * (outside - inside);  // its square is below rounding
    double s = (inside + outside) / 2;
    for (int i = 0; i < 60; ++i) {
      Point<D> slope = {};
      const std::optional<double> value = phi(along(origin, direction, s), slope);
      (value && *value < 0 ? inside : outside) = s;
      double rise = 0;
      for (int a = 0; a < D; ++a) rise += slope[a] / lattice_.spacing * direction[a];
      const double step = value && rise > 0 ? -*value / rise : outside - inside;
      if (std::abs(step) <= negligible) return s + step;
      s += step;
      if (s <= inside || s >= outside) s = (inside + outside) / 2;
    }
    return s;
  }

  static Vector along(const Vector& origin, const Vector& direction, double s) {
    return {origin[0] + s * direction[0], origin[1] + s * direction[1],
            origin[2] + s * direction[2]};
  }

 private:
  // The slope is per cell.
  std::optional<double> phi(const Vector& x, Point<D>& slope) const {
    Point<D> at;
    for (int a = 0; a < D; ++a) at[a] = (x[a] - lattice_.origin[a]) / lattice_.spacing - 0.5;
    double value = 0;
    if (!interpolant_(at, value, slope)) return std::nullopt;
    return value;
  }

  const Lattice<D>& lattice_;
  CubicInterpolant<T, D> interpolant_;
};

/// Whether phi bends sharply along an axis at a node, as beside the edge of a box, where another
/// face is nearer: a cubic through such a kink crosses 0 outside of the body.
template <class T, int D>
bool bends_at(const LatticeView<T, D>& view, const Cell<D>& cell, int axis) {
  constexpr double sharply = 0.35;  // [h] second difference
  const T* phi = view.fields.get(Field::level_set);
  const Layout<D>& layout = view.population.layout;
  Cell<D> up = cell, down = cell;
  ++up[axis];
  --down[axis];
  const std::int64_t p = layout.slot(cell), q = layout.slot(up), r = layout.slot(down);
  if (q < 0 || r < 0) return false;
  return std::abs(phi[q] - 2 * phi[p] + phi[r]) > sharply * view.body.lattice.spacing;
}

// The last cell along the ray that may contain a part of the body.
template <class T, int D>
double reach(const LatticeView<T, D>& view, const Vector& origin) {
  double far = 0;
  for (const Block<D>& block : view.population.layout.blocks()) {
    double square = 0;
    for (int a = 0; a < D; ++a) {
      const double low = std::abs(view.body.lattice.node(a, block.lower[a]) - origin[a]);
      const double high = std::abs(view.body.lattice.node(a, block.upper[a]) - origin[a]);
      square += std::pow(std::max(low, high), 2);
    }
    far = std::max(far, std::sqrt(square));
  }
  return far;
}

}  // namespace

template <class T, int D>
std::optional<double> ray_to_surface(const LatticeView<T, D>& view, const Vector& origin,
                                     const Vector& direction,
                                     const std::function<bool(const Vector&)>& counts) {
  const Surface<T, D> surface(view);
  const double step = view.body.lattice.spacing / 4;
  std::optional<double> found;
  bool inside = false;
  const double end = reach(view, origin);
  for (double s = 0; s < end; s += step) {
    const std::optional<double> value = surface.phi(Surface<T, D>::along(origin, direction, s));
    const bool now_inside = value && *value < 0;
    if (inside && !now_inside && value) {
      const double zero = surface.zero(origin, direction, s - step, s);
      if (!counts || counts(Surface<T, D>::along(origin, direction, zero))) found = zero;
    }
    inside = now_inside;
  }
  return found;
}

template <class T, int D>
std::optional<double> extent(const LatticeView<T, D>& view, int axis, bool lower_side,
                             const std::function<bool(const Vector&)>& counts) {
  const Surface<T, D> surface(view);
  const Lattice<D>& lattice = view.body.lattice;
  const Layout<D>& layout = view.population.layout;
  const T* phi = view.fields.get(Field::level_set);
  const double side = lower_side ? -1 : 1;
  Vector direction = {};
  direction[axis] = side;
  std::optional<double> farthest;
  for (const Block<D>& block : layout.blocks()) {
    layout.for_each_slot(block, [&](std::int64_t p, const Cell<D>& cell) {
      if (phi[p] >= 0 || phi[p] < -1.5 * lattice.spacing) return;
      Cell<D> next = cell;
      next[axis] += lower_side ? -1 : 1;
      const std::int64_t q = layout.slot(next);
      if (q < 0 || phi[q] < 0) return;
      Vector node = {};
      for (int a = 0; a < D; ++a) node[a] = lattice.node(a, cell[a]);
      const double s = bends_at<T, D>(view, cell, axis)
                           ? lattice.spacing * phi[p] / (phi[p] - phi[q])
                           : surface.zero(node, direction, 0, lattice.spacing);
      const Vector at = Surface<T, D>::along(node, direction, s);
      if (!counts(at)) return;
      if (!farthest || side * (at[axis] - *farthest) > 0) farthest = at[axis];
    });
  }
  return farthest;
}

template std::optional<double> ray_to_surface(const LatticeView<double, 2>&, const Vector&,
                                              const Vector&,
                                              const std::function<bool(const Vector&)>&);
template std::optional<double> extent(const LatticeView<double, 2>&, int, bool,
                                      const std::function<bool(const Vector&)>&);
template std::optional<double> ray_to_surface(const LatticeView<double, 3>&, const Vector&,
                                              const Vector&,
                                              const std::function<bool(const Vector&)>&);
template std::optional<double> extent(const LatticeView<double, 3>&, int, bool,
                                      const std::function<bool(const Vector&)>&);
template std::optional<double> ray_to_surface(const LatticeView<float, 2>&, const Vector&,
                                              const Vector&,
                                              const std::function<bool(const Vector&)>&);
template std::optional<double> extent(const LatticeView<float, 2>&, int, bool,
                                      const std::function<bool(const Vector&)>&);
template std::optional<double> ray_to_surface(const LatticeView<float, 3>&, const Vector&,
                                              const Vector&,
                                              const std::function<bool(const Vector&)>&);
template std::optional<double> extent(const LatticeView<float, 3>&, int, bool,
                                      const std::function<bool(const Vector&)>&);

}  // namespace pliant::remeshed
