// Results of a verification test: checks with their limits, and curves. Each check is asserted at once and recorded;
// postprocess/verification.py makes docs/reference/verification.md from the records.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace upbead::test {

/// Points of a curve: the exact and the computed values, at the same abscissae.
struct Curve {
  std::string panel;  ///< title of the panel that it is drawn in: "pressure at the base"
  std::string x, y;   ///< labels of the axes, with units
  std::string label;  ///< of this curve: "k = 1e-5 m/s"
  std::vector<double> abscissa, exact, computed;
};

/// The results of one test. When it goes out of scope it is written, as the file SUITE.TEST.json, to the folder that
/// the environment variable UPBEAD_VERIFICATION_RESULTS names; if that is not set, it is not written.
class Record {
 public:
  /// `problem`: key of tests/verification/problems.toml.
  explicit Record(const std::string& problem);
  ~Record();
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;

  /// Asserts error <= limit (a NaN fails) and records both. `what`: the quantity that is compared, and its norm.
  void at_most(const std::string& what, double error, double limit);
  /// Asserts value >= limit: an order of convergence.
  void at_least(const std::string& what, double value, double limit);
  /// Records a number without a limit.
  void measured(const std::string& what, double value);
  void curve(const Curve& curve);

 private:
  nlohmann::json json_;
};

/// Slope of log(error) over log(h) by least squares: the order of convergence.
double order(const std::vector<double>& h, const std::vector<double>& error);

}  // namespace upbead::test
