// The factor of the strength at which the ground fails, from answers at single factors.
#pragma once

#include <optional>
#include <string>

#include "fem/limit_state.h"

namespace upbead {

/// Chooses the factors that are tried, and keeps what was found there. Factors without an answer make no bound.
class FactorSearch {
 public:
  static constexpr double largest = 20., smallest = 1. / 16.;
  static constexpr double closeness = 0.005;  ///< of the bracket, relative

  /// `first`: the factor to be tried first, within the bounds; `growth`: from one that rests to the next.
  explicit FactorSearch(double first = 1., double growth = 2.) : first_(first), growth_(growth) {}

  /// The factor to be tried next; none where the bracket is close, or cannot be made closer.
  std::optional<double> next() const;
  void take(double F, const LimitAnswer& answer);
  /// Share of the work that is done, by the bracket's width.
  double done() const;

  const std::optional<double>& lower() const { return lower_; }
  const std::optional<double>& upper() const { return upper_; }
  /// Why the bracket is not as close as asked for; empty where it is.
  std::string why() const;

 private:
  std::optional<double> between() const;

  double first_, growth_;
  std::optional<double> lower_, upper_;
  std::optional<double> open_from_, open_to_;  ///< factors without an answer, between the bounds
  double estimate_ = 1.;                       ///< by the last motion in which the ground failed
  int rests_ = 0;                              ///< since the ground failed last
};

}  // namespace upbead
