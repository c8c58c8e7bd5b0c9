// Claim: the streams are Philox4x32-10, and a number depends only on its seed and its place in the stream.
#include "upbead/expected/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace upbead::test {
namespace stream_test {

TEST(Stream, GivesTheKnownAnswersOfPhilox) {  // from the file kat_vectors of Random123
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(Stream(0).words({0, 0, 0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(Stream(0xffffffffffffffff).words({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(Stream(0x299f31d0a4093822).words({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Stream, DoesNotDependOnTheOrderOfDrawing) {
  const Stream stream(42);
  std::vector<double> forth, back;
  for (std::uint32_t i = 0; i < 100; ++i) forth.push_back(stream.uniform({i, 3, 5, 7}));
  for (std::uint32_t i = 100; i-- > 0;) back.insert(back.begin(), Stream(42).uniform({i, 3, 5, 7}));
  EXPECT_EQ(forth, back);
}

TEST(Stream, EveryPartOfThePlaceAndTheSeedCount) {
  const double first = Stream(1).uniform({1, 1, 1, 1});
  EXPECT_NE(Stream(2).uniform({1, 1, 1, 1}), first);
  for (std::size_t i = 0; i < 4; ++i) {
    StreamPlace place{1, 1, 1, 1};
    place[i] = 2;
    EXPECT_NE(Stream(1).uniform(place), first) << i;
  }
}

TEST(Stream, IsUniformBetweenZeroAndOne) {
  const Stream stream(7);
  const int n = 100000, parts = 10;
  std::vector<int> count(parts, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = stream.uniform({i, 0, 0, 0});
    ASSERT_GT(u, 0.);
    ASSERT_LT(u, 1.);
    ++count[static_cast<std::size_t>(u * parts)];
  }
  for (const int c : count) EXPECT_NEAR(c, n / parts, 5. * std::sqrt(n / parts));
}

}  // namespace stream_test
}  // namespace upbead::test
