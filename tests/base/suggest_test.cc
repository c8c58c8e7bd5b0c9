// Claim: for a mistyped word the intended word is suggested; for an unrelated word, nothing.
#include "base/text.h"

#include <gtest/gtest.h>

namespace upbead {
namespace suggest_test {

const std::vector<std::string> keys{"porosity", "poissons_ratio", "shear_modulus", "end"};

TEST(Nearest, FindsSlips) {
  EXPECT_EQ(nearest("porosty", keys), "porosity");
  EXPECT_EQ(nearest("poroisty", keys), "porosity");
  EXPECT_EQ(nearest("Shear-Modulus", keys), "shear_modulus");
  EXPECT_EQ(nearest("edn", keys), "end");
}

TEST(Nearest, CountsASwapAsOne) {
  EXPECT_EQ(nearest("ned", {"end"}), "end");
}

TEST(Nearest, FindsNothingFarAway) {
  EXPECT_EQ(nearest("colour", keys), "");
  EXPECT_EQ(nearest("x", {"y"}), "");
  EXPECT_EQ(nearest("", keys), "");
  EXPECT_EQ(nearest("end", {}), "");
}

TEST(Suggestion, NamesTheNearestOrAll) {
  EXPECT_EQ(suggestion("porosty", keys, "keys"), "did you mean 'porosity'?");
  EXPECT_EQ(suggestion("colour", {"a", "b"}, "keys"), "known keys: a, b");
  EXPECT_EQ(suggestion("colour", {}, "boundaries"), "there are no boundaries");
}

}  // namespace suggest_test
}  // namespace upbead
