// Claim: text that a message quotes from an input is short, on one line, and valid UTF-8; the length of a whole
// message is bounded too.
#include "base/text.h"

#include <gtest/gtest.h>

#include "upbead/base/error.h"

namespace upbead {
namespace quoted_test {

TEST(Quoted, ShortTextIsWhole) {
  EXPECT_EQ(in_quotes("porosity"), "'porosity'");
  EXPECT_EQ(in_quotes(""), "''");
  EXPECT_EQ(excerpt(std::string(60, 'x')), std::string(60, 'x'));
}

TEST(Quoted, LongTextKeepsItsBeginningAndItsEnd) {
  const std::string text = excerpt("begin" + std::string(50'000'000, 'x') + "end");
  EXPECT_EQ(text.size(), 60U);
  EXPECT_EQ(text.substr(0, 5), "begin");
  EXPECT_EQ(text.substr(57), "end");
  EXPECT_NE(text.find(" ... "), std::string::npos);
}

TEST(Quoted, CharactersStayWhole) {
  std::string long_text;
  for (int i = 0; i < 100; ++i) long_text += "日";
  const std::string text = excerpt(long_text);
  EXPECT_LE(text.size(), 60U);
  EXPECT_EQ((text.size() - 5) % 3, 0U) << text;
}

TEST(Quoted, StaysOnOneLine) {
  EXPECT_EQ(in_quotes("a\nb\x1b[31m"), "'a b [31m'");
}

TEST(Quoted, PathsThatCanBeAreWhole) {
  const std::string path(1000, 'p');
  EXPECT_EQ(quoted_path(path).size(), 1002U);
  EXPECT_LE(quoted_path(std::string(1'000'000, 'p')).size(), 70U);
}

TEST(Quoted, NoMistakeIsLongerThanAPage) {
  const InputError one({std::string(100'000, 'f'), 1, 1}, std::string(1'000'000, 'w'), std::string(1'000'000, 'c'));
  EXPECT_LT(std::string(one.what()).size(), 13'000U);
  Diagnostics wrong;
  for (int i = 0; i < 20'000; ++i) wrong.add({"f"}, "wrong");
  const InputError many(wrong);
  EXPECT_EQ(many.diagnostics().list().size(), 20'000U);
  EXPECT_LT(std::string(many.what()).size(), 10'000U);
  EXPECT_NE(std::string(many.what()).find("and 19000 more mistakes"), std::string::npos);
}

TEST(Quoted, SuggestionsLookAtWordsNotAtBooks) {
  const std::string book(50'000'000, 'x');
  EXPECT_EQ(nearest(book, {"porosity"}), "");
  EXPECT_LE(suggestion("colour", std::vector<std::string>(100'000, std::string(1000, 'k')), "keys").size(), 3000U);
}

}  // namespace quoted_test
}  // namespace upbead
