// Claims: what a child says on stderr is its text without lines of progress, of which the last tells the share that is
// done; the end of a child is its exit code, and a program that is not there is a mistake of the installation.
#include "base/child_program.h"

#include <gtest/gtest.h>

#include "upbead/base/error.h"

namespace upbead {
namespace child_program_test {

TEST(ChildProgram, LinesOfProgressAreNoText) {
  double share = 0.;
  EXPECT_EQ(
      without_progress("\r\033[2Ksampling: 5 %\r\033[2Ksampling: 42 %, 12 s left\r\033[2Kwarning: x: do it\n", share),
      "warning: x: do it\n");
  EXPECT_EQ(share, 0.42);
  EXPECT_EQ(without_progress("no progress: 5 of 6\n", share), "no progress: 5 of 6\n");
  EXPECT_EQ(share, 0.42);
}

TEST(ChildProgram, OneThatIsMissingIsTold) {
  try {
    run_child("no-such-program", {}, "working");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no-such-program"), std::string::npos);
  }
}

TEST(ChildProgram, ItsEndIsItsExitCode) {
  // the programs of the system, from wherever this one lies
  const std::string up = "../../../../../../../../../../../../";
  EXPECT_EQ(run_child(up + "bin/sh", {"-c", "echo told >&2; exit 3"}, "working").code, 3);
  EXPECT_EQ(run_child(up + "bin/sh", {"-c", "echo told >&2; echo lost; exit 0"}, "working").told, "told\n");
  EXPECT_EQ(run_child(up + "bin/sh", {"-c", "kill -9 $$"}, "working").code, 128 + 9);
}

}  // namespace child_program_test
}  // namespace upbead
