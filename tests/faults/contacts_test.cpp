#include "tests/faults/fault.hpp"

namespace pliant::tests {
namespace {

/// The block with a second one beside it, which begins at x = `left`, and contact tables from line
/// 16 on.
std::string meeting(const char* left, const std::string& contacts,
                    const std::string& remeshing = "every = 10") {
  return extended(
      std::string("[[body]]\nname = \"other\"\ngeometry = { shape = \"box\", lower = [") + left +
      ", 0], upper = [2, 2] }\nmaterial = { model = \"linear\", youngs_modulus = 1, "
      "poissons_ratio = 0, density = 1 }\n[remeshing]\n" +
      remeshing + "\n" + contacts);
}

const std::string pair = "[[contact]]\nbodies = [\"block\", \"other\"]\n";

/// The block and a contact wall below `height`.
std::string standing_in(const char* height) {
  return extended(std::string("[remeshing]\nevery = 10\n[[boundary]]\nname = \"floor\"\nkind = "
                              "\"contact_wall\"\ngeometry = { shape = \"half_space\", point = "
                              "[0, ") +
                  height + "], normal = [0, 1] }\n");
}

const Fault faults[] = {
    {"a_body_partly_inside_a_contact_wall", standing_in("0.5"),
     "block.toml:8: body \"block\" overlaps the contact wall \"floor\" by 0.5 at the start; move "
     "the body or the wall until they stand apart, or subtract the wall from the body"},
    {"a_body_wholly_inside_a_contact_wall", standing_in("10"),
     "block.toml:8: body \"block\" overlaps the contact wall \"floor\" by 1 at the start; move "
     "the body or the wall until they stand apart, or subtract the wall from the body"},
    {"contact_with_an_unknown_body",
     meeting("1.1", "[[contact]]\nbodies = [\"block\", \"othr\"]\n"),
     "block.toml:17: bodies names the body \"othr\", which does not exist; did you mean `other`?"},
    {"contact_of_a_body_with_itself",
     meeting("1.1", "[[contact]]\nbodies = [\"other\", \"other\"]\n"),
     "block.toml:17: bodies names the same body twice; name two different bodies, or choose "
     "another method"},
    {"a_force_of_a_body_on_itself",
     meeting("1.1",
             "[[measurement]]\nname = \"push\"\nkind = \"contact_force\"\nbodies = "
             "[\"other\", \"other\"]\n"),
     "block.toml:19: bodies names the same body twice; name two different bodies"},
    {"contact_of_three_bodies",
     meeting("1.1", "[[contact]]\nbodies = [\"block\", \"other\", \"block\"]\n"),
     "block.toml:17: bodies must be a list of two names of bodies, found a list; write it as in "
     "bodies = [\"left\", \"right\"]"},
    {"contact_without_bodies", meeting("1.1", "[[contact]]\nkind = \"tied\"\n"),
     "block.toml:16: [[contact]] lacks `bodies`, the two bodies; a body that is named twice is in "
     "contact with itself (methods on the undeformed body); add bodies = [\"left\", \"right\"]"},
    {"an_unknown_kind_of_contact", meeting("1.1", pair + "kind = \"sticky\"\n"),
     R"(block.toml:18: kind must be one of "frictionless", "no_slip", "tied", "coulomb", got "sticky"; )"
     "use one of these"},
    {"coulomb_contact_without_a_coefficient", meeting("1.1", pair + "kind = \"coulomb\"\n"),
     "block.toml:16: [[contact]] lacks `friction`, coefficient of Coulomb friction (RP.75); add "
     "friction = 0.3"},
    {"two_contacts_of_one_pair",
     meeting("1.1", pair + "[[contact]]\nbodies = [\"other\", \"block\"]\n"),
     "block.toml:19: bodies \"block\" and \"other\" are in two [[contact]] tables; keep one of "
     "them"},
    {"bodies_that_overlap", meeting("0.6", pair),
     "block.toml:17: bodies \"block\" and \"other\" overlap by 0.4 at the start; move one of them, "
     "or remove the contact"},
    {"tied_bodies_that_do_not_meet", meeting("1.5", pair + "kind = \"tied\"\n"),
     "block.toml:17: bodies \"block\" and \"other\" are tied but do not meet; let their surfaces "
     "touch at the start"},
    {"contact_of_bodies_without_remeshing", meeting("1.1", pair, "every = \"never\""),
     "block.toml:15: bodies in contact need remeshings; write every = \"adaptive\""},
    {"a_force_between_bodies_that_do_not_touch",
     meeting("1.1",
             "[[measurement]]\nname = \"push\"\nkind = \"contact_force\"\nbodies = [\"other\", "
             "\"block\"]\naxis = \"x\"\n"),
     "block.toml:19: bodies \"other\" and \"block\" have no [[contact]], so that they exert no "
     "force; add a [[contact]] between them, or name two bodies that have one"},
    {"contact_of_bodies_with_averaged_ghosts",
     meeting("1.1", pair + "[ghosts]\ntreatment = \"averaged\"\n"),
     "block.toml:19: contact between bodies needs linear ghosts; write treatment = "
     "\"linear\", or remove the key"},
};

class FaultyContacts : public testing::TestWithParam<Fault> {};

TEST_P(FaultyContacts, are_answered_with_where_what_and_what_to_do) {
  EXPECT_EQ(complaint(GetParam().text), GetParam().message);
}

TEST(contacts, a_body_may_begin_on_a_contact_wall) { EXPECT_EQ(complaint(standing_in("0")), ""); }

INSTANTIATE_TEST_SUITE_P(faults, FaultyContacts, testing::ValuesIn(faults), name_of);

}  // namespace
}  // namespace pliant::tests
