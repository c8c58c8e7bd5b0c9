// The numbers that a key may take.
#pragma once

#include <limits>
#include <string>

namespace upbead {

/// An interval; infinity belongs to it only where or_infinite() says so, nan never.
class Range {
 public:
  /// Every finite number.
  Range() = default;
  Range(double low, bool low_belongs, double high, bool high_belongs)
      : low_(low), high_(high), low_belongs_(low_belongs), high_belongs_(high_belongs) {}

  Range or_infinite() const { return {low_, low_belongs_, high_, true}; }
  bool contains(double value) const;
  /// "[0, 0.5)", "any finite number".
  std::string text() const;

 private:
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
  bool low_belongs_ = false;
  bool high_belongs_ = false;
};

Range above(double low);                       ///< (low, inf)
Range at_least(double low);                    ///< [low, inf)
Range between(double low, double high);        ///< (low, high)
Range from_to(double low, double high);        ///< [low, high]
Range from_to_below(double low, double high);  ///< [low, high)

}  // namespace upbead
