// How an uncertain quantity scatters.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "upbead/base/objection.h"

namespace upbead {

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
std::vector<Objection> objections(const Scatter& scatter, double mean);

/// One value for each u in (0, 1), by the inverse of the distribution function; cut ends are left out and the rest is
/// scaled up.
class Distribution {
 public:
  /// Throws std::invalid_argument where there are objections.
  Distribution(const Scatter& scatter, double mean);
  double quantile(double u) const { return quantile_(u); }
  Per per() const { return per_; }

 private:
  std::function<double(double)> quantile_;
  Per per_;
};

}  // namespace upbead
