// How an uncertain quantity scatters, and random numbers to draw it by.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "upbead/base/error.h"

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

enum class ScatterKind { normal, lognormal, uniform, triangular };

/// How long a draw holds.
enum class Per { life, storm, wave };

/// What a person tells of it. Mean and deviation are those of the whole distribution, before its ends are cut.
struct Scatter {
  ScatterKind kind = ScatterKind::normal;
  std::optional<double> mean;       ///< of normal and lognormal; none: as of where it is used
  std::optional<double> cov;        ///< deviation over mean, of normal and lognormal; or deviation
  std::optional<double> deviation;  ///< standard deviation, of normal and lognormal
  std::optional<double> mode;       ///< most likely value, of triangular
  std::optional<double> low, high;  ///< ends of uniform and triangular; where normal and lognormal are cut
  Per per = Per::storm;
};

/// Everything that contradicts itself in a scatter. `mean`: where it gives none.
Diagnostics diagnose(const Scatter& scatter, double mean);

/// One value for each u in (0, 1), by the inverse of the distribution function; cut ends are left out and the rest is
/// scaled up.
class Distribution {
 public:
  /// Throws std::invalid_argument where something contradicts itself.
  Distribution(const Scatter& scatter, double mean);
  double quantile(double u) const { return quantile_(u); }
  Per per() const { return per_; }

 private:
  std::function<double(double)> quantile_;
  Per per_;
};

}  // namespace upbead
