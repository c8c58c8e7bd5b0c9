// What a verification test finds: checks with their limits, and curves. Each is asserted at once and written down, so
// that postprocess/verification.py can make docs/verification.md of it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace upbead::test {

/// Points of a curve: the exact solution and what the program computed, at the same abscissae.
struct Curve {
  std::string panel;  ///< title of the panel that it is drawn in: "pressure at the base"
  std::string x, y;   ///< labels of the axes, with units
  std::string label;  ///< of this curve: "k = 1e-5 m/s"
  std::vector<double> abscissa, exact, computed;
};

/// One test's findings; one record per test. Written, as the file SUITE.TEST.json, to the folder that the environment
/// variable UPBEAD_VERIFICATION_RESULTS names, when it goes out of scope; nowhere where that is not set.
class Record {
 public:
  /// `problem`: key of tests/verification/problems.toml.
  explicit Record(const std::string& problem);
  ~Record();
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  /// Asserts error <= limit (a NaN fails) and writes it down. `what` says what is compared, and how it is normed.
  void at_most(const std::string& what, double error, double limit);
  /// Asserts value >= limit: an order of convergence.
  void at_least(const std::string& what, double value, double limit);
  /// A measured number that nothing is asked of.
  void measured(const std::string& what, double value);
  void curve(const Curve& curve);

 private:
  nlohmann::json json_;
};

/// Slope of log(error) over log(h) by least squares: the order of convergence.
double order(const std::vector<double>& h, const std::vector<double>& error);

}  // namespace upbead::test
