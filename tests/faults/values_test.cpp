#include "tests/faults/fault.hpp"

namespace pliant::tests {
namespace {

const std::string rubber_block = R"(title = "a block"
method = "total_lagrangian"
[discretisation]
spacing = 0.1
[time]
end = 1
[[body]]
name = "block"
geometry = { shape = "box", lower = [0, 0], upper = [1, 2] }
material = { model = "reduced_polynomial", coefficients = [10], compressibility = 0.1, density = 2 }
[total_lagrangian]
damping = 1
)";

/// A reduced polynomial with a Prony series of the given keys.
std::string viscous(const std::string& keys) {
  return "{ model = \"reduced_polynomial\", coefficients = [1], compressibility = 0.1, density = "
         "1, "
         "prony = { " +
         keys + " } }";
}

const Fault faults[] = {
    {"a_number_that_is_text", broken("spacing = 0.1", "spacing = \"fine\""),
     "block.toml:3: spacing must be a number, found the text \"fine\": unknown name `fine` at "
     "position 1; write it as in spacing = 0.03125"},
    {"a_number_that_depends_on_place", broken("spacing = 0.1", "spacing = \"x/10\""),
     "block.toml:3: spacing must be a number, found the text \"x/10\", which is not constant; "
     "write it as in spacing = 0.03125"},
    {"a_number_that_is_a_flag", broken("end = 1", "end = true"),
     "block.toml:5: end must be a number, found true; write it as in end = 0.02"},
    {"a_flag_that_is_a_number", extended("[output]\nghosts = 1\n"),
     "block.toml:11: ghosts must be true or false, found 1; write it as in ghosts = false"},
    {"a_spacing_that_single_precision_does_not_hold", R"(dimension = 3
precision = "single"
discretisation = { spacing = 1e-7 }
time = { end = 1 }
[[body]]
name = "cell"
geometry = { shape = "ball", centre = [0, 0, 0], radius = 1e-6 }
material = { model = "linear", youngs_modulus = 100, poissons_ratio = 0.3, density = 2 }
)",
     "block.toml:2: single precision cannot hold the sixth power of a spacing of 1e-07 m; write "
     "precision = \"double\", or give lengths in millimetres"},
    {"a_title_that_is_a_number", broken("\"a block\"", "7"),
     "block.toml:1: title must be a text, found 7; write it as in title = \"A case\""},
    {"a_whole_number_with_a_fraction", extended("[level_set]\nreinitialise_every = 2.5\n"),
     "block.toml:11: reinitialise_every must be a whole number, got 2.5; write it as in "
     "reinitialise_every = 20"},
    {"a_geometry_that_is_a_text", broken(geometry, "\"box\""),
     "block.toml:8: geometry must be a table, found the text \"box\"; write it as in geometry = { "
     "shape = \"box\", lower = [0, 0], upper = [1, 1] }"},
    {"a_name_with_a_dot", broken("\"block\"", "\"my.block\""),
     "block.toml:7: name must consist of letters, digits, _ and -, got \"my.block\"; write it as "
     "in "
     "name = \"block\""},
    {"a_negative_modulus", broken("youngs_modulus = 100", "youngs_modulus = -5"),
     "block.toml:9: youngs_modulus must be positive, got -5; write it as in youngs_modulus = 100"},
    {"an_incompressible_material", broken("poissons_ratio = 0.3", "poissons_ratio = 0.5"),
     "block.toml:9: poissons_ratio must be above -1 and below 0.5, got 0.5; 0.49 is nearly "
     "incompressible"},
    {"a_material_without_mass", broken("density = 2", "density = 0"),
     "block.toml:9: density must be positive, got 0; write it as in density = 1000"},
    {"a_spacing_of_zero", broken("spacing = 0.1", "spacing = 0"),
     "block.toml:3: spacing must be positive, got 0; write it as in spacing = 0.03125"},
    {"an_infinite_end", broken("end = 1", "end = inf"),
     "block.toml:5: end must be finite, got inf; write it as in end = 0.02"},
    {"a_negative_output_interval", extended("[output]\nevery = -0.1\n"),
     "block.toml:11: every must be 0 or more, got -0.1; write it as in every = 0.001"},
    {"an_unstable_cfl_number", broken("end = 1", "end = 1\ncfl = 3"),
     "block.toml:6: cfl must be above 0 and at most 2, got 3; write it as in cfl = 0.5"},
    {"a_step_word_other_than_cfl", broken("end = 1", "end = 1\nstep = \"auto\""),
     R"(block.toml:6: step must be a number or "cfl", found the text "auto"; write step = )"
     "\"cfl\", or a time step as in step = 5e-5"},
    {"a_step_longer_than_the_run", broken("end = 1", "end = 1\nstep = 2"),
     "block.toml:6: step 2 is longer than the run, which ends at 1; use a smaller step, or "
     "\"cfl\""},
    {"a_remeshing_word", extended("[remeshing]\nevery = \"often\"\n"),
     R"(block.toml:11: every must be a number of steps, "adaptive" or "never", found the text )"
     "\"often\"; write it as in every = 10"},
    {"a_remeshing_interval_of_zero", extended("[remeshing]\nevery = 0\n"),
     "block.toml:11: every must be 1 or more, got 0; write it as in every = 10"},
    {"a_gradient_without_its_kernel", extended("[remeshed]\ngradient = \"normalised\"\n"),
     "block.toml:11: gradient = \"normalised\" needs the kernel of the paper; write kernel = "
     "\"quartic_spline\" in [discretisation], or gradient = \"moment_matrix\""},
    {"a_dimension_of_one", broken("title = \"a block\"", "dimension = 1"),
     "block.toml:1: dimension must be 2 or 3, got 1; write it as in dimension = 2"},
    {"an_unknown_method", broken("title = \"a block\"", "method = \"peridynamics\""),
     R"(block.toml:1: method must be one of "remeshed", "total_lagrangian", "point_based", "finite_elements", "sph", got )"
     "\"peridynamics\"; use one of these"},
    {"remeshing_of_what_is_not_remeshed",
     with(rubber_block, "[total_lagrangian]\n", "[remeshing]\nevery = 3\n[total_lagrangian]\n"),
     "block.toml:11: method \"total_lagrangian\" has no [remeshing]; leave the table out, or "
     "choose "
     "another method"},
    {"total_lagrangian_keys_of_the_remeshed_method", extended("[total_lagrangian]\ndamping = 1\n"),
     "block.toml:10: method \"remeshed\" has no [total_lagrangian]; leave the table out, or choose "
     "another method"},
    {"mass_scaled_to_no_step",
     with(rubber_block, "damping = 1", "mass_scaling = \"match_time_step\""),
     "block.toml:12: the mass can only be scaled to a given time step; give time.step in seconds, "
     "or "
     "mass_scaling as a number"},
    {"a_damping_word", with(rubber_block, "damping = 1", "damping = \"much\""),
     "block.toml:12: damping must be a number or \"adaptive\", found the text \"much\"; write "
     "damping = \"adaptive\", or a rate as in damping = 0.5"},
    {"lighter_mass", with(rubber_block, "damping = 1", "mass_scaling = 0.5"),
     "block.toml:12: mass_scaling must be 1 or more, got 0.5; write it as in mass_scaling = 1e4"},
    {"parts_of_a_body_that_cannot_be_cut",
     rubber_block + "[[measurement]]\nname = \"p\"\nkind = \"connected_parts\"\n",
     "block.toml:15: method \"total_lagrangian\" does not measure \"connected_parts\"; measure one "
     "of extent, surface_distance, mean_radius, point_displacement, point_value, material_value, "
     "mean_value, mass, centre_of_mass, momentum, angular_momentum, kinetic_energy, strain_energy, "
     "total_energy, energy_ratio, wall_force, wall_moment, contact_force, volume, surface_area, "
     "velocity_error, "
     "or choose "
     "another method"},
    {"a_negative_friction_coefficient",
     rubber_block + "[[boundary]]\nname = \"w\"\nkind = \"contact_wall\"\nfriction = -0.3\n"
                    "geometry = { shape = \"half_space\", point = [0, -1], normal = [0, 1] }\n",
     "block.toml:16: friction must be 0 or more, got -0.3; give a coefficient, as in friction = "
     "0.3"},
    {"friction_of_no_law",
     rubber_block + "[[boundary]]\nname = \"w\"\nkind = \"contact_wall\"\nfriction = \"rough\"\n"
                    "geometry = { shape = \"half_space\", point = [0, -1], normal = [0, 1] }\n",
     "block.toml:16: friction must be one of \"frictionless\", \"no_slip\", or a coefficient, got "
     "\"rough\"; use one of these"},
    {"a_misspelt_kernel", broken("spacing = 0.1", "spacing = 0.1\nkernel = \"compct\""),
     R"(block.toml:4: kernel must be one of "quartic_spline", "quartic_spline_fit", "compact", )"
     R"("fourth_order", got "compct"; did you mean "compact"?)"},
    {"the_beginning_of_a_kernel", broken("spacing = 0.1", "spacing = 0.1\nkernel = \"quartic\""),
     R"(block.toml:4: kernel must be one of "quartic_spline", "quartic_spline_fit", "compact", )"
     R"("fourth_order", got "quartic"; did you mean "quartic_spline"?)"},
    {"a_key_of_an_earlier_version", broken("spacing = 0.1", "spacing = 0.1\nweight = \"compact\""),
     "block.toml:4: unknown key `weight` in [discretisation]; its keys are spacing, damping, "
     "kernel, dissipation"},
    {"a_negative_dissipation_of_the_stress",
     broken("spacing = 0.1", "spacing = 0.1\ndissipation = { stress = -1 }"),
     "block.toml:4: stress must be from 0 to 2, got -1; write it as in stress = 0.025"},
    {"a_dissipation_that_is_a_word",
     broken("spacing = 0.1", "spacing = 0.1\ndissipation = \"weak\""),
     "block.toml:4: dissipation must be a number, found the text \"weak\": unknown name `weak` at "
     "position 1; write it as in dissipation = { velocity = 0.5, stress = 0.025 }"},
    {"an_unknown_kernel", broken("spacing = 0.1", "spacing = 0.1\nkernel = \"gauss\""),
     R"(block.toml:4: kernel must be one of "quartic_spline", "quartic_spline_fit", "compact", )"
     R"("fourth_order", got "gauss"; use one of these)"},
    {"too_many_coefficients",
     broken(material,
            "{ model = \"reduced_polynomial\", coefficients = [1, 2, 3, 4, 5, 6], compressibility "
            "= 0.1, density = 1 }"),
     "block.toml:9: coefficients has 6 numbers, but must have one to five; give C_10 up to at "
     "most C_50"},
    {"a_negative_first_coefficient",
     broken(material,
            "{ model = \"reduced_polynomial\", coefficients = [-1], compressibility = 0.1, density "
            "= 1 }"),
     "block.toml:9: coefficients must start with a positive C_10, got -1; the shear modulus is 2 "
     "C_10"},
    {"sph_that_remeshes",
     with(extended("[remeshing]\nevery = 3\n"), "title = \"a block\"", "method = \"sph\""),
     "block.toml:10: method \"sph\" has no [remeshing]; leave the table out, or choose another "
     "method"},
    {"sph_with_a_level_set",
     with(measuring("kind = \"surface_area\"\n") + "[output]\nsurface = true\n",
          "title = \"a block\"", "method = \"sph\""),
     "block.toml:12: method \"sph\" does not measure \"surface_area\"; measure one of "
     "point_displacement, material_value, mean_value, mass, centre_of_mass, momentum, "
     "angular_momentum, kinetic_energy, strain_energy, total_energy, energy_ratio, wall_force, "
     "wall_moment, contact_force, volume, minimum_particle_distance, "
     "velocity_error, or choose another method\n"
     "block.toml:14: surfaces need a level set, which method \"sph\" does not have; write surface "
     "= "
     "false"},
    {"sph_between_walls",
     with(extended("[[boundary]]\nname = \"floor\"\nkind = \"fixed\"\ngeometry = { shape = "
                   "\"half_space\", point = [0, 0], normal = [0, 1] }\n"),
          "title = \"a block\"", "method = \"sph\""),
     "block.toml:12: method \"sph\" has free surfaces and periodic cells only; remove the "
     "boundaries, or write method = \"remeshed\""},
    {"sph_keys_of_the_remeshed_method", extended("[sph]\nartificial_stress = 0\n"),
     "block.toml:10: method \"remeshed\" has no [sph]; leave the table out, or choose another "
     "method"},
    {"a_prony_term_without_time", broken(material, viscous("ratios = [0.1, 0.2], times = [1]")),
     "block.toml:9: prony has 2 ratios and 1 times; give one ratio and one time for each term"},
    {"prony_ratios_that_leave_nothing",
     broken(material, viscous("ratios = [0.5, 0.6], times = [1, 2]")),
     "block.toml:9: prony has ratios whose sum is 1.1, so that no modulus remains after "
     "relaxation; their sum must be below 1"},
    {"a_negative_prony_ratio", broken(material, viscous("ratios = [-0.5], times = [1]")),
     "block.toml:9: ratios must be above 0 and below 1, got -0.5; write it as in ratios = [0.3, "
     "0.2]"},
    {"a_relaxation_time_of_zero", broken(material, viscous("ratios = [0.5], times = [0]")),
     "block.toml:9: times must be positive, got 0; write it as in times = [0.1, 1]"},
    {"a_prony_series_without_terms", broken(material, viscous("ratios = [], times = []")),
     "block.toml:9: ratios is empty, but must contain a number; write it as in ratios = [0.3, "
     "0.2]\n"
     "block.toml:9: times is empty, but must contain a number; write it as in times = [0.1, 1]"},
    {"an_unknown_kind_of_moduli",
     broken(material, viscous("ratios = [0.5], times = [1], moduli = \"long\"")),
     R"(block.toml:9: moduli must be one of "long_term", "instantaneous", got "long"; did you mean )"
     "\"long_term\"?"},
    {"a_prony_series_of_a_linear_material",
     broken("density = 2", "density = 2, prony = { ratios = [0.5], times = [1] }"),
     "block.toml:9: unknown key `prony` in material; with model = \"linear\" its keys are model, "
     "density, equation_of_state, youngs_modulus, poissons_ratio"},
    {"a_stretch_of_a_linear_material", extended("stretch = [1, 0.9]\n"),
     "block.toml:10: body \"block\" has an initial stretch, but its linear material has no "
     R"(undeformed reference shape; use model = "reduced_polynomial", "neo_hookean" or )"
     R"("st_venant_kirchhoff")"},
    {"a_stretch_of_zero", extended("stretch = [1, 0]\n"),
     "block.toml:10: stretch must be positive, got 0; write it as in stretch = [1, 0.95]"},
    {"an_unknown_model", broken("model = \"linear\"", "model = \"neo_hooke\""),
     R"(block.toml:9: model must be one of "linear", "reduced_polynomial", "neo_hookean", )"
     R"("st_venant_kirchhoff", got "neo_hooke"; did you mean "neo_hookean"?)"},
    {"a_material_that_is_not_defined", broken(material, "\"rubber\""),
     "block.toml:9: material names the material \"rubber\", which does not exist; add a table "
     "[material.rubber]"},
    {"a_misspelt_material_name",
     extended("[[body]]\nname = \"other\"\ngeometry = { shape = \"disc\", centre = [0, 0], radius "
              "= 1 }\nmaterial = \"tisue\"\n[material.tissue]\nmodel = \"linear\"\nyoungs_modulus "
              "= 1\npoissons_ratio = 0\ndensity = 1\n"),
     "block.toml:13: material names the material \"tisue\", which does not exist; did you mean "
     "\"tissue\"?"},
};

class FaultyValues : public testing::TestWithParam<Fault> {};

TEST_P(FaultyValues, are_answered_with_where_what_and_what_to_do) {
  EXPECT_EQ(complaint(GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(faults, FaultyValues, testing::ValuesIn(faults), name_of);

}  // namespace
}  // namespace pliant::tests
