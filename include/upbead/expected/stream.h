// Random numbers that can be drawn in any order: each belongs to a place, not to a sequence.
#pragma once

#include <array>
#include <cstdint>

namespace upbead {

/// A place of a random number: which life, storm and wave, and what for.
using StreamPlace = std::array<std::uint32_t, 4>;

/// Philox4x32-10 (Salmon et al. 2011, by their library Random123): the seed is its key, the place its counter. The same
/// seed gives the same number at the same place, on any number of threads and on any machine.
class Stream {
 public:
  explicit Stream(std::uint64_t seed);
  /// The generator's four words.
  std::array<std::uint32_t, 4> words(const StreamPlace& place) const;
  /// Uniform in (0, 1), never 0 or 1: 52 bits of the first two words.
  double uniform(const StreamPlace& place) const;

 private:
  std::uint64_t seed_;
};

}  // namespace upbead
