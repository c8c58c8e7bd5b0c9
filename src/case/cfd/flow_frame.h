// From the axes of a CFD run to those of the scene, and the questions for keys that say how.
#pragma once

#include <string>
#include <vector>

#include "case/cfd/flow_keys.h"
#include "case/cfd/flow_record.h"

namespace upbead {

/// The directions landward and up as unit vectors in the axes of the record.
struct FlowFrame {
  Triple landward{}, up{}, across{};  ///< across = up x landward: a moment about it overturns
  std::array<double, 2> origin{0., 0.};

  std::array<double, 2> in_scene(const Triple& at) const;
};

double dot(const Triple& a, const Triple& b);

/// "y" of a vector along y.
std::string axis_name(const Triple& axis);

/// Collects the keys that are needed and not given, and reports all of them at once.
class FlowQuestions {
 public:
  explicit FlowQuestions(const FlowContext& context) : context_(context) {}
  bool given(const std::string& key) const;
  /// Reports that a key is needed: why, and what to write.
  void ask(const std::string& key, const std::string& why, const std::string& cure);
  void need(bool given, const std::string& key, const std::string& why, const std::string& cure) {
    if (!given) ask(key, why, cure);
  }
  /// Reports that a key is wrong.
  void object(const std::string& key, const std::string& what, const std::string& cure);
  void answer() const { mistakes_.throw_if_any(); }

 private:
  const FlowContext& context_;
  Diagnostics mistakes_;
};

/// Asks for the keys of the frame: always landward; up and origin where `places` is true. Call answer() of the
/// questions before the frame is used.
FlowFrame frame_of(const FlowKeys& source, bool places, FlowQuestions& questions);

/// Rows of the record in which the water is still; asks for another key where there is no such row.
std::vector<std::size_t> still_rows(const std::vector<double>& time, const FlowKeys& source, FlowQuestions& questions);

double mean_of(const std::vector<double>& values, const std::vector<std::size_t>& rows);

/// First row of the run; objects where fewer than two rows are left.
std::size_t first_row(const std::vector<double>& time, const FlowKeys& source, FlowQuestions& questions);

}  // namespace upbead
