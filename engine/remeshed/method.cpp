#include "engine/remeshed/method.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/boundaries/overhanging_bodies.hpp"
#include "engine/case/checks/check.hpp"
#include "engine/case/checks/hollows.hpp"
#include "engine/case/checks/measured_edges.hpp"
#include "engine/case/checks/narrow_places.hpp"
#include "engine/case/checks/short_runs.hpp"
#include "engine/case/checks/stability.hpp"
#include "engine/case/checks/thickness.hpp"
#include "engine/case/checks/tools.hpp"
#include "engine/case/placement.hpp"
#include "engine/case/vocabulary/boundary_kinds.hpp"
#include "engine/geometry/is_round.hpp"
#include "engine/method/gravity.hpp"
#include "engine/remeshed/observe/measure.hpp"
#include "engine/remeshed/parameters.hpp"
#include "engine/remeshed/setup/deep_walls.hpp"
#include "engine/remeshed/setup/footprint.hpp"
#include "engine/remeshed/setup/particle_kinds.hpp"
#include "engine/remeshed/solver.hpp"
#include "engine/remeshed/step_limits.hpp"
#include "engine/remeshed/ties.hpp"

namespace pliant::remeshed {

namespace {

// A ghost keeps its side of a contact wall until the next remeshing, so contact walls need
// remeshings.
void check_contact_steps(const Check& check) {
  using Policy = decltype(Case::remeshing)::Policy;
  if (check.a_case.remeshing.policy != Policy::never) return;
  for (const BoundaryCase& boundary : check.a_case.boundaries) {
    if (boundary.kind != BoundaryCase::Kind::contact_wall) continue;
    check.problems.add(check.place("remeshing", "every"), "contact walls need remeshings",
                       "write every = \"adaptive\"");
    return;
  }
}

void check_tractions(const Check& check) {
  const Case& a_case = check.a_case;
  for (std::size_t i = 0; i < a_case.boundaries.size(); ++i) {
    const BoundaryCase& boundary = a_case.boundaries[i];
    if (boundary.kind != BoundaryCase::Kind::traction) continue;
    if (boundary.area != BoundaryCase::LoadedArea::present) {
      check.problems.add(check.place("boundary", i, "area"),
                         "method \"remeshed\" does not know the undeformed surface",
                         "write area = \"present\", or take method = \"total_lagrangian\"");
    }
    if (a_case.ghosts == GhostTreatment::averaged) {
      check.problems.add(check.place("ghosts", "treatment"), "averaged ghosts carry no tractions",
                         "write treatment = \"linear\", or remove the key");
    }
  }
}

// Heights above contact walls are along the normals at the last remeshing.
void check_walls_that_turn(const Check& check) {
  const auto& boundaries = check.a_case.boundaries;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    if (!boundaries[i].rotation || row_of(boundaries[i].kind).is_attached) continue;
    check.problems.add(check.place("boundary", i, "rotation"),
                       "method \"remeshed\" has no contact walls that turn",
                       "take method = \"total_lagrangian\", or remove the key");
  }
}

// Determinants of the moment matrices in 3D are of the size of h^6.
void check_precision(const Check& check) {
  constexpr double least_spacing = 1e-6;  // [m]
  const Case& a_case = check.a_case;
  if (a_case.precision != Precision::binary32 || a_case.dimension == 2) return;
  if (a_case.discretisation.spacing > 0.99 * least_spacing) return;
  check.problems.add(
      check.place("precision", ""),
      fmt::format("single precision cannot hold the sixth power of a spacing of {} m",
                  a_case.discretisation.spacing),
      "write precision = \"double\", or give lengths in millimetres");
}

// The moment-matrix gradient is compiled for every kernel, those of H&K only for the quartic
// spline.
void check_gradient(const Check& check) {
  if (parameters_of(check.a_case).gradient == kernels::Gradient::moment_matrix) return;
  if (check.a_case.discretisation.kernel == kernels::Kernel::quartic_spline) return;
  check.problems.add(check.place("remeshed", "gradient"),
                     "gradient = \"normalised\" needs the kernel of the paper",
                     "write kernel = \"quartic_spline\" in [discretisation], or gradient = "
                     "\"moment_matrix\"");
}

void check(const Check& check) {
  check_gradient(check);
  check_precision(check);
  check_contact_steps(check);
  check_tractions(check);
  check_walls_that_turn(check);
  refuse_tables(check, {"cut"});
  refuse_prony_shear(check);
  refuse_measurements(check, Measurer<double, 2>::is_measured);
}

// Contact between bodies needs shorter steps, as measured.
StepLimits limits_of_steps(const Case& a_case) {
  StepLimits limits = step_limits(a_case, a_case.contacts.empty() ? 1 : 0.5);
  limits.mass_scaling = parameters_of(a_case).mass_scaling;
  return limits;
}

bool has_loads(const Case& a_case) {
  return Gravity<3>(a_case).acts() ||
         std::ranges::any_of(a_case.boundaries, [](const BoundaryCase& boundary) {
           return !row_of(boundary.kind).is_wall;
         });
}

/// Whether a no-slip wall moves, and another one may hold the same body.
bool walls_deform_bodies(const Case& a_case) {
  const auto held = std::ranges::count_if(a_case.boundaries, [](const BoundaryCase& boundary) {
    return boundary.kind == BoundaryCase::Kind::fixed ||
           boundary.kind == BoundaryCase::Kind::moving_wall;
  });
  return held > 1 && has_boundary(a_case, BoundaryCase::Kind::moving_wall);
}

// Measured for stacks of two bodies, docs/decisions/0058. Walls that move may press bodies
// together.
void warn_of_resting_bodies(const Case& a_case, std::vector<std::string>& warnings) {
  const bool has_pistons = std::ranges::any_of(a_case.boundaries, [](const BoundaryCase& boundary) {
    return boundary.displacement || boundary.kind == BoundaryCase::Kind::moving_wall;
  });
  const auto may_open = [](const ContactCase& contact) { return contact.law != ContactLaw::tied; };
  if (std::ranges::none_of(a_case.contacts, may_open)) return;
  if (!has_loads(a_case) && !has_pistons) return;
  warnings.emplace_back(
      a_case.discretisation.damping
          ? "if bodies rest on each other or are pressed together, the run may stop unless "
            "discretisation.damping = \"adaptive\"; take method = \"total_lagrangian\" for bodies "
            "that stay in contact"
          : "if bodies rest on each other, the lower one passes on up to 6 % too little of their "
            "weight, and where walls press bodies together the run may stop; take method = "
            "\"total_lagrangian\" for bodies that stay in contact");
}

// Measured for plates, rings, discs and blocks under pistons with the defaults; bodies that only
// rotate have smaller errors.
constexpr ThinBodyError errors_of_thin_bodies[] = {
    {4.5, "figures deviate by 10 to 60 %"},
    {6.5, "figures deviate by 2 to 30 %"},
    {8, "oscillations and collisions deviate by up to 20 %"}};

// Measured for blocks and cantilevers, docs/decisions/0077.
constexpr ThinBodyError error_under_tractions = {
    11, "faces under tractions move up to 8 % too far, their edges up to 20 % too little"};

// Measured for discs between slip walls with a traction on a part of their surface.
constexpr ThinBodyError errors_of_round_bodies_under_tractions[] = {
    {17.5, "under tractions on its round parts, displacements deviate by up to 40 %"},
    {26, "under tractions on its round parts, displacements deviate by up to 10 %"}};

// Measured for blocks and bars between two walls, docs/decisions/0031.
constexpr ThinBodyError error_between_walls = {
    14, "walls that shear or bend it meet up to 8 % too little force"};

// Measured for discs and balls held by a cap, and for trapezoids, docs/decisions/0091.
constexpr ThinBodyError errors_over_clamps[] = {
    {10.5, "it overhangs a wall that holds it, and displacements deviate by up to a factor of 2.2"},
    {17, "displacements deviate by up to 25 %, as it overhangs a wall that holds it"},
    {50, "displacements deviate by up to 10 %, as it overhangs a wall that holds it"}};

// Measured for discs between slip walls, docs/decisions/0078.
constexpr ThinBodyError errors_over_slip_walls[] = {
    {15, "it leans over a wall along which it slides, and moves there by up to 45 % too little"},
    {33, "it leans over a wall along which it slides, and moves there by up to 20 % too little"}};

// Measured for cantilevers, docs/decisions/0068.
constexpr double error_of_slender_bodies = 0.0115;

// Measured for discs and balls that are held at their core, docs/decisions/0031.
constexpr RoundWallError error_at_round_walls = {.cylinder = 6, .ball = 13};

// Measured for L-shaped bodies, docs/decisions/0069.
constexpr std::string_view error_at_reentrant_corners =
    "loads bend it there up to 15 % too far, large ones also up to 25 % too little, and vibrations "
    "gain or lose energy there";

// Measured for holes in plates and for cavities, docs/decisions/0082.
constexpr ThinBodyError errors_around_hollows[] = {
    {5.5, "its edge moves up to 40 % too far, and stresses there are up to 37 % too small"},
    {7, "its edge moves up to 20 % too far, and stresses there are up to 20 % too small"},
    {10, "its edge moves up to 10 % too far, and stresses there are up to 15 % too small"},
    {13, "stresses at its edge are up to 8 % too small"}};

// Measured for slots in blocks, docs/decisions/0090.
constexpr ThinBodyError errors_at_gaps[] = {
    {2.7, "it may act as if it were closed, or the run may stop"},
    {3.5, "displacements beside it deviate by up to 10 %"}};

// Measured for fins of blocks, docs/decisions/0090.
constexpr ThinBodyError errors_of_thin_parts[] = {
    {2.7, "it bends several times too far, or the run stops"},
    {4.5, "it bends up to 35 % too far or too little"}};

// Measured for turned cubes, docs/decisions/0083.
constexpr std::string_view error_at_inclined_edges =
    "there displacements deviate by up to 28 % and stresses by up to 21 % of the largest ones in "
    "this method";

// Measured for blocks, docs/decisions/0079.
constexpr std::string_view error_of_tools =
    "in this method its force is 5 to 90 % too small, most for small tools; use method = "
    "\"total_lagrangian\" or \"point_based\"";

void warn_of_thin_walls(const Case& a_case, std::vector<std::string>& warnings) {
  for (const BoundaryCase& boundary : a_case.boundaries) {
    if (!is_too_thin(a_case, boundary)) continue;
    warnings.push_back(fmt::format(
        "the wall `{}` is less than {:.2g} spacings thick, and there are bodies on both sides of "
        "it: they may pass through it; make it thicker or use a finer spacing",
        boundary.name, ghost_band));
  }
}

void warn(const Case& a_case, std::vector<std::string>& warnings) {
  std::vector<ThinBodyError> errors(std::begin(errors_of_thin_bodies),
                                    std::end(errors_of_thin_bodies));
  if (has_boundary(a_case, BoundaryCase::Kind::traction)) errors.push_back(error_under_tractions);
  if (walls_deform_bodies(a_case)) errors.push_back(error_between_walls);
  warn_of_thin_bodies(a_case, errors, warnings);
  if (has_boundary(a_case, BoundaryCase::Kind::traction)) {
    warn_of_thin_bodies(a_case, errors_of_round_bodies_under_tractions, warnings,
                        [](const BodyCase& body) { return has_round_part(body.geometry); });
  }
  warn_of_thin_bodies(a_case, errors_over_slip_walls, warnings,
                      [&](const BodyCase& body) { return overhangs_a_slip_wall(a_case, body); });
  if (has_loads(a_case)) warn_of_slender_bodies(a_case, error_of_slender_bodies, warnings);
  warn_of_reentrant_corners(a_case, error_at_reentrant_corners, warnings);
  warn_of_small_hollows(a_case, errors_around_hollows, warnings);
  warn_of_narrow_gaps(a_case, errors_at_gaps, warnings);
  warn_of_thin_parts(a_case, errors_of_thin_parts, warnings);
  if (a_case.dimension == 3) warn_of_measured_edges(a_case, error_at_inclined_edges, warnings);
  warn_of_resting_bodies(a_case, warnings);
  warn_of_ties(a_case, warnings);
  warn_of_round_walls(a_case, error_at_round_walls, warnings);
  warn_of_thin_walls(a_case, warnings);
  warn_of_overhangs(a_case, errors_over_clamps, warnings);
  warn_of_tools(a_case, error_of_tools, warnings);
  warn_of_short_runs(a_case, warnings);
}

std::string remeshings(const Case& a_case) {
  using Policy = decltype(Case::remeshing)::Policy;
  if (a_case.remeshing.policy == Policy::never) return "never remeshed";
  if (a_case.remeshing.policy == Policy::adaptive) {
    return fmt::format("remeshed at a strain of {} or a deformation of {}",
                       a_case.remeshing.strain_threshold, a_case.remeshing.deformation_threshold);
  }
  return fmt::format("remeshed every {} steps", a_case.remeshing.every);
}

std::string summary(const Case& a_case) {
  const double scaling = parameters_of(a_case).mass_scaling;
  return scaling == 1 ? remeshings(a_case)
                      : fmt::format("the mass times {}, {}", scaling, remeshings(a_case));
}

}  // namespace

RegisteredMethod method() {
  return {
      {.word = "remeshed",
       .meaning = "Lagrangian particles that are remeshed; a level set follows the free surface",
       .check = check,
       .keys = visit_keys,
       .step_limits = limits_of_steps,
       .summary = summary,
       .warn = warn,
       .footprint = footprint,
       .remeshes = true,
       .shows_states_within_steps = true},
      make_solver<Solver>};
}

}  // namespace pliant::remeshed
