// Claim: an interface under the caisson that cannot be meant is told, before anything is meshed; what only the mesh
// tells, with it.
#include "bad_case.h"

namespace upbead::test {

class BadContact : public BadCaseTest {};

TEST_P(BadContact, IsExplained) {
  check();
}

const std::string caisson = "moment_of_inertia = 45e6\n", interface = caisson + "interface = ";
const std::string uplift = "[sliding.uplift]\nkind = \"prescribed\"\npeak = 5e5\nshape = \"held\"\nlag = 0.02\n";

const std::vector<BadCase> contact_rows{
    BadCase{"UnknownKind", caisson, interface + "{ kind = \"sticky\" }\n", ""},
    BadCase{"CoefficientZero", caisson, interface + "{ kind = \"friction\", coefficient = 0 }\n", ""},
    BadCase{"CoefficientOfATie", caisson, interface + "{ coefficient = 0.6 }\n", ""},
    BadCase{"InSoil", "biot = 0.9", "biot = 0.9\ninterface = { kind = \"friction\" }", ""},
    BadCase{"TwoFrictionsAndTwoUplifts", caisson, interface + "{ kind = \"friction\", coefficient = 0.5 }\n", ""},
    BadCase{"Reduced", "scheme = \"sdirk4\"", "scheme = \"reduced\"", ""},
};

INSTANTIATE_TEST_SUITE_P(Contact, BadContact, testing::ValuesIn(contact_rows), name_of);

}  // namespace upbead::test
