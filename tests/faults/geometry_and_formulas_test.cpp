#include "tests/faults/fault.hpp"

namespace pliant::tests {
namespace {

const Fault faults[] = {
    {"three_components_in_two_dimensions", broken("lower = [0, 0]", "lower = [0, 0, 0]"),
     "block.toml:8: lower needs 2 components for dimension = 2, got 3; give [x, y]"},
    {"a_box_inside_out", broken("upper = [1, 2]", "upper = [1, -2]"),
     "block.toml:8: geometry is a box with lower 0 and upper -2 along y; every component of lower "
     "must be less than that of upper"},
    {"an_unknown_shape", broken("shape = \"box\"", "shape = \"square\""),
     R"(block.toml:8: shape must be one of "box", "disc", "ball", "capsule", "cylinder", )"
     R"("half_space", "mesh", "union", "difference", "intersection", got "square"; use one of )"
     "these"},
    {"a_cylinder_in_two_dimensions",
     broken(geometry, "{ shape = \"cylinder\", centre = [0, 0], radius = 1 }"),
     "block.toml:8: shape is a cylinder, which needs dimension = 3; use shape = \"disc\" in 2D"},
    {"a_negative_radius", broken(geometry, "{ shape = \"disc\", centre = [0, 0], radius = -1 }"),
     "block.toml:8: radius must be positive, got -1; write it as in radius = 1"},
    {"a_difference_of_one_part",
     broken(geometry,
            R"({ shape = "difference", of = [{ shape = "disc", centre = [0, 0], radius = 1 }] })"),
     "block.toml:8: of needs two parts or more, got 1; write it as in of = [{ shape = \"box\", ... "
     "}, { shape = \"disc\", ... }]"},
    {"a_union_of_numbers", broken(geometry, "{ shape = \"union\", of = [1, 2] }"),
     "block.toml:8: of must be a table, found 1; write it as in of = [{ shape = \"box\", ... }, { "
     "shape = \"disc\", ... }]\n"
     "block.toml:8: of must be a table, found 2; write it as in of = [{ shape = \"box\", ... }, { "
     "shape = \"disc\", ... }]"},
    {"a_body_without_end", broken("upper = [1, 2]", "upper = [1, inf]"),
     "block.toml:8: body \"block\" is unbounded along y; give finite corners, or intersect it with "
     "a "
     "box"},
    {"a_body_that_holds_nothing",
     broken(geometry,
            R"({ shape = "intersection", of = [{ shape = "disc", centre = [0, 0], radius = 1 }, )"
            "{ shape = \"disc\", centre = [5, 0], radius = 1 }] }"),
     "block.toml:8: body \"block\" is empty; change its geometry so that it contains at least "
     "one point"},
    {"a_spacing_larger_than_the_body", broken("spacing = 0.1", "spacing = 1.5"),
     "block.toml:3: spacing 1.5 is larger than body \"block\", which is 1 wide along x; use "
     "spacing = 0.1 for ten particles across it"},
    {"a_normal_of_zeros",
     extended("[[boundary]]\nname = \"floor\"\nkind = \"fixed\"\ngeometry = { shape = "
              "\"half_space\", point = [0, 0], normal = [0, 0] }\n"),
     "block.toml:13: normal must not be zero; write it as in normal = [0, 1]"},
    {"a_wall_that_moves_by_place",
     extended("[[boundary]]\nname = \"floor\"\nkind = \"moving_wall\"\ngeometry = { shape = "
              "\"half_space\", point = [0, 0], normal = [0, 1] }\nvelocity = [0, \"x\"]\n"),
     "block.toml:14: velocity has the formula \"x\", which uses x; here formulas may use t only"},
    {"a_moving_wall_at_rest",
     extended("[[boundary]]\nname = \"floor\"\nkind = \"moving_wall\"\ngeometry = { shape = "
              "\"half_space\", point = [0, 0], normal = [0, 1] }\n"),
     "block.toml:12: wall \"floor\" has no motion; give its velocity, as in velocity = [0, -25], "
     "its displacement, or its rotation"},
    {"a_formula_with_an_unknown_name", extended("velocity = [0, \"-25*yy\"]\n"),
     "block.toml:10: velocity has the formula \"-25*yy\": unknown name `yy` at position 5; "
     "formulas consist of numbers, x, y, z, pi, + - * / ^, comparisons, ?:, &&, || and functions "
     "such as sin, exp, sqrt, abs, min, max"},
    {"a_formula_that_does_not_close", extended("velocity = [\"sin(x\", 0]\n"),
     "block.toml:10: velocity has the formula \"sin(x\": a closing parenthesis is missing; "
     "formulas consist of numbers, x, y, z, pi, + - * / ^, comparisons, ?:, &&, || and functions "
     "such as sin, exp, sqrt, abs, min, max"},
    {"a_velocity_of_one_component", extended("velocity = [1]\n"),
     "block.toml:10: velocity needs 2 components for dimension = 2, got 1; give [x, y]"},
    {"an_initial_velocity_that_depends_on_time", extended("velocity = [0, \"t\"]\n"),
     "block.toml:10: velocity has the formula \"t\", which uses t; here formulas may use x, y, z "
     "only"},
};

class FaultyGeometry : public testing::TestWithParam<Fault> {};

TEST_P(FaultyGeometry, are_answered_with_where_what_and_what_to_do) {
  EXPECT_EQ(complaint(GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(faults, FaultyGeometry, testing::ValuesIn(faults), name_of);

}  // namespace
}  // namespace pliant::tests
