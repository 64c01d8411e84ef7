#pragma once

#include "engine/case/vocabulary/key.hpp"
#include "engine/case/vocabulary/words.hpp"

namespace pliant {

template <class Visitor>
void prony_keys(Visitor& visit, PronyCase& prony) {
  visit("ratios", prony.ratios,
        {.meaning =
             "g_1, g_2, ..., relaxing fractions of the instantaneous modulus; their sum is below 1",
         .example = "[0.3, 0.2]",
         .limits = {0, 1, false, false, "above 0 and below 1"},
         .required = true});
  visit("times", prony.times,
        {.meaning = "tau_1, tau_2, ..., their relaxation times",
         .unit = "s",
         .example = "[0.1, 1]",
         .limits = positive,
         .required = true});
  visit("moduli", prony.moduli,
        {.meaning =
             "modulus to which compressibility (of prony) or coefficients (of prony_shear) refer",
         .example = R"("long_term")"});
}

template <class Visitor>
void material_keys(Visitor& visit, MaterialCase& material) {
  const bool known = visit("model", material.model,
                           {.meaning = "constitutive model",
                            .example = R"("linear")",
                            .required = true,
                            .decides = true});
  visit("density", material.density,
        {.meaning = "density at rest",
         .unit = "kg/m^3",
         .example = "1000",
         .limits = positive,
         .required = true});
  if (!known) return;
  if (material.model == MaterialCase::Model::linear) {
    visit("equation_of_state", material.equation_of_state,
          {.meaning = "pressure as a function of the density", .example = R"("linear")"});
  }
  if (material.model != MaterialCase::Model::reduced_polynomial) {
    visit("youngs_modulus", material.youngs_modulus,
          {.meaning = "Young's modulus E",
           .unit = "Pa",
           .example = "100",
           .limits = positive,
           .required = true});
    visit("poissons_ratio", material.poissons_ratio,
          {.meaning = "Poisson's ratio nu",
           .example = "0.3",
           .limits = {-1, 0.5, false, false, "above -1 and below 0.5"},
           .required = true,
           .remedy = "0.49 is nearly incompressible"});
  } else {
    visit("coefficients", Coefficients{material.coefficients},
          {.meaning = "C_10 (positive), C_20, ..., up to five; the shear modulus is 2 C_10",
           .unit = "Pa",
           .example = "[2.2]",
           .required = true});
    visit("compressibility", material.compressibility,
          {.meaning = "D; the bulk modulus is 2/D",
           .unit = "1/Pa",
           .example = "0.001",
           .limits = positive,
           .required = true});
    visit("prony", material.prony,
          {.meaning =
               "Prony series of the bulk modulus, see prony; without it the material is elastic",
           .example = "{ ratios = [0.3, 0.2], times = [0.1, 1] }"});
    visit("prony_shear", material.prony_shear,
          {.meaning = "Prony series of the shear modulus (TL.24), see prony, for total_lagrangian "
                      "and point_based",
           .example = "{ ratios = [0.5], times = [2] }"});
  }
}

}  // namespace pliant
