// Claim: whatever a journal has lost, what is read of it is what was written: wherever a line is torn, whatever is cut
// out of the file, the runs of whole lines alone have their results, and lines that are not whole are counted.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "study/results.h"
#include "upbead/base/error.h"

namespace upbead::test {
namespace journal_test {

namespace fs = std::filesystem;

class JournalFile : public testing::Test {
 protected:
  JournalFile() : folder_(fs::temp_directory_path() / ("upbead-journal-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    study_.runs.resize(n);
    study_.fingerprint = 0xfedcba9876543210U;
    Journal journal(folder_.string(), study_, "0");
    for (int run = 0; run < n; ++run) journal.add(run, result(run));
    std::ifstream stream(file());
    whole_ = {std::istreambuf_iterator<char>(stream), {}};
  }
  ~JournalFile() override { fs::remove_all(folder_); }

  static RunResult result(int run) {
    RunResult r;
    r.done = run != 2;
    r.values = {1. / 3. + run, std::nullopt, 1e-300 * run};
    r.message = run == 2 ? "a \"message\" {\"run\":1}" : "";
    r.seconds = 0.1 * run;
    return r;
  }

  fs::path file() const { return folder_ / "journal" / "0-0.jsonl"; }
  JournalsRead read(const std::string& text) const {
    std::ofstream(file()) << text;
    return read_journals(folder_.string(), study_);
  }
  /// Number of results; each must be the one that was written.
  static int number_of(const JournalsRead& found) {
    int number = 0;
    for (int run = 0; run < n; ++run)
      if (const auto& r = found.results[static_cast<std::size_t>(run)]) {
        ++number;
        const RunResult written = result(run);
        EXPECT_EQ(r->done, written.done);
        EXPECT_EQ(r->values, written.values);
        EXPECT_EQ(r->message, written.message);
        EXPECT_EQ(r->seconds, written.seconds);
      }
    return number;
  }

  static constexpr int n = 4;
  fs::path folder_;
  Study study_;
  std::string whole_;
};

TEST_F(JournalFile, IsReadAsItWasWritten) {
  const JournalsRead found = read(whole_);
  EXPECT_EQ(number_of(found), n);
  EXPECT_EQ(found.torn, 0);
}

TEST_F(JournalFile, WhereverItEndsWholeLinesCount) {
  for (std::size_t end = 0; end < whole_.size(); ++end) {
    const std::string text = whole_.substr(0, end);
    const auto lines = std::count(text.begin(), text.end(), '\n');
    const bool lacks_newline_alone = whole_[end] == '\n';
    const JournalsRead found = read(text);
    EXPECT_EQ(number_of(found), std::max<int>(0, static_cast<int>(lines) - 1 + (lacks_newline_alone && lines > 0)))
        << end;
    EXPECT_EQ(found.torn, end > 0 && text.back() != '\n' && !lacks_newline_alone ? 1 : 0) << end;
  }
}

TEST_F(JournalFile, WhateverIsCutOutOrOverwrittenNoOtherResultIsRead) {
  for (std::size_t from = 0; from < whole_.size(); from += 3)
    for (std::size_t length = 1; from + length <= whole_.size(); length += 7) {
      const std::string cut = whole_.substr(0, from) + whole_.substr(from + length);
      if (cut.find("check") == std::string::npos && !cut.empty()) continue;  // as of an older program, which is refused
      const auto lines_hit = std::count(whole_.begin() + from, whole_.begin() + from + length, '\n') + 1;
      const JournalsRead found = read(cut);
      EXPECT_GE(number_of(found), n - lines_hit) << from << " " << length;
    }
  for (std::size_t at = 0; at < whole_.size(); ++at)
    for (const char other : {'\0', '7', '\n', '"'}) {
      std::string changed = whole_;
      changed[at] = other;
      const JournalsRead found = read(changed);
      EXPECT_GE(number_of(found), n - 2) << at;
      EXPECT_TRUE(found.torn > 0 || changed == whole_) << at;
    }
}

TEST_F(JournalFile, OfAnotherStudyIsRefused) {
  ++study_.fingerprint;
  EXPECT_THROW(read(whole_), InputError);
  --study_.fingerprint;
  EXPECT_EQ(number_of(read(whole_)), n);
  EXPECT_THROW(read("{\"study\":1}\n"), InputError) << "as older programs wrote";
}

TEST_F(JournalFile, BelongsToOneProcess) {
  Journal second(folder_.string(), study_, "0");
  second.add(1, result(1));
  EXPECT_TRUE(fs::exists(folder_ / "journal" / "1-0.jsonl"));
  EXPECT_EQ(number_of(read(whole_)), n);
}

}  // namespace journal_test
}  // namespace upbead::test
