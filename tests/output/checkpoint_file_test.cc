// Claim: a checkpoint is read back as it was written, every number to the last bit, also with empty lists; an
// incomplete checkpoint is refused with the file's name.
#include "output/checkpoint_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "output/result_file.h"
#include "upbead/base/error.h"

namespace checkpoint_file_test {

using namespace upbead;
using Eigen::MatrixXd;

class CheckpointFileTest : public testing::Test {
 protected:
  ~CheckpointFileTest() override { std::filesystem::remove(path_); }
  CheckpointFile read(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary) << bytes;
    return read_checkpoint(path_);
  }
  std::string refusal(const std::string& bytes) const {
    try {
      read(bytes);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  std::string path_ = (std::filesystem::temp_directory_path() / ("state-" + std::to_string(getpid()) + ".h5")).string();
};

Series series(int n_readings, int n_loads, int n_times) {
  Series s{{}, MatrixXd::Random(n_readings, n_times), MatrixXd::Random(n_loads, n_times)};
  for (int i = 0; i < n_times; ++i) s.time.push_back(std::sqrt(0.1 * i));
  return s;
}

State state(int n, double time) {
  return {time, Vector::Random(n), Vector::Random(n) * 1e-300, Vector::Random(n) * 1e300};
}

CheckpointFile sample() {
  CheckpointFile file;
  file.fingerprint = 0xfedcba9876543210U;
  Response& so_far = file.march.so_far;
  so_far.ends = series(3, 2, 5);
  so_far.balanced = series(3, 2, 5);
  so_far.inside = series(3, 2, 20);
  for (int i = 0; i < 5; ++i) {
    EnergyAccount account;
    account.work = 1. / (i + 3);
    account.friction = std::numeric_limits<double>::denorm_min();
    so_far.energy.push_back(account);
  }
  so_far.final_state = state(7, 2. / 3.);
  so_far.n_steps = 4;
  so_far.n_solves = 20;
  file.march.memory = {{state(7, 0.1), {1. / 3., -0.}}, {0.1, 0.2}, {0.3, 0.4}, 0.05, so_far.energy[1]};
  file.fields = {{0., "fields/fields_0000.vtu"}, {0.1, "fields/fields_0001.vtu"}};
  return file;
}

void expect_same(const State& a, const State& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.a, b.a);
}

TEST_F(CheckpointFileTest, ComesBackToTheLastBit) {
  const CheckpointFile file = sample(), back = read(checkpoint_file("title", file));
  EXPECT_EQ(back.fingerprint, file.fingerprint);
  EXPECT_EQ(back.fields, file.fields);
  const Response &a = back.march.so_far, &b = file.march.so_far;
  for (const auto part : {&Response::ends, &Response::balanced, &Response::inside}) {
    EXPECT_EQ((a.*part).time, (b.*part).time);
    EXPECT_EQ((a.*part).reading, (b.*part).reading);
    EXPECT_EQ((a.*part).load, (b.*part).load);
  }
  ASSERT_EQ(a.energy.size(), 5U);
  EXPECT_EQ(a.energy[4].work, 1. / 7.);
  EXPECT_EQ(a.energy[4].friction, std::numeric_limits<double>::denorm_min());
  expect_same(a.final_state, b.final_state);
  EXPECT_EQ(a.n_steps, 4);
  EXPECT_EQ(a.n_solves, 20);
  const SchemeMemory &m = back.march.memory, &n = file.march.memory;
  expect_same(m.balanced.state, n.balanced.state);
  EXPECT_EQ(m.balanced.load, n.balanced.load);
  EXPECT_EQ(m.end_load, n.end_load);
  EXPECT_EQ(m.history, n.history);
  EXPECT_EQ(m.last_step, n.last_step);
  EXPECT_EQ(m.energy.work, n.energy.work);
}

TEST_F(CheckpointFileTest, ListsMayBeEmpty) {
  CheckpointFile file = sample();
  file.fields.clear();
  file.march.memory.history.clear();
  file.march.so_far.energy.clear();
  const CheckpointFile back = read(checkpoint_file("title", file));
  EXPECT_TRUE(back.fields.empty());
  EXPECT_TRUE(back.march.memory.history.empty());
  EXPECT_TRUE(back.march.so_far.energy.empty());
}

TEST_F(CheckpointFileTest, RefusesPartsThatDoNotFit) {
  const auto refused = [&](auto change) {
    CheckpointFile file = sample();
    change(file);
    return refusal(checkpoint_file("title", file));
  };
  EXPECT_NE(refused([](CheckpointFile& file) { file.march.so_far.final_state.a.resize(2); }).find("/state"),
            std::string::npos);
  EXPECT_NE(refused([](CheckpointFile& file) { file.march.so_far.ends.time.pop_back(); }).find("/ends"),
            std::string::npos);
  EXPECT_NE(refused([](CheckpointFile& file) { file.march.memory.balanced.state = state(2, 0.); }).find("/memory"),
            std::string::npos);
  EXPECT_NE(refused([](CheckpointFile& file) { file.fields[0].second = "../case.toml"; }).find("/fields/name"),
            std::string::npos);
}

TEST_F(CheckpointFileTest, RefusesWhatIsNotWhole) {
  const std::string bytes = checkpoint_file("title", sample());
  EXPECT_NE(refusal(bytes.substr(0, bytes.size() / 2)).find(path_), std::string::npos);
  EXPECT_NE(refusal("no HDF5").find(path_), std::string::npos);
  EXPECT_NE(refusal(dataset_file("title", {})).find("the checkpoint is damaged at /fingerprint"), std::string::npos);
}

}  // namespace checkpoint_file_test
