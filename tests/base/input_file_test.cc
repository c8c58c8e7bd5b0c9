// Claim: only regular files are read. An input without an end, or whose end may never come, is refused at once by its
// name, with a cure.
#include "base/text_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include <zlib.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace upbead {
namespace input_file_test {

namespace fs = std::filesystem;

class InputFiles : public testing::Test {
 protected:
  InputFiles() : folder_(fs::temp_directory_path() / ("upbead-input-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~InputFiles() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  static std::string refusal(const std::string& path) {
    try {
      read_text(path, 1'000'000'000, {"case.toml", 3, 1});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(InputFiles, PipesAreNotWaitedFor) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusal(path("pipe")),
            "case.toml:3:1: '" + path("pipe") +
                "' is a pipe, which may never end and can be read only once; write it into a file "
                "first and name that: COMMAND > FILE, in place of <(COMMAND)");
  fs::create_symlink(path("pipe"), path("link"));
  EXPECT_NE(refusal(path("link")).find("is a pipe"), std::string::npos);
}

TEST_F(InputFiles, DevicesFoldersAndSocketsAreNoFiles) {
  EXPECT_EQ(refusal("/dev/zero"), "case.toml:3:1: '/dev/zero' is a device; name a file");
  EXPECT_EQ(refusal(folder_.string()), "case.toml:3:1: '" + folder_.string() + "' is a folder; name a file in it");
  const int handle = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path("s").c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(bind(handle, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(refusal(path("s")), "case.toml:3:1: '" + path("s") + "' is a socket; name a file");
  close(handle);
}

TEST_F(InputFiles, WhatIsNotThereIsNoPageOfText) {
  EXPECT_EQ(refusal(path("none")), "case.toml:3:1: cannot read '" + path("none") + "'; check the path and the rights");
  EXPECT_LT(refusal(std::string(5'000'000, 'x')).size(), 200U);
}

TEST_F(InputFiles, APackedFileThatIsAllAlikeEndsEarly) {
  const gzFile file = gzopen(path("bomb.gz").c_str(), "wb9");
  const std::string piece(1'000'000, '0');
  for (int i = 0; i < 200; ++i) gzwrite(file, piece.data(), static_cast<unsigned>(piece.size()));
  gzclose(file);
  EXPECT_EQ(refusal(path("bomb.gz")),
            "case.toml:3:1: '" + path("bomb.gz") +
                "' unpacks to more than 100 times its size: so much alike is no record; is it the right file? else "
                "unpack it before");
  const gzFile small = gzopen(path("small.gz").c_str(), "wb9");
  for (int i = 0; i < 60; ++i) gzwrite(small, piece.data(), static_cast<unsigned>(piece.size()));
  gzclose(small);
  EXPECT_EQ(read_text(path("small.gz"), 1'000'000'000, {}).size(), 60'000'000U);
}

}  // namespace input_file_test
}  // namespace upbead
