#include "tests/faults/fault.hpp"

namespace pliant::tests {
namespace {

const Fault faults[] = {
    {"a_text_without_quotes", broken(R"("a block")", "a block"),
     "block.toml:1: not TOML: Error while parsing value: could not determine value type; correct "
     "the line: write texts in quotes, lists in brackets, and every key once"},
    {"a_line_without_a_value", broken("end = 1", "end ="),
     "block.toml:5: not TOML: Error while parsing key-value pair: expected value, saw '\\n'; "
     "correct "
     "the line: write texts in quotes, lists in brackets, and every key once"},
    {"a_key_given_twice", broken("end = 1", "end = 1\nend = 2"),
     "block.toml:6: not TOML: Error while parsing key-value pair: cannot redefine existing integer "
     "'end'; correct the line: write texts in quotes, lists in brackets, and every key once"},
    {"an_unknown_key", broken("end = 1", "endd = 1\nend = 1"),
     "block.toml:5: unknown key `endd` in [time]; did you mean `end`?"},
    {"an_unknown_key_of_a_material", broken("youngs_modulus", "young_modulus"),
     "block.toml:9: unknown key `young_modulus` in material; did you mean `youngs_modulus`?"},
    {"a_key_of_another_table", extended("[ghosts]\nkernel = \"compact\"\n"),
     "block.toml:11: unknown key `kernel` in [ghosts]; it is a key of [discretisation]"},
    {"a_key_of_two_other_tables", extended("[ghosts]\nevery = 10\n"),
     "block.toml:11: unknown key `every` in [ghosts]; it is a key of [remeshing] or [output]"},
    {"a_key_of_the_case_below_a_table", extended("[ghosts]\ngravity = [0, -10]\n"),
     "block.toml:11: unknown key `gravity` in [ghosts]; it is a key of the case, above its first "
     "[table]"},
    {"a_key_of_the_material_in_its_body", broken("geometry", "density = 3\ngeometry"),
     "block.toml:8: unknown key `density` in [[body]]; it is a key of [material.NAME]"},
    {"an_unknown_key_unlike_any_other", extended("[ghosts]\ncolour = 3\n"),
     "block.toml:11: unknown key `colour` in [ghosts]; its keys are treatment"},
    {"an_unknown_table", extended("[output_files]\nevery = 3\n"),
     "block.toml:10: unknown key `output_files` in the case; its keys are title, name, dimension, "
     "method, precision, gravity, discretisation, time, remeshing, level_set, ghosts, remeshed, "
     "total_lagrangian, point_based, finite_elements, sph, periodic, material, body, boundary, "
     "contact, cut, "
     "output, "
     "checks, measurement"},
    {"the_beginning_of_a_table", extended("[remesh]\nevery = 3\n"),
     "block.toml:10: unknown key `remesh` in the case; did you mean `remeshed`?"},
    {"a_missing_key", broken("spacing = 0.1", ""),
     "block.toml:2: [discretisation] lacks `spacing`, initial distance h between particles, the "
     "resolution; add spacing = 0.03125"},
    {"a_missing_table", "title = \"nothing\"\n",
     "block.toml:1: [discretisation] lacks `spacing`, initial distance h between particles, the "
     "resolution; add spacing = 0.03125\n"
     "block.toml:1: [time] lacks `end`, time at which the run ends; add end = 0.02\n"
     "block.toml:1: the case has no body; add [[body]] with name, geometry and material"},
    {"a_single_bracket", broken("[[body]]", "[body]"),
     "block.toml:6: `body` must be a list of tables, found a table; write [[body]], with double "
     "brackets, before the keys of each"},
    {"a_table_that_is_a_number", broken(R"(title = "a block")", "output = 3"),
     "block.toml:1: `output` must be a table, found 3; write [output] on a line of its own, its "
     "keys below"},
    {"a_key_of_another_model", broken("density = 2", "density = 2, coefficients = [1]"),
     "block.toml:9: unknown key `coefficients` in material; with model = \"linear\" its keys are "
     "model, "
     "density, equation_of_state, youngs_modulus, poissons_ratio"},
    {"a_key_of_another_kind",
     extended("[[boundary]]\nname = \"floor\"\nkind = \"fixed\"\ngeometry = { shape = "
              "\"half_space\", point = [0, 0], normal = [0, 1] }\nvelocity = [0, 1]\n"),
     "block.toml:14: unknown key `velocity` in [[boundary]]; with kind = \"fixed\" its keys are "
     "name, "
     "kind, geometry"},
};

class FaultySyntax : public testing::TestWithParam<Fault> {};

TEST_P(FaultySyntax, are_answered_with_where_what_and_what_to_do) {
  EXPECT_EQ(complaint(GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(faults, FaultySyntax, testing::ValuesIn(faults), name_of);

}  // namespace
}  // namespace pliant::tests
