// Claim: every input that once broke a reader, or led it somewhere new, is read or refused as it must be.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "target.h"

namespace upbead::fuzz {

namespace {

namespace fs = std::filesystem;

const std::map<std::string, Target> targets{{"case", try_case},           {"design", try_design},
                                            {"history", try_history},     {"script", try_script},
                                            {"groups", try_groups},       {"mesh", try_mesh},
                                            {"model", try_model},         {"model_bytes", try_model_bytes},
                                            {"wave_file", try_wave_file}, {"checkpoint", try_checkpoint}};

std::string bytes_of(const fs::path& path) {
  std::stringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

}  // namespace

class Corpus : public testing::TestWithParam<std::string> {};

TEST_P(Corpus, IsReadOrRefused) {
  int n = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(UPBEAD_CORPUS) / GetParam())) {
    EXPECT_NO_THROW(targets.at(GetParam())(bytes_of(entry.path()))) << entry.path();
    ++n;
  }
  EXPECT_GT(n, 0) << "no corpus of " << GetParam();
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const auto& [name, target] : targets) list.push_back(name);
  return list;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(names()),
                         [](const testing::TestParamInfo<std::string>& row) { return row.param; });

}  // namespace upbead::fuzz
