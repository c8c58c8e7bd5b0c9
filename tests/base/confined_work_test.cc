// Claim: confined work can compute and return a result of any size, and nothing else; everything else that it tries
// is refused and reported, and so is the way in which it ends.
#include "base/confined_work.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/parcel.h"
#include "upbead/base/error.h"

namespace upbead {
namespace confined_work_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const ConfinedLimits generous;

/// Which calls failed, as a text: x for each that returned below zero, - for the others.
std::string failed(std::initializer_list<long> results) {
  std::string text;
  for (const long result : results) text += result < 0 ? "x" : "-";
  return text;
}

class ConfinedWork : public testing::Test {
 protected:
  ConfinedWork() { fs::create_directories(folder_); }
  ~ConfinedWork() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return path(name);
  }

  const fs::path folder_ = fs::temp_directory_path() / ("upbead_confined_" + std::to_string(getpid()));
};

TEST_F(ConfinedWork, HandsBackWhatItFound) {
  const ConfinedOutcome outcome = work_confined([] { return std::string("found"); }, generous);
  EXPECT_EQ(outcome.result, "found");
  EXPECT_EQ(outcome.end, "");
  EXPECT_THAT(outcome.refused, IsEmpty());
  EXPECT_TRUE(outcome.confined) << "this machine has neither seccomp nor Landlock";
}

TEST_F(ConfinedWork, HandsBackMoreThanAPipeHolds) {
  std::string large(30'000'000, '\0');
  for (std::size_t i = 0; i < large.size(); ++i) large[i] = static_cast<char>(i % 251);
  EXPECT_TRUE(work_confined([&large] { return large; }, generous).result == large);
  EXPECT_EQ(work_confined([] { return std::string(); }, generous).result, "");
}

TEST_F(ConfinedWork, LeavesNothingBehind) {
  int n = 0;
  std::cout << "once" << std::flush;
  work_confined(
      [&n] {
        std::cout << "never seen" << std::flush;
        n = 1;
        return std::string();
      },
      generous);
  EXPECT_EQ(n, 0);
}

TEST_F(ConfinedWork, ReadsFiles) {
  const std::string file = write("input", "content");
  const auto outcome = work_confined(
      [&file] {
        std::string text;
        std::ifstream(file) >> text;
        return text + std::to_string(fs::exists(file)) + std::to_string(fs::exists(file + "x"));
      },
      generous);
  EXPECT_EQ(outcome.result, "content10");
}

TEST_F(ConfinedWork, DoesNotSeeWhatIsHidden) {
  const std::string file = write("input", ""), option = write("input.opt", "content");
  ConfinedLimits limits;
  limits.hidden_ending = ".opt";
  const auto outcome = work_confined(
      [&] {
        struct stat found = {};
        return failed({stat(file.c_str(), &found), stat(option.c_str(), &found), stat("/no/where", &found)}) +
               std::to_string(found.st_size) + (std::ifstream(option).good() ? " open" : "");
      },
      limits);
  EXPECT_EQ(outcome.result, "-xx0 open");
  EXPECT_THAT(outcome.refused, IsEmpty());
}

TEST_F(ConfinedWork, ChangesNoFiles) {
  const std::string old = write("old", "content"), made = path("made");
  const auto outcome = work_confined(
      [&] {
        return failed({open(made.c_str(), O_WRONLY | O_CREAT, 0600), open(old.c_str(), O_RDWR),
                       open(old.c_str(), O_RDONLY | O_TRUNC), open(path("").c_str(), O_TMPFILE | O_RDWR, 0600),
                       creat(made.c_str(), 0600), mkdir(made.c_str(), 0700), unlink(old.c_str()),
                       std::rename(old.c_str(), made.c_str()), link(old.c_str(), made.c_str()),
                       symlink(old.c_str(), made.c_str()), chmod(old.c_str(), 0), truncate(old.c_str(), 0)});
      },
      generous);
  EXPECT_EQ(outcome.result, "xxxxxxxxxxxx");
  EXPECT_THAT(outcome.refused, testing::Contains("write the file '" + made + "'"));
  EXPECT_THAT(outcome.refused, testing::Contains("make the folder '" + made + "'"));
  EXPECT_THAT(outcome.refused, testing::Contains("remove the file '" + old + "'"));
  std::string text;
  std::ifstream(old) >> text;
  EXPECT_EQ(text, "content");
  EXPECT_FALSE(fs::exists(made));
}

TEST_F(ConfinedWork, WritesIntoNoFileThatWasOpen) {
  const int beyond_the_pipe = 100, file = fcntl(open(write("old", "").c_str(), O_WRONLY), F_DUPFD, beyond_the_pipe);
  const auto outcome = work_confined([file] { return failed({::write(file, "x", 1)}); }, generous);
  EXPECT_EQ(outcome.result, "x");
  close(file);
}

TEST_F(ConfinedWork, OpensNoConnections) {
  const auto outcome = work_confined(
      [] {
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_port = htons(9);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        const int other = ::socket(AF_UNIX, SOCK_DGRAM, 0);
        return failed({socket, other, connect(0, reinterpret_cast<sockaddr*>(&address), sizeof address)});
      },
      generous);
  EXPECT_EQ(outcome.result, "xxx");
  EXPECT_THAT(outcome.refused, ElementsAre("open a connection"));
}

TEST_F(ConfinedWork, StartsNoPrograms) {
  const std::string made = path("made");
  const auto exec = work_confined(
      [&] {
        execl("/bin/sh", "sh", "-c", ("touch " + made).c_str(), nullptr);
        return std::string("goes on");
      },
      generous);
  EXPECT_EQ(exec.result, "goes on");
  EXPECT_THAT(exec.refused, ElementsAre("start the program '/bin/sh'"));
  // glibc calls clone() with all signals blocked
  const auto shell = work_confined([&] { return std::to_string(std::system(("touch " + made).c_str())); }, generous);
  EXPECT_THAT(shell.refused, ElementsAre("start a program"));
  EXPECT_FALSE(shell.result);
  const auto copy = work_confined([] { return failed({fork()}); }, generous);
  EXPECT_THAT(copy.refused, ElementsAre("start a program"));
  EXPECT_FALSE(fs::exists(made));
}

TEST_F(ConfinedWork, SendsNoSignals) {
  const auto outcome = work_confined([] { return failed({kill(getppid(), SIGTERM)}); }, generous);
  EXPECT_EQ(outcome.result, "x");
  EXPECT_THAT(outcome.refused, ElementsAre("send a signal"));
}

TEST_F(ConfinedWork, MayUseThreads) {
  const auto outcome = work_confined(
      [] {
        int n = 0;
        std::thread([&n] { n = 7; }).join();
        return std::to_string(n);
      },
      generous);
  EXPECT_EQ(outcome.result, "7");
}

TEST_F(ConfinedWork, TellsHowItEnds) {
  const auto end_of = [](const std::function<void()>& work, ConfinedLimits limits = {}) {
    const ConfinedOutcome outcome = work_confined([&work] { return work(), std::string("done"); }, limits);
    return outcome.result.value_or(outcome.end);
  };
  EXPECT_THAT(end_of([] { std::raise(SIGSEGV); }), StartsWith("breaks down (Segmentation fault"));
  EXPECT_THAT(end_of([] { std::abort(); }), StartsWith("breaks down (Aborted"));
  EXPECT_EQ(end_of([] { std::exit(0); }), "ends the program");
  EXPECT_EQ(end_of([] { _exit(0); }), "ends without an answer");
  EXPECT_EQ(end_of([] { throw std::runtime_error("so it is"); }), "fails: so it is");
  EXPECT_EQ(end_of([] { throw 1; }), "fails: an unknown exception");
  ConfinedLimits quick;
  quick.seconds = 1.;
  volatile bool on = true;
  EXPECT_THAT(end_of(
                  [&on] {
                    while (on)
                      ;
                  },
                  quick),
              StartsWith("takes more than 1 s of computing"));
}

TEST_F(ConfinedWork, MistakesAreThrownHere) {
  const Place place{"file", 3, 4};
  try {
    work_confined([&]() -> std::string { throw InputError({{place, "what", "cure"}, {{}, "more", ""}}); }, generous);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "file:3:4: what; cure\nmore");
  }
}

#if !defined(__SANITIZE_ADDRESS__)
TEST_F(ConfinedWork, TakesNoMoreMemoryThanItMay) {
  ConfinedLimits limits;
  limits.memory = 200U << 20U;
  const auto outcome = work_confined(
      [] {
        std::vector<std::vector<char>> all;
        for (int i = 0; i < 1000; ++i) all.emplace_back(10U << 20U, 'x');
        return std::string("done");
      },
      limits);
  EXPECT_EQ(outcome.end, "asks for more than 200 MB of memory");
}

// Not with the address sanitizer: in a forked copy its allocator's locks stay held by threads that the copy lacks, so
// it would wait for ever; glibc's allocator releases them.
TEST_F(ConfinedWork, SeveralThreadsMayAsk) {
  std::vector<std::thread> threads;
  std::vector<std::string> results(4);
  for (std::string& result : results)
    threads.emplace_back([&result] {
      for (int i = 0; i < 10; ++i)
        result += work_confined([] { return std::string("y"); }, generous).result.value_or("n");
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& result : results) EXPECT_EQ(result, "yyyyyyyyyy");
}
#endif

TEST(Parcel, GivesBackWhatWasPut) {
  Parcel parcel;
  parcel.put(3.5);
  parcel.put(std::string("text"));
  parcel.put(std::vector<int>{1, 2, 3});
  parcel.put(std::vector<std::string>{"a", ""});
  parcel.put(Diagnostics{{{"f", 1, 2}, "w", "c"}});
  const std::string bytes = parcel.take();
  OpenParcel open(bytes);
  EXPECT_EQ(open.value<double>(), 3.5);
  EXPECT_EQ(open.text(), "text");
  EXPECT_EQ(open.list<int>(), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(open.texts(), (std::vector<std::string>{"a", ""}));
  EXPECT_EQ(to_string(open.diagnostics().list().at(0)), "f:1:2: w; c");
  EXPECT_THROW(open.value<char>(), std::runtime_error);
}

TEST(Parcel, IsNotBelievedWhereItIsTooShort) {
  for (const std::size_t said : {std::size_t{2}, std::size_t{1} << 62U, ~std::size_t{0}}) {
    Parcel parcel;
    parcel.put(said);
    parcel.put('x');
    const std::string bytes = parcel.take();
    EXPECT_THROW(OpenParcel(bytes).text(), std::runtime_error);
    EXPECT_THROW(OpenParcel(bytes).list<double>(), std::runtime_error);
    EXPECT_THROW(OpenParcel(bytes).texts(), std::runtime_error);
  }
}

}  // namespace confined_work_test
}  // namespace upbead
