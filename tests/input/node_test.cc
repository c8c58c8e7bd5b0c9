// Claim: numbers and texts are written as TOML that reads back as the same value; ranges say what they hold.
#include "upbead/input/node.h"

#include <gtest/gtest.h>

#include <limits>

#include "input/values.h"

namespace upbead {
namespace node_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ToToml, WritesNumbersAsPeopleDo) {
  EXPECT_EQ(to_toml(40.), "40.0");
  EXPECT_EQ(to_toml(0.1), "0.1");
  EXPECT_EQ(to_toml(1e8), "1e8");
  EXPECT_EQ(to_toml(2.5e-7), "2.5e-7");
  EXPECT_EQ(to_toml(1e100), "1e100");
  EXPECT_EQ(to_toml(-infinity), "-inf");
  EXPECT_EQ(to_toml(1. / 3.), "0.3333333333333333");
  EXPECT_EQ(number_text(40.), "40");
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(ToToml, EscapesText) {
  EXPECT_EQ(to_toml(std::string("a\"b\\c\nd")), "\"a\\\"b\\\\c\\u000Ad\"");
}

TEST(Dotted, QuotesWhatTomlWantsQuoted) {
  EXPECT_EQ(dotted("", "a"), "a");
  EXPECT_EQ(dotted("regions", "my sand.1"), "regions.\"my sand.1\"");
  EXPECT_EQ(split_dotted("regions.\"my sand.1\".kind"), (std::vector<std::string>{"regions", "my sand.1", "kind"}));
  EXPECT_EQ(split_dotted("a.'b.c'"), (std::vector<std::string>{"a", "b.c"}));
}

TEST(RangeTest, SaysWhatItHolds) {
  EXPECT_EQ(above(0.).text(), "(0, inf)");
  EXPECT_EQ(above(0.).or_infinite().text(), "(0, inf]");
  EXPECT_EQ(at_least(1.).text(), "[1, inf)");
  EXPECT_EQ(from_to_below(0., 0.5).text(), "[0, 0.5)");
  EXPECT_EQ(Range().text(), "any finite number");
}

TEST(RangeTest, HoldsItsEndsWhereStated) {
  EXPECT_FALSE(above(0.).contains(0.));
  EXPECT_TRUE(at_least(0.).contains(0.));
  EXPECT_FALSE(above(0.).contains(infinity));
  EXPECT_TRUE(above(0.).or_infinite().contains(infinity));
  EXPECT_FALSE(Range().contains(-infinity));
  EXPECT_FALSE(Range().or_infinite().contains(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(from_to(2., 3.).contains(3.));
  EXPECT_FALSE(from_to_below(2., 3.).contains(3.));
  EXPECT_FALSE(between(2., 3.).contains(2.));
}

}  // namespace node_test
}  // namespace upbead
