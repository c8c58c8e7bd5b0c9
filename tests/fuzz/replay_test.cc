// Claim: every input that once broke a reader or reached new code is read or refused correctly, and so are random
// changes of these inputs (the same in every run): a short version of tests/fuzz/run.py.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "target.h"

namespace upbead::fuzz {

namespace {

namespace fs = std::filesystem;

struct Reader {
  Target target;
  int changes;  ///< number to try, in some seconds at most
};

const std::map<std::string, Reader> targets{
    {"case", {try_case, 1500}},           {"design", {try_design, 1000}},
    {"flow", {try_flow, 4000}},           {"forces", {try_forces, 4000}},
    {"history", {try_history, 5000}},     {"script", {try_script, 5000}},
    {"groups", {try_groups, 500}},        {"mesh", {try_mesh, 50}},
    {"model", {try_model, 80}},           {"model_bytes", {try_model_bytes, 10}},
    {"soil_model", {try_soil_model, 80}}, {"wave_file", {try_wave_file, 120}},
    {"checkpoint", {try_checkpoint, 100}}};

std::string bytes_of(const fs::path& path) {
  std::stringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

std::vector<std::string> corpus(const std::string& name) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(UPBEAD_CORPUS) / name))
    paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> inputs;
  for (const fs::path& path : paths) inputs.push_back(bytes_of(path));
  return inputs;
}

/// Bytes exchanged, pieces left out, doubled, or taken from another input.
class Changer {
 public:
  explicit Changer(std::vector<std::string> inputs) : inputs_(std::move(inputs)) {}

  std::string next() {
    std::string bytes = any_input();
    for (int n = 1 + below(4); n > 0; --n) change(bytes);
    return bytes;
  }

 private:
  int below(std::size_t n) { return n == 0 ? 0 : static_cast<int>(generator_() % n); }
  const std::string& any_input() { return inputs_[static_cast<std::size_t>(below(inputs_.size()))]; }
  std::string piece(const std::string& of) {
    return of.substr(static_cast<std::size_t>(below(of.size())), static_cast<std::size_t>(1 + below(40)));
  }
  void change(std::string& bytes) {
    const auto at = static_cast<std::size_t>(below(bytes.size()));
    switch (below(4)) {
      case 0:
        if (!bytes.empty()) bytes[at] = static_cast<char>(below(256));
        return;
      case 1:
        bytes.erase(at, static_cast<std::size_t>(1 + below(40)));
        return;
      case 2:
        bytes.insert(at, piece(bytes));
        return;
      default:
        bytes.insert(at, piece(any_input()));
    }
  }

  std::vector<std::string> inputs_;
  std::mt19937 generator_{1};
};

}  // namespace

class Corpus : public testing::TestWithParam<std::string> {};

TEST_P(Corpus, IsReadOrRefused) {
  const std::vector<std::string> inputs = corpus(GetParam());
  ASSERT_FALSE(inputs.empty()) << "no corpus of " << GetParam();
  for (std::size_t i = 0; i < inputs.size(); ++i) EXPECT_NO_THROW(targets.at(GetParam()).target(inputs[i])) << i;
}

TEST_P(Corpus, ChangedAtRandomIsReadOrRefused) {
  const Reader& reader = targets.at(GetParam());
  Changer changer(corpus(GetParam()));
  for (int n = 0; n < reader.changes; ++n) {
    const std::string bytes = changer.next();
    EXPECT_NO_THROW(reader.target(bytes)) << n << ": " << testing::PrintToString(bytes);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const auto& [name, reader] : targets) list.push_back(name);
  return list;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(names()),
                         [](const testing::TestParamInfo<std::string>& row) { return row.param; });

}  // namespace upbead::fuzz
