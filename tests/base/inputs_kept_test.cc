// Claim: no output overwrites an input, even where the two have different names for one file.
#include "base/files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace upbead {
namespace inputs_kept_test {

namespace fs = std::filesystem;

class InputsKept : public testing::Test {
 protected:
  InputsKept() : before_(fs::current_path()) {
    folder_ = fs::temp_directory_path() / ("upbead-kept-" + std::to_string(getpid()));
    fs::create_directories(folder_ / "out/fields");
    fs::current_path(folder_);
    std::ofstream("case.toml") << "a = 1\n";
  }
  ~InputsKept() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }

  static std::string refusal(const std::string& folder, const std::string& output, const std::string& input) {
    try {
      require_inputs_kept(folder, {output}, {{input, {"case.toml", 2, 1}}});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_, before_;
};

TEST_F(InputsKept, TheSameNameInTheSameFolder) {
  EXPECT_EQ(refusal(".", "case.toml", "case.toml"),
            "case.toml:2:1: 'case.toml' is read, and './case.toml', which would be written, is the same file; choose "
            "another folder with --out DIR");
  EXPECT_NE(refusal(folder_.string(), "case.toml", "./out/../case.toml"), "");
  EXPECT_EQ(refusal("out", "case.toml", "case.toml"), "");
  EXPECT_EQ(refusal("none", "case.toml", "case.toml"), "");
  EXPECT_EQ(refusal(".", "results.h5", "case.toml"), "");
}

/// case.toml of results lies beside them; alone it is somebody's own.
TEST_F(InputsKept, ACaseOfOthersIsNotWrittenOver) {
  std::ofstream("out/case.toml") << "title = \"mine\"\n";
  EXPECT_NE(refusal("out", "case.toml", "case.toml").find("lies beside no results"), std::string::npos);
  std::ofstream("out/wave.csv") << "t,p\n";
  EXPECT_NE(refusal("out", "case.toml", "case.toml"), "");
  EXPECT_EQ(refusal("out", "results.h5", "case.toml"), "");
  for (const char* result : {"out/summary.json", "out/results.h5"}) {
    std::ofstream(result) << "";
    EXPECT_EQ(refusal("out", "case.toml", "case.toml"), "") << result;
    fs::remove(result);
  }
  std::ofstream("out/case.toml") << "# Made by `upbead scale a.toml --factor 20`: lengths times 20\n";
  EXPECT_EQ(refusal("out", "case.toml", "case.toml"), "");
}

TEST_F(InputsKept, Links) {
  fs::create_symlink("../case.toml", "out/case.toml");
  EXPECT_NE(refusal("out", "case.toml", "case.toml"), "");
  fs::remove("out/case.toml");
  fs::create_hard_link("case.toml", "out/results.h5");
  EXPECT_NE(refusal("out", "results.h5", "case.toml"), "");
  fs::create_symlink("case.toml", "link.toml");
  EXPECT_NE(refusal(".", "case.toml", "link.toml"), "");
  fs::create_symlink(".", "here");
  EXPECT_NE(refusal("here", "case.toml", "case.toml"), "");
}

TEST_F(InputsKept, Patterns) {
  fs::create_hard_link("case.toml", "out/fields/fields_0001.vtu");
  EXPECT_NE(refusal("out", "fields/fields_[0-9]*.vtu", "case.toml"), "");
  EXPECT_EQ(refusal("out", "fields/other_*.vtu", "case.toml"), "");
}

}  // namespace inputs_kept_test
}  // namespace upbead
