// The distribution of an uncertain quantity, and the random numbers that it is drawn with.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

/// The place of a random number in the simulation: its life, storm, wave and purpose.
using StreamPlace = std::array<std::uint32_t, 4>;

/// Philox4x32-10 (Salmon et al. 2011, from their library Random123): the seed is the key, the place the counter. The
/// same seed gives the same number at the same place, on any number of threads and on any machine.
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

enum class ScatterKind { normal, lognormal, uniform, triangular };

/// What a value is drawn once for.
enum class Per { life, storm, wave };

/// A distribution as the user gives it. Mean and deviation are those of the whole distribution, before its ends are
/// cut.
struct Scatter {
  ScatterKind kind = ScatterKind::normal;
  std::optional<double> mean;       ///< of normal and lognormal; none: the default where it is used
  std::optional<double> cov;        ///< deviation over mean, of normal and lognormal; instead of deviation
  std::optional<double> deviation;  ///< standard deviation, of normal and lognormal
  std::optional<double> mode;       ///< most likely value, of triangular
  std::optional<double> low, high;  ///< ends of uniform and triangular; where normal and lognormal are cut
  Per per = Per::storm;
};

/// Every contradiction in a scatter. `mean`: used where the scatter gives none.
Diagnostics diagnose(const Scatter& scatter, double mean);

/// One value for each u in (0, 1), by the inverse of the distribution function. Where the ends are cut, the density
/// between them is scaled up.
class Distribution {
 public:
  /// Throws std::invalid_argument where diagnose() finds a contradiction.
  Distribution(const Scatter& scatter, double mean);
  double quantile(double u) const { return quantile_(u); }
  Per per() const { return per_; }

 private:
  std::function<double(double)> quantile_;
  Per per_;
};

}  // namespace upbead
