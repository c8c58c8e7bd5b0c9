// Claims: parts of a study have each run once, whatever their number; runs that share a basis stay together as far as
// parts are balanced; a division follows from the study alone. Files that several processes write at once are whole.
#include "study/parts.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "study/shared_files.h"
#include "upbead/base/error.h"

namespace upbead::test {
namespace parts_test {

namespace fs = std::filesystem;

/// `meshes` meshes, on each `soils` soils, with each `frictions` frictions, which one solution serves.
Study study_of(int meshes, int soils, int frictions) {
  Study study;
  for (int m = 0; m < meshes; ++m)
    for (int s = 0; s < soils; ++s)
      for (int f = 0; f < frictions; ++f) {
        StudyRun run;
        run.settings = {{"mesh.parameters.cells", std::to_string(m)},
                        {"regions.seabed.shear_modulus", std::to_string(s)},
                        {"sliding.friction", std::to_string(f)}};
        study.runs.push_back(run);
      }
  return study;
}

int number_of(const Pieces& pieces) {
  int n = 0;
  for (const auto& piece : pieces) n += static_cast<int>(piece.size());
  return n;
}

/// The values of a setting in all runs of a part.
std::set<std::string> values_in(const Study& study, const Pieces& pieces, std::size_t setting) {
  std::set<std::string> values;
  for (const auto& piece : pieces)
    for (const int run : piece) values.insert(study.runs[static_cast<std::size_t>(run)].settings[setting].second);
  return values;
}

TEST(Parts, HaveEachRunOnceAndDifferByHalfAShareAtMost) {
  for (const Study& study : {study_of(1, 1, 100), study_of(3, 5, 2), study_of(2, 7, 1), study_of(4, 1, 25)})
    for (const int n : {1, 2, 3, 7, 14, 64, 1000}) {
      const std::vector<Pieces> parts = deal(study, n);
      ASSERT_EQ(parts.size(), static_cast<std::size_t>(n));
      std::set<int> runs;
      int least = static_cast<int>(study.runs.size()), most = 0;
      for (const Pieces& part : parts) {
        for (const auto& piece : part)
          for (const int run : piece) EXPECT_TRUE(runs.insert(run).second) << run;
        least = std::min(least, number_of(part));
        most = std::max(most, number_of(part));
      }
      EXPECT_EQ(runs.size(), study.runs.size());
      const int fair = (static_cast<int>(study.runs.size()) + n - 1) / n;
      EXPECT_LE(most - least, std::max(1, fair / 2)) << n;
    }
}

TEST(Parts, KeepRunsOfOneSolutionTogether) {
  const Study study = study_of(2, 12, 3);
  for (const int n : {2, 4, 6}) {
    std::size_t solved = 0;
    for (const Pieces& part : deal(study, n)) solved += part.size();
    EXPECT_EQ(solved, 24U) << n << ": no solution is made in two parts";
  }
  const std::vector<Pieces> cut = deal(study_of(1, 1, 10), 2);
  EXPECT_EQ(number_of(cut[0]), 6) << "but where that would leave others without work";
  EXPECT_EQ(number_of(cut[1]), 4);
}

TEST(Parts, GoThroughTheirMeshesOneByOne) {
  const Study study = study_of(4, 6, 1);
  for (const Pieces& part : deal(study, 3)) {
    std::vector<std::string> meshes;
    for (const auto& piece : part) meshes.push_back(study.runs[static_cast<std::size_t>(piece[0])].settings[0].second);
    EXPECT_TRUE(std::is_sorted(meshes.begin(), meshes.end()));
    EXPECT_EQ(values_in(study, part, 0).size(), 4U)
        << "fine and coarse ones for each, as they differ in what they cost";
  }
}

TEST(Parts, ThatAreDoneAreNotScheduled) {
  const Study study = study_of(2, 3, 2);
  Results results(study.runs.size());
  EXPECT_EQ(schedule(study, results).size(), 6U);
  results[0].emplace();
  results[2].emplace();
  results[3].emplace();
  const Pieces left = schedule(study, results);
  EXPECT_EQ(left.size(), 5U);
  EXPECT_EQ(left.front(), std::vector<int>{1});
}

TEST(Parts, AreReadAsTheyAreWritten) {
  const Part part = read_part("3/100");
  EXPECT_EQ(part.text(), "3/100");
  EXPECT_EQ(part.name(), "part-3-of-100");
  for (const char* wrong : {"", "3", "3/", "/3", "0/3", "4/3", "3/100x", "3//100", "-1/3", " 3/100", "3/1000000", "a/b",
                            "1/99999999999", "3/100/2"})
    EXPECT_THROW(read_part(wrong), InputError) << wrong;
}

class SharedFile : public testing::Test {
 protected:
  SharedFile() : folder_(fs::temp_directory_path() / ("upbead-shared-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~SharedFile() override { fs::remove_all(folder_); }
  std::string path() const { return (folder_ / "soils-0.h5").string(); }

  fs::path folder_;
};

TEST_F(SharedFile, IsWholeWhoeverWasLast) {
  constexpr int n = 4, times = 20;
  for (int i = 0; i < n; ++i)
    if (fork() == 0) {
      for (int k = 0; k < times; ++k)
        write_together({{path(), std::string(static_cast<std::size_t>(200000 + i), static_cast<char>('a' + i))}});
      _exit(0);
    }
  int alive = n;
  while (alive > 0) {
    int status = 0;
    if (waitpid(-1, &status, WNOHANG) > 0) {
      EXPECT_EQ(status, 0);
      --alive;
    }
    std::ifstream stream(path());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream.is_open() || text.empty()) continue;  // none has written yet
    EXPECT_EQ(text, std::string(static_cast<std::size_t>(200000 + text[0] - 'a'), text[0]));
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(SharedFile, StaysWhereTheLastOfSeveralCannotBeWritten) {
  write_together({{path(), "old"}});
  EXPECT_THROW(write_together({{path(), "new"}, {(folder_ / "none" / "x").string(), "new"}}), InputError);
  std::ifstream stream(path());
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(SharedFile, HasOneFirst) {
  EXPECT_TRUE(is_first(path()));
  EXPECT_FALSE(is_first(path()));
}

}  // namespace parts_test
}  // namespace upbead::test
