// Claim: what kills a trial run does not kill the program, and what it does is not seen outside.
#include "upbead/base/trial_run.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace upbead {

TEST(TrialRun, TellsTheEndByASignal) {
  EXPECT_FALSE(survives("file", [] { std::abort(); }));
  EXPECT_FALSE(survives("file", [] { std::raise(SIGSEGV); }));
  EXPECT_FALSE(survives("file", [] { std::raise(SIGXCPU); }));  // of work without end
  EXPECT_FALSE(survives("file", [] { std::_Exit(1); }));        // a library that ends the program
}

TEST(TrialRun, TellsNothingElse) {
  EXPECT_TRUE(survives("file", [] {}));
  EXPECT_TRUE(survives("file", [] { throw std::runtime_error("told when it is done in earnest"); }));
}

TEST(TrialRun, LeavesNothingBehind) {
  int n = 0;
  EXPECT_TRUE(survives("file", [&n] { n = 1; }));
  EXPECT_EQ(n, 0);
}

}  // namespace upbead
