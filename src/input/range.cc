#include "input/range.h"

#include "base/numbers.h"
#include "upbead/input/node.h"

namespace upbead {

bool Range::contains(double value) const {
  return (value > low_ || (low_belongs_ && value == low_)) && (value < high_ || (high_belongs_ && value == high_));
}

std::string Range::text() const {
  if (low_ == -infinity && high_ == infinity && !high_belongs_) return "any finite number";
  return (low_belongs_ ? "[" : "(") + number_text(low_) + ", " + number_text(high_) + (high_belongs_ ? "]" : ")");
}

Range above(double low) {
  return {low, false, infinity, false};
}
Range at_least(double low) {
  return {low, true, infinity, false};
}
Range between(double low, double high) {
  return {low, false, high, false};
}
Range from_to(double low, double high) {
  return {low, true, high, true};
}
Range from_to_below(double low, double high) {
  return {low, true, high, false};
}

}  // namespace upbead
