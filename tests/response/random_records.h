// Random force records of any length and speed, the same in every run.
#pragma once

#include <functional>
#include <random>
#include <string>

namespace upbead::test {

struct RandomRecord {
  std::string kind;
  double length = 0.;    ///< s
  double duration = 0.;  ///< of its fastest rise and fall (s)
  std::function<double(double)> value;
  bool cut = false;  ///< jumps to zero at its end
};

struct RecordRange {
  double shortest_length, longest_length, shortest_duration, longest_duration;  ///< s
};

/// Triangles, half sines, church roofs, double peaks, trains of pulses, decaying swings, noise that grows and decays,
/// slow rises with fast falls, records cut off; lengths and durations log-uniform.
class RandomRecords {
 public:
  RandomRecords(const RecordRange& range, unsigned seed) : range_(range), random_(seed) {}
  /// A record that begins with 0, and is 0 from its length on.
  RandomRecord next();

 private:
  double between(double low, double high);
  double log_between(double low, double high);

  RecordRange range_;
  std::mt19937 random_;
  int n_ = 0;
};

}  // namespace upbead::test
