#include "engine/remeshed/setup/initial_state.hpp"

#include <gtest/gtest.h>

#include <pliant/error.hpp>

#include "kernels/law.hpp"
#include "tests/engine/case/written_case.hpp"

namespace pliant::remeshed {
namespace {

using InitialStatePack = xsimd::batch<double, xsimd::sse2>;

constexpr double asked[] = {2, -0.7, 0.4, -3, 0.5, 1};  // xx, xy, xz, yy, yz, zz

BodyCase stressed_body(const std::string& material, int dimension) {
  const std::string solid = dimension == 3 ? ", zz = 1, yz = 0.5, xz = 0.4" : "";
  std::string text = "dimension = " + std::to_string(dimension) + "\n" + tests::block_case;
  if (dimension == 3)
    text = tests::with(text, "[0, 0], upper = [1, 2]", "[0, 0, 0], upper = [1, 2, 1]");
  text = tests::with(
      text, R"({ model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 })",
      material);
  return tests::read_text(text + "stress = { xx = 2, yy = -3, xy = -0.7" + solid + " }\n")
      .bodies.at(0);
}

template <kernels::Model model, int D>
void expect_asked_stress(const BodyCase& body) {
  using L = kernels::Law<model, InitialStatePack, D>;
  const InitialState<D> state = state_under_stress<D>(body, {0.3, 0.4, 0.5});
  InitialStatePack carried[L::components], sigma[L::symmetric];
  for (int c = 0; c < L::components; ++c) carried[c] = InitialStatePack(state.material[c]);
  L::stress(body.material, carried, InitialStatePack(state.density), sigma);
  for (int i = 0; i < D; ++i) {
    for (int j = i; j < D; ++j) {
      EXPECT_NEAR(sigma[kernels::symmetric_index<D>(i, j)].get(0),
                  asked[kernels::symmetric_index<3>(i, j)], 1e-8);
    }
  }
}

TEST(initial_state, has_the_stress_that_the_case_asks_for) {
  const std::string given =
      R"({ model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 })";
  const std::string logarithmic =
      R"({ model = "linear", equation_of_state = "logarithmic", youngs_modulus = 100, )"
      R"(poissons_ratio = 0.3, density = 2 })";
  const std::string polynomial =
      R"({ model = "reduced_polynomial", coefficients = [8, 3], compressibility = 0.02, density = 2 })";
  const auto with_model = [&given](const std::string& model) {
    return tests::with(given, "linear", model);
  };
  using enum kernels::Model;
  expect_asked_stress<kernels::Model::linear, 2>(stressed_body(given, 2));
  expect_asked_stress<kernels::Model::linear, 3>(stressed_body(given, 3));
  expect_asked_stress<linear_logarithmic, 2>(stressed_body(logarithmic, 2));
  expect_asked_stress<linear_logarithmic, 3>(stressed_body(logarithmic, 3));
  expect_asked_stress<reduced_polynomial, 2>(stressed_body(polynomial, 2));
  expect_asked_stress<reduced_polynomial, 3>(stressed_body(polynomial, 3));
  expect_asked_stress<neo_hookean, 2>(stressed_body(with_model("neo_hookean"), 2));
  expect_asked_stress<neo_hookean, 3>(stressed_body(with_model("neo_hookean"), 3));
  expect_asked_stress<st_venant_kirchhoff, 2>(stressed_body(with_model("st_venant_kirchhoff"), 2));
  expect_asked_stress<st_venant_kirchhoff, 3>(stressed_body(with_model("st_venant_kirchhoff"), 3));
}

TEST(initial_state, refuses_a_tension_that_tears_the_material) {
  const BodyCase body =
      tests::read_text(tests::block_case + "stress = { xx = 500, yy = 500 }\n").bodies.at(0);
  EXPECT_THROW(state_under_stress<2>(body, {}), InputError);
}

}  // namespace
}  // namespace pliant::remeshed
