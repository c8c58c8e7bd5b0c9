// Claim: an output folder appears complete or not at all, and files of other programs in it stay; an older result is
// replaced in one step, so that a reader never meets a mixture.
#include "base/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <sstream>
#include <thread>

#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {
namespace files_test {

class OutputFolderTest : public testing::Test {
 protected:
  OutputFolderTest() : root_(fs::temp_directory_path() / ("upbead-out-" + std::to_string(getpid()))) {
    fs::create_directories(root_);
  }
  ~OutputFolderTest() override { fs::remove_all(root_); }

  static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  static std::string read(const fs::path& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  int n_entries() const {
    return static_cast<int>(std::distance(fs::directory_iterator(root_), fs::directory_iterator()));
  }
  static std::string refusal(const std::string& path) {
    try {
      OutputFolder folder(path);
      folder.write("a.txt", "new");
      folder.commit();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path root_;
};

TEST_F(OutputFolderTest, IsNoLinkToNothing) {
  fs::create_symlink(root_ / "nothing", root_ / "link");
  EXPECT_THROW(OutputFolder((root_ / "link").string()), InputError) << "before any work";
  EXPECT_EQ(n_entries(), 1);
}

TEST_F(OutputFolderTest, AppearsWithCommit) {
  const fs::path target = root_ / "deep" / "out";
  {
    OutputFolder folder(target.string() + "/");
    folder.write("a.txt", "a");
    folder.write("fields/b.txt", "b");
    EXPECT_FALSE(fs::exists(target));
    folder.commit();
  }
  EXPECT_EQ(read(target / "a.txt"), "a");
  EXPECT_EQ(read(target / "fields" / "b.txt"), "b");
  EXPECT_EQ(std::distance(fs::directory_iterator(root_ / "deep"), fs::directory_iterator()), 1);
}

TEST_F(OutputFolderTest, LeavesNothingWithoutCommit) {
  {
    const OutputFolder folder((root_ / "deep" / "out").string());
    folder.write("a.txt", "a");
    EXPECT_EQ(n_entries(), 1);
  }
  EXPECT_EQ(n_entries(), 0);
}

TEST_F(OutputFolderTest, ReplacesItsOwnFilesOnly) {
  const fs::path target = root_ / "out";
  fs::create_directories(target / "fields");
  write(target / "a.txt", "old");
  write(target / "notes.txt", "mine");
  write(target / "fields" / "notes.txt", "mine");
  {
    const OutputFolder abandoned(target.string());
    abandoned.write("a.txt", "half");
  }
  EXPECT_EQ(read(target / "a.txt"), "old");
  OutputFolder folder(target.string());
  folder.write("a.txt", "new");
  folder.write("fields/b.txt", "b");
  folder.commit();
  EXPECT_EQ(read(target / "a.txt"), "new");
  EXPECT_EQ(read(target / "fields" / "b.txt"), "b");
  EXPECT_EQ(read(target / "notes.txt"), "mine");
  EXPECT_EQ(read(target / "fields" / "notes.txt"), "mine");
  EXPECT_EQ(n_entries(), 1);
}

TEST_F(OutputFolderTest, RemovesOlderFilesOfThePatternsOnly) {
  const fs::path target = root_ / "out";
  fs::create_directories(target / "fields" / "fields_0009.vtu");
  for (const char* name : {"fields.pvd", "notes.txt", "fields/fields_0001.vtu", "fields/fields_0002.vtu",
                           "fields/fields_mine.vtu", "fields_0001.vtu"})
    write(target / name, "old");
  const std::vector<std::string> ours{"fields.pvd", "fields/fields_[0-9]*.vtu", "absent/*"};
  OutputFolder fewer(target.string());
  fewer.write("fields/fields_0001.vtu", "new");
  fewer.commit(ours);
  EXPECT_EQ(read(target / "fields" / "fields_0001.vtu"), "new");
  EXPECT_FALSE(fs::exists(target / "fields.pvd"));
  EXPECT_FALSE(fs::exists(target / "fields" / "fields_0002.vtu"));
  for (const char* name : {"notes.txt", "fields/fields_mine.vtu", "fields/fields_0009.vtu", "fields_0001.vtu"})
    EXPECT_TRUE(fs::exists(target / name)) << name;
  OutputFolder none(target.string());
  none.write("a.txt", "new");
  none.commit(ours);
  EXPECT_FALSE(fs::exists(target / "fields" / "fields_0001.vtu"));
  EXPECT_TRUE(fs::exists(target / "fields" / "fields_mine.vtu"));
}

/// The content of a file in an open folder; "" if there is no such file.
std::string read_in(int folder, const char* file) {
  char text[20];
  const int descriptor = openat(folder, file, O_RDONLY);
  if (descriptor < 0) return "";
  const auto n = ::read(descriptor, text, sizeof text);
  close(descriptor);
  return std::string(text, n > 0 ? static_cast<std::size_t>(n) : 0);
}

TEST_F(OutputFolderTest, AReaderNeverMeetsAMixture) {
  const fs::path target = root_ / "out";
  std::atomic<bool> over{false};
  int n_read = 0, n_mixed = 0;
  std::thread reader([&] {
    while (!over) {
      const int folder = open(target.c_str(), O_RDONLY | O_DIRECTORY);
      if (folder < 0) continue;
      const std::string a = read_in(folder, "a.txt"), z = read_in(folder, "z.txt");
      close(folder);
      if (a.empty() || z.empty()) continue;  // the older result is being removed
      ++n_read;
      if (a != z) ++n_mixed;
    }
  });
  for (int i = 0; i < 500; ++i) {
    OutputFolder folder(target.string());
    for (const char* name : {"a.txt", "b.txt", "c.txt", "z.txt"}) folder.write(name, std::to_string(i));
    folder.commit();
  }
  over = true;
  reader.join();
  EXPECT_GT(n_read, 100);
  EXPECT_EQ(n_mixed, 0) << "of " << n_read;
  EXPECT_EQ(n_entries(), 1);
}

TEST_F(OutputFolderTest, StaysInTheFolderThatSomebodyWorksIn) {
  const fs::path target = root_ / "out", before = fs::current_path();
  fs::create_directories(target / "mine");
  write(target / "a.txt", "old");
  fs::current_path(target);
  OutputFolder here(".");
  here.write("a.txt", "new");
  here.commit();
  EXPECT_EQ(read("a.txt"), "new") << "the working folder is the same one";
  fs::current_path(before);
  EXPECT_TRUE(fs::is_directory(target / "mine"));
}

TEST_F(OutputFolderTest, RemovesWhatKilledProcessesLeft) {
  const fs::path killed = root_ / ".out.partial-1", other = root_ / ".other.partial-1",
                 fresh = root_ / ".out.partial-2";
  for (const fs::path& folder : {killed, other, fresh}) {
    fs::create_directory(folder);
    write(folder / "a.txt", "half");
    if (folder != fresh) fs::last_write_time(folder, fs::file_time_type::clock::now() - std::chrono::minutes(2));
  }
  const OutputFolder first((root_ / "out").string());
  EXPECT_FALSE(fs::exists(killed));
  EXPECT_TRUE(fs::exists(other)) << "of another result";
  EXPECT_TRUE(fs::exists(fresh)) << "may be about to be used";
  fs::last_write_time(fs::path(first.path("a")).parent_path(),
                      fs::file_time_type::clock::now() - std::chrono::hours(1));
  const OutputFolder second((root_ / "out").string());
  EXPECT_TRUE(fs::exists(fs::path(first.path("a")).parent_path())) << "a slow process that still lives";
}

TEST_F(OutputFolderTest, SaysWhatStandsInTheWay) {
  write(root_ / "file", "");
  const std::string cure = "; choose another folder with --out DIR", root = root_.string();
  EXPECT_EQ(refusal(root + "/file"), "the output folder '" + root + "/file' is a file" + cure);
  EXPECT_EQ(refusal(root + "/file/out"),
            "cannot write beside the output folder '" + root + "/file/out': Not a directory" + cure);
  EXPECT_EQ(refusal(root + "/file/deep/out"),
            "cannot make the folder '" + root + "/file/deep': Not a directory" + cure);
  EXPECT_EQ(refusal(""), "the output folder has no name" + cure);
  fs::create_directories(root_ / "out" / "a.txt");
  EXPECT_EQ(refusal(root + "/out"), "'" + root + "/out/a.txt' is a folder, not a file" + cure);
  EXPECT_EQ(n_entries(), 2);
}

TEST_F(OutputFolderTest, KnowsMissingRightsAtOnce) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  fs::create_directory(root_ / "locked");
  fs::permissions(root_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(OutputFolder((root_ / "locked" / "out").string()), InputError);
  EXPECT_THROW(OutputFolder((root_ / "locked").string()), InputError);
}

}  // namespace files_test
}  // namespace upbead
