// Claim: contradictory keys of the interface under the caisson are reported before meshing, and mistakes that only
// the mesh can show, with the mesh.
#include "bad_case.h"

namespace upbead::test {
namespace bad_contact_test {

class BadContact : public BadCaseTest {};

TEST_P(BadContact, IsExplained) {
  check();
}

const std::string caisson = "moment_of_inertia = 45e6\n", interface = caisson + "interface = ";
const std::string uplift = "[sliding.uplift]\nkind = \"prescribed\"\npeak = 5e5\nshape = \"held\"\nlag = 0.02\n";

const std::vector<BadCase> contact_rows{
    BadCase{"UnknownKind", caisson, interface + "{ kind = \"sticky\" }\n",
            "case.toml:38:15: kind = \"sticky\" is none of bonded, friction; choose one of them"},
    BadCase{"CoefficientZero", caisson, interface + "{ kind = \"friction\", coefficient = 0 }\n",
            "case.toml:38:34: coefficient = 0 is outside (0, inf); give the friction coefficient mu"},
    BadCase{"CoefficientOfATie", caisson, interface + "{ coefficient = 0.6 }\n",
            "case.toml:38:15: 'coefficient' does not belong in [regions.caisson.interface] (only where the contact is "
            "by friction); remove it"},
    BadCase{"GapOfATie", caisson, interface + "{ gap = \"sea\" }\n",
            "case.toml:38:15: 'gap' does not belong in [regions.caisson.interface] (only where the contact is by "
            "friction); remove it"},
    BadCase{"GapOfAir", caisson, interface + "{ kind = \"friction\", gap = \"air\" }\n",
            "case.toml:38:34: gap = \"air\" is none of pores, sea; choose one of them"},
    BadCase{
        "InSoil", "biot = 0.9", "biot = 0.9\ninterface = { kind = \"friction\" }",
        "case.toml:24:1: 'interface' does not belong in [regions.rubble] (only in solid and rigid regions); remove it"},
    BadCase{
        "TwoFrictions", caisson, interface + "{ kind = \"friction\", coefficient = 0.5 }\n",
        "case.toml:84:1: [sliding]: friction = 0.55 is not the coefficient = 0.5 of [regions.caisson] interface; give "
        "the same number, or only one of them"},
};

INSTANTIATE_TEST_SUITE_P(Contact, BadContact, testing::ValuesIn(contact_rows), name_of);

class BadScheme : public InFolder {};

TEST_F(BadScheme, FollowsNoFriction) {
  std::string text = good_case;
  text.replace(text.find("scheme = \"sdirk4\""), 17, "scheme = \"generalised_alpha\"");
  text.replace(text.find(caisson), caisson.size(), interface + "{ kind = \"friction\" }\n");
  write("case.toml", text);
  try {
    read_case("case.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("does not follow friction at the caisson's bottom"), std::string::npos)
        << error.what();
  }
}

TEST_F(BadScheme, CoefficientIsThatOfTheSliding) {
  std::string text = good_case;
  text.replace(text.find("[sliding.uplift]"), std::string::npos, "");
  text.replace(text.find(caisson), caisson.size(), interface + "{ kind = \"friction\" }\n");
  write("case.toml", text);
  EXPECT_DOUBLE_EQ(contact_friction(read_case("case.toml").scene), 0.55);
  text.replace(text.find("{ kind = \"friction\" }"), 21, "{ kind = \"friction\", coefficient = 0.7 }");
  text.replace(text.find("friction = 0.55\n"), 16, "");
  write("case.toml", text);
  const Case problem = read_case("case.toml");
  EXPECT_DOUBLE_EQ(contact_friction(problem.scene), 0.7);
  EXPECT_DOUBLE_EQ(problem.scene.sliding->friction, 0.7);
}

}  // namespace bad_contact_test
}  // namespace upbead::test
