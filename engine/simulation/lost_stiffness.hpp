#pragma once

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/case/method_rules.hpp"
#include "engine/method/solver.hpp"
#include "kernels/layout.hpp"

/// Hooke's law in rate form, `linear` in the remeshed method, loses its stiffness against shear in
/// some direction if sigma_1 - sigma_3 exceeds 2 mu, (RP.94). Strain then localises in bands one or
/// two spacings wide, and stress and force become meaningless.
namespace pliant {

/// Whether the largest minus the smallest principal value of a symmetric tensor exceeds `limit`; in
/// 2D, of the values in the plane. Components are in the order of symmetric_index.
template <int D, class T>
bool exceeds(const std::vector<std::span<const T>>& components, std::int64_t slot, double limit) {
  Eigen::Matrix<double, D, D> tensor;
  for (int i = 0; i < D; ++i) {
    for (int j = 0; j < D; ++j) {
      tensor(i, j) = components[kernels::symmetric_index<D>(i, j)][slot];
    }
  }
  // (a - b)^2 <= 2 (a^2 + b^2), so most tensors need no eigenvalues.
  if (2 * tensor.squaredNorm() <= limit * limit) return false;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> solver;
  solver.computeDirect(tensor, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[D - 1] - solver.eigenvalues()[0] > limit;
}

/// Share of the particles of a body that have lost their stiffness, (RP.94).
inline double share_without_stiffness(const Solver& solver, int body) {
  const double limit = 2 * solver.settings().bodies[body].material.shear_modulus;
  const bool in_plane = solver.settings().dimension == 2;
  const std::vector<FieldView> fields = solver.fields(body);
  const auto state = std::ranges::find(fields, "material_state", &FieldView::name);
  if (state == fields.end()) return 0;
  const auto share = [&](const auto& components) {
    std::int64_t all = 0, without = 0;
    for (const SlotRun& run : solver.particle_runs(body)) {
      for (std::int64_t slot = run.first; slot < run.last; ++slot, ++all) {
        without +=
            in_plane ? exceeds<2>(components, slot, limit) : exceeds<3>(components, slot, limit);
      }
    }
    return all > 0 ? static_cast<double>(without) / static_cast<double>(all) : 0.0;
  };
  return state->values.empty() ? share(state->single_values) : share(state->values);
}

/// Names the first body that has partly lost its stiffness, and a remedy; empty if there is none.
/// Singular stresses at the end of a wall alone affect less than a twentieth of a body.
inline std::string lost_stiffness_warning(const Solver& solver) {
  constexpr double part = 0.05;
  const Case& settings = solver.settings();
  if (!is_remeshed(settings)) return {};
  for (std::size_t b = 0; b < settings.bodies.size(); ++b) {
    if (kernels::carries_deformation(settings.bodies[b].material.model)) continue;
    const double share = share_without_stiffness(solver, static_cast<int>(b));
    if (share <= part) continue;
    return fmt::format(
        "warning: t = {:.6g} s: the linear material of body `{}` is sheared beyond its range in "
        "{:.2g} of its particles: it has no stiffness left there, and strain will gather in bands; "
        "use model = \"reduced_polynomial\" for strains as large as these",
        solver.clock().time, settings.bodies[b].name, share);
  }
  return {};
}

}  // namespace pliant
