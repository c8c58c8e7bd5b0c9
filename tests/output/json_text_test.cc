// Claim: JSON never holds a number that is not finite; the message names where it is.

#include "output/json_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "upbead/base/error.h"

namespace upbead {
namespace {

TEST(JsonText, KeepsTheOrderAndEndsWithANewline) {
  EXPECT_EQ(json_text({{"b", 1.5}, {"a", {{"c", nullptr}}}}),
            "{\n  \"b\": 1.5,\n  \"a\": {\n    \"c\": null\n  }\n}\n");
}

TEST(JsonText, RefusesWhatIsNotFinite) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) try {
      json_text({{"waves", {{"list", {1., bad}}}}});
      ADD_FAILURE() << bad << " was written";
    } catch (const NumericsError& error) {
      EXPECT_STREQ(error.what(), "'/waves/list/1' of the summary is not finite; nothing was written");
    }
}

}  // namespace
}  // namespace upbead
