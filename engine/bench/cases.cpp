#include "engine/bench/cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/bench/case_texts.hpp"
#include "engine/case/reading/read_case.hpp"
#include "engine/case/vocabulary/words.hpp"
#include "engine/simulation/methods.hpp"

namespace pliant::bench {

namespace {

using Settings = std::vector<std::string>;

// Fixed settings for rates of all versions, independent of the defaults.
const Settings as_ever = {"time.cfl=0.5", "time.strain=1", "discretisation.dissipation=0.25",
                          "remeshing.filter=0.2", "remeshing.deformation_threshold=1"};

Case read(std::string_view text, const char* name, double spacing, kernels::Kernel kernel,
          const Settings& more) {
  Settings settings = {fmt::format("discretisation.spacing={:.17g}", spacing),
                       fmt::format("discretisation.kernel={}",
                                   words<kernels::Kernel>[static_cast<int>(kernel)].text),
                       "time.step=cfl", "measurement=[]", "output={}"};
  settings.insert(settings.end(), as_ever.begin(), as_ever.end());
  settings.insert(settings.end(), more.begin(), more.end());
  Case a_case = parse_case(std::string(text), "case.toml", settings, methods().rules());
  a_case.name = name;
  return a_case;
}

// No sample may end before its steps are done.
const Settings spinning = {"time.end=1000", "remeshing.every=10"};

constexpr std::string_view elastic_block_text = R"(method = "total_lagrangian"
[time]
end = 1000
step = "cfl"
cfl = 0.5
[[body]]
name = "block"
material = { model = "neo_hookean", youngs_modulus = 1e5, poissons_ratio = 0.4, density = 1000 }
)";

}  // namespace

Case rotating_cylinder(std::int64_t particles, kernels::Kernel kernel) {
  const double spacing = std::sqrt(std::numbers::pi / static_cast<double>(particles));
  return read(rotating_cylinder_text, "rotating_cylinder", spacing, kernel, spinning);
}

Case spinning_ball(std::int64_t particles, kernels::Kernel kernel) {
  const double spacing = std::cbrt(4 * std::numbers::pi / 3 / static_cast<double>(particles));
  Settings settings = spinning;
  settings.insert(
      settings.end(),
      {"dimension=3", "body.0.geometry={ shape = \"ball\", centre = [0, 0, 0], radius = 1 }",
       "body.0.rotation={ centre = [0, 0, 0], angular_velocity = [0, 0, \"2*pi\"] }",
       "body.0.name=ball"});
  return read(rotating_cylinder_text, "spinning_ball", spacing, kernel, settings);
}

Case compression(int n, kernels::Kernel kernel) {
  return read(compression_hyperelastic_text, "compression_hyperelastic", 1.0 / n, kernel, {});
}

Case point_block(std::int64_t nodes, Precision precision) {
  constexpr double volume = 0.08 * 0.06 * 0.03;
  const std::string spacing =
      fmt::format("discretisation.spacing={:.17g}", std::cbrt(volume / static_cast<double>(nodes)));
  const Settings settings = {spacing,         fmt::format("precision={}", text_of(precision)),
                             "time.end=1000", "time.step=cfl",
                             "cut=[]",        "measurement=[]",
                             "output={}"};
  Case a_case = parse_case(std::string(block_cut_text), "case.toml", settings, methods().rules());
  a_case.name = "point_block";
  return a_case;
}

Case elastic_block(int dimension, std::int64_t particles, Precision precision,
                   std::string_view method) {
  const double to_a_side = std::round(std::pow(particles, 1.0 / dimension));
  const bool plane = dimension == 2;
  const Settings settings = {
      fmt::format("dimension={}", dimension),
      fmt::format("method={}", method),
      fmt::format("precision={}", text_of(precision)),
      fmt::format("discretisation.spacing={:.17g}", 1 / (to_a_side - 1)),
      fmt::format("body.0.geometry={{ shape = \"box\", lower = {}, upper = {} }}",
                  plane ? "[0, 0]" : "[0, 0, 0]", plane ? "[1, 1]" : "[1, 1, 1]"),
      fmt::format("body.0.velocity=[\"0.5*sin(3*y)\", \"0.5*x\"{}]",
                  plane ? "" : ", \"0.5*cos(3*y)\"")};
  Case a_case =
      parse_case(std::string(elastic_block_text), "case.toml", settings, methods().rules());
  const std::string_view kind = method == "point_based" ? "point_based_block" : "elastic_block";
  a_case.name = fmt::format("{}_{}d", kind, dimension);
  return a_case;
}

}  // namespace pliant::bench
