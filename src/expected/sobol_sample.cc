#include "expected/sobol_sample.h"

#include <boost/random/sobol.hpp>
#include <cmath>

#include "upbead/expected/distribution.h"

namespace upbead {

namespace {

constexpr int sobol_bits = 52,
              unused_bits = 64 - sobol_bits;  // so that half a unit more is exact in a double, and below 1

/// A random number of 52 bits for each dimension; draws of random samples have another last word.
std::uint64_t digital_shift(const Stream& stream, int dimension) {
  const auto words = stream.words({static_cast<std::uint32_t>(dimension), 0, 0, 1});
  return (static_cast<std::uint64_t>(words[0]) << 32U | words[1]) >> unused_bits;
}

}  // namespace

SobolSample::SobolSample(int n_points, int n_keys, std::uint64_t seed) : n_points_(n_points), n_keys_(n_keys) {
  const int n_dimensions = 2 * n_keys;
  boost::random::sobol sequence(static_cast<std::size_t>(n_dimensions));  // begins with its second point
  const Stream stream(seed);
  std::vector<std::uint64_t> shifts;
  for (int d = 0; d < n_dimensions; ++d) shifts.push_back(digital_shift(stream, d));
  for (int i = 0; i < n_points; ++i)
    for (const std::uint64_t shift : shifts) {
      const std::uint64_t digits = (i == 0 ? 0 : sequence() >> unused_bits) ^ shift;
      points_.push_back(std::ldexp(static_cast<double>(digits) + 0.5, -sobol_bits));
    }
}

double SobolSample::probability(int row, int key) const {
  const bool of_b = matrix(row) == 1 || matrix(row) == 2 + key;
  const int at = 2 * n_keys_ * point(row) + key + (of_b ? n_keys_ : 0);
  return points_[static_cast<std::size_t>(at)];
}

}  // namespace upbead
