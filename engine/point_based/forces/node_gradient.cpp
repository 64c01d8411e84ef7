#include "engine/point_based/forces/node_gradient.hpp"

namespace pliant::point_based {

template <class T, int D>
std::array<double, D * D> with_kept(const Body<T, D>& body, std::int64_t slot,
                                    const std::array<double, D * D>& fit) {
  if (!body.has_cuts()) return fit;
  std::array<double, D* D> f = {};
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      for (int k = 0; k < D; ++k) {
        f[D * i + j] += fit[D * i + k] * body.kept_gradient[D * k + j][slot];
      }
    }
  }
  return f;
}

template <class T, int D>
NodeFit<D> node_fit(const Body<T, D>& body, const NodeBlock& block, std::int64_t slot) {
  std::array<double, D* D> h = {};
  double apart = 0;  // sum of w u_ij . u_ij
  body.for_each_bond(block, slot, [&](int, std::int64_t other, const Point<D>& g, double w) {
    for (int i = 0; i < D; ++i) {
      const double d =
          static_cast<double>(body.displacement[i][other]) - body.displacement[i][slot];
      apart += w * d * d;
      for (int j = 0; j < D; ++j) h[D * i + j] += d * g[j];
    }
  });
  NodeFit<D> found{h, 0};
  for (int i = 0; i < D; ++i) {
    found.gradient[D * i + i] += 1;
    for (int j = 0; j < D; ++j) {
      // The part that the least-squares fit explains: tr(H A H^T).
      for (int k = 0; k < D; ++k) {
        apart -= h[D * i + j] * h[D * i + k] * body.moment[kernels::symmetric_index<D>(j, k)][slot];
      }
    }
  }
  found.stabilisation = body.stiffness[slot] * apart / 2;
  return found;
}

template <class T, int D>
std::array<double, D * D> fitted_gradient(const Body<T, D>& body, const NodeBlock& block,
                                          std::int64_t slot) {
  std::array<double, D* D> fit = {};
  for (int i = 0; i < D; ++i) fit[(D + 1) * i] = 1;
  body.for_each_bond(block, slot, [&](int, std::int64_t other, const Point<D>& g, double) {
    for (int i = 0; i < D; ++i) {
      const double d =
          static_cast<double>(body.displacement[i][other]) - body.displacement[i][slot];
      for (int j = 0; j < D; ++j) fit[D * i + j] += d * g[j];
    }
  });
  return fit;
}

template <class T, int D>
std::array<double, D * D> present_gradient(const Body<T, D>& body, const NodeBlock& block,
                                           std::int64_t slot) {
  return with_kept(body, slot, fitted_gradient(body, block, slot));
}

template NodeFit<2> node_fit(const Body<double, 2>&, const NodeBlock&, std::int64_t);
template std::array<double, 4> fitted_gradient(const Body<double, 2>&, const NodeBlock&,
                                               std::int64_t);
template std::array<double, 4> with_kept(const Body<double, 2>&, std::int64_t,
                                         const std::array<double, 4>&);
template NodeFit<3> node_fit(const Body<double, 3>&, const NodeBlock&, std::int64_t);
template std::array<double, 9> fitted_gradient(const Body<double, 3>&, const NodeBlock&,
                                               std::int64_t);
template std::array<double, 9> with_kept(const Body<double, 3>&, std::int64_t,
                                         const std::array<double, 9>&);
template NodeFit<2> node_fit(const Body<float, 2>&, const NodeBlock&, std::int64_t);
template std::array<double, 4> fitted_gradient(const Body<float, 2>&, const NodeBlock&,
                                               std::int64_t);
template std::array<double, 4> with_kept(const Body<float, 2>&, std::int64_t,
                                         const std::array<double, 4>&);
template NodeFit<3> node_fit(const Body<float, 3>&, const NodeBlock&, std::int64_t);
template std::array<double, 9> fitted_gradient(const Body<float, 3>&, const NodeBlock&,
                                               std::int64_t);
template std::array<double, 9> with_kept(const Body<float, 3>&, std::int64_t,
                                         const std::array<double, 9>&);
template std::array<double, 4> present_gradient(const Body<double, 2>&, const NodeBlock&,
                                                std::int64_t);
template std::array<double, 9> present_gradient(const Body<double, 3>&, const NodeBlock&,
                                                std::int64_t);
template std::array<double, 4> present_gradient(const Body<float, 2>&, const NodeBlock&,
                                                std::int64_t);
template std::array<double, 9> present_gradient(const Body<float, 3>&, const NodeBlock&,
                                                std::int64_t);

}  // namespace pliant::point_based
