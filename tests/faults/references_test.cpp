#include "tests/faults/fault.hpp"

namespace pliant::tests {
namespace {

const Fault faults[] = {
    {"a_period_that_is_no_multiple_of_the_spacing",
     extended("[periodic]\naxes = [\"y\"]\nlower = [0, 0]\nupper = [0, 2.05]\n"),
     "block.toml:3: the period 2.05 along y is not a multiple of the spacing 0.1; use spacing = "
     "0.1025"},
    {"a_body_beyond_the_periodic_cell",
     extended("[periodic]\naxes = [\"x\"]\nlower = [0, 0]\nupper = [0.5, 1]\n"),
     "block.toml:8: body \"block\" extends beyond the periodic cell along x; limit it to the cell, "
     "or make it infinite along this axis"},
    {"a_periodic_axis_that_does_not_exist",
     extended("[periodic]\naxes = [\"z\"]\nlower = [0, 0]\nupper = [1, 1]\n"),
     R"(block.toml:11: axes is "z", which does not exist in 2D; use "x" or "y")"},
    {"a_periodic_cell_without_end",
     extended("[periodic]\naxes = [\"x\"]\nlower = [0, 0]\nupper = [inf, 1]\n"),
     "block.toml:13: the periodic cell goes from 0 to inf along x; give finite corners, lower "
     "below upper"},
    {"a_measurement_of_an_unknown_body", measuring("kind = \"mass\"\nbody = \"blok\"\n"),
     "block.toml:13: body names the body \"blok\", which does not exist; did you mean `block`?"},
    {"a_measurement_of_an_unknown_measurement", measuring("kind = \"period\"\nof = \"tip\"\n"),
     "block.toml:13: of names the measurement \"tip\", which does not exist; there are m"},
    {"a_measurement_of_itself", measuring("kind = \"period\"\nof = \"m\"\n"),
     R"(block.toml:13: measurement "m" evaluates "m", which itself evaluates another )"
     "measurement; name a measurement that does not evaluate another one"},
    {"a_displacement_of_a_point_outside_the_body",
     measuring("kind = \"point_displacement\"\npoint = [3, 1]\naxis = \"x\"\n"),
     "block.toml:13: the point of measurement \"m\" lies 2 m outside body \"block\" at t = 0; give "
     "a "
     "point inside the body or on its surface"},
    {"a_measurement_of_an_unknown_field",
     measuring("kind = \"point_value\"\npoint = [0, 0]\nfield = \"presure\"\n"),
     "block.toml:14: field names the field \"presure\", which does not exist; did you mean "
     "`pressure`?"},
    {"a_field_of_three_dimensions",
     measuring("kind = \"point_value\"\npoint = [0, 0]\nfield = \"velocity_z\"\n"),
     "block.toml:14: field names the field \"velocity_z\", which does not exist; did you mean "
     "`velocity_x`?"},
    {"a_force_on_an_unknown_wall",
     measuring("kind = \"wall_force\"\nboundary = \"floor\"\naxis = \"y\"\n"),
     "block.toml:13: boundary names the boundary \"floor\", which does not exist; add a "
     "[[boundary]] of that name"},
    {"a_force_on_a_load",
     measuring(
         "kind = \"wall_force\"\nboundary = \"floor\"\n[[boundary]]\nname = \"floor\"\n"
         "kind = \"pressure\"\npressure = 1\ngeometry = { shape = \"half_space\", point = [0, "
         "0], normal = [0, 1] }\n"),
     "block.toml:13: boundary \"floor\" is not a wall, so that its force is the load that the case "
     "gives; name a wall"},
    {"a_sum_of_different_units",
     measuring("kind = \"weighted_sum\"\nterms = [\"a\", \"b\"]\n[[measurement]]\nname = \"a\"\n"
               "kind = \"mass\"\n[[measurement]]\nname = \"b\"\nkind = \"volume\"\n"),
     "block.toml:13: measurement \"m\" adds different units, kg/m and m^2; name measurements of "
     "one "
     "unit"},
    {"a_sum_with_too_few_factors",
     measuring(
         "kind = \"weighted_sum\"\nterms = [\"a\"]\nfactors = [1, 2]\n[[measurement]]\nname = "
         "\"a\"\nkind = \"mass\"\n"),
     "block.toml:14: measurement \"m\" has 1 terms and 2 factors; give one factor for each term"},
    {"a_value_after_the_end",
     measuring("kind = \"value_at_time\"\nof = \"a\"\ntime = 2\n[[measurement]]\nname = \"a\"\n"
               "kind = \"mass\"\n"),
     "block.toml:14: measurement \"m\" is of t = 2, after the end of the run; give a time up to "
     "time.end"},
    {"a_wall_without_a_motion",
     extended("[[boundary]]\nname = \"piston\"\nkind = \"moving_wall\"\ngeometry = { shape = "
              "\"half_space\", point = [0, 0], normal = [0, 1] }\n"),
     "block.toml:12: wall \"piston\" has no motion; give its velocity, as in velocity = [0, -25], "
     "its displacement, or its rotation"},
    {"a_wall_with_two_motions",
     extended("[[boundary]]\nname = \"piston\"\nkind = \"moving_wall\"\nvelocity = [0, "
              "1]\ndisplacement = [0, \"t\"]\ngeometry = { shape = \"half_space\", point = [0, 0], "
              "normal = [0, 1] }\n"),
     "block.toml:14: wall \"piston\" has both velocity and displacement; keep one of them"},
    {"contact_without_remeshing",
     extended("[remeshing]\nevery = \"never\"\n[[boundary]]\nname = \"floor\"\nkind = "
              "\"contact_wall\"\ngeometry = { shape = \"half_space\", point = [0, 0], normal = [0, "
              "1] }\n"),
     "block.toml:11: contact walls need remeshings; write every = \"adaptive\""},
    {"an_unknown_kind_of_measurement", measuring("kind = \"momentun\"\n"),
     R"(block.toml:12: kind must be one of "extent", "surface_distance", "mean_radius", )"
     R"("point_displacement", "point_value", "material_value", "mean_value", "mass", )"
     R"("centre_of_mass", "momentum", "angular_momentum", )"
     R"("kinetic_energy", "strain_energy", "total_energy", "energy_ratio", "wall_force", "wall_moment", )"
     R"("contact_force", "blade_force", "cutting_work", "volume", )"
     R"("surface_area", "connected_parts", "largest_part_volume", )"
     R"("minimum_particle_distance", "velocity_error", "period", )"
     R"("amplitude_ratio", "peak_moving_average", "last_time_above", "smallest", "largest", "value_at_time", "weighted_sum", got "momentun"; did you mean "momentum"?)"},
    {"a_key_of_another_measurement", measuring("kind = \"mass\"\naxis = \"x\"\n"),
     "block.toml:13: unknown key `axis` in [[measurement]]; with kind = \"mass\" its keys are "
     "name, "
     "kind, body, relative"},
    {"an_error_without_amplitude", measuring("kind = \"velocity_error\"\nexact = [0, 0]\n"),
     "block.toml:10: [[measurement]] lacks `reference`, amplitude by which the error is divided; "
     "add reference = 0.01"},
    {"too_few_directions", measuring("kind = \"mean_radius\"\npoint = [0, 0]\ndirections = 3\n"),
     "block.toml:14: directions must be from 8 to 65536, got 3; write it as in directions = 64"},
    {"two_bodies_of_one_name",
     extended("[[body]]\nname = \"block\"\ngeometry = { shape = \"disc\", centre = [0, 0], radius "
              "= 1 }\nmaterial = { model = \"linear\", youngs_modulus = 1, poissons_ratio = 0, "
              "density = 1 }\n"),
     "block.toml:11: two [[body]] tables have the name \"block\"; give each a different name"},
    {"no_body_at_all", "body = []\n[discretisation]\nspacing = 1\n[time]\nend = 1\n",
     "block.toml:1: the case has no body; add [[body]] with name, geometry and material"},
    {"a_fault_in_a_shared_material_is_told_once",
     broken(material, "\"soft\"") +
         "[[body]]\nname = \"other\"\ngeometry = { shape = \"disc\", centre = [5, 0], radius = 1 "
         "}\n"
         "material = \"soft\"\n[material.soft]\nmodel = \"linear\"\nyoungs_modulus = 0\n"
         "poissons_ratio = 0\ndensity = 1\n",
     "block.toml:16: youngs_modulus must be positive, got 0; write it as in youngs_modulus = 100"},
    {"everything_wrong_is_said_at_once",
     with(with(block_case, "spacing = 0.1", "spacing = -1"), "youngs_modulus = 100",
          "youngs_modulus = 0"),
     "block.toml:3: spacing must be positive, got -1; write it as in spacing = 0.03125\n"
     "block.toml:9: youngs_modulus must be positive, got 0; write it as in youngs_modulus = 100"},
};

class FaultyReferences : public testing::TestWithParam<Fault> {};

TEST_P(FaultyReferences, are_answered_with_where_what_and_what_to_do) {
  EXPECT_EQ(complaint(GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(faults, FaultyReferences, testing::ValuesIn(faults), name_of);

}  // namespace
}  // namespace pliant::tests
