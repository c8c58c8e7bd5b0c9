// Wrong cases by table: one edit of the good case, and the message to the user, word for word.
#pragma once

#include <string>
#include <vector>

#include "good_case.h"
#include "upbead/case/case.h"

namespace upbead::test {

struct BadCase {
  std::string name;
  std::string good;  ///< text that occurs once in the good case
  std::string bad;   ///< text that replaces it
  std::string messages;
};

inline void PrintTo(const BadCase& row, std::ostream* stream) {
  *stream << row.name;
}

class BadCaseTest : public InFolder, public testing::WithParamInterface<BadCase> {
 protected:
  void check() const {
    std::string text = good_case;
    const std::size_t at = text.find(GetParam().good);
    ASSERT_NE(at, std::string::npos) << "the good case has no '" << GetParam().good << "'";
    write("case.toml", text.replace(at, GetParam().good.size(), GetParam().bad));
    try {
      read_case("case.toml");
      FAIL() << "read without a message";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), GetParam().messages);
    }
  }
};

inline std::string name_of(const testing::TestParamInfo<BadCase>& info) {
  return info.param.name;
}

}  // namespace upbead::test
