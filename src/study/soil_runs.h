// Runs of a study that differ in their soils: one model answers all of them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "soils/soil_model.h"
#include "study/study.h"
#include "upbead/case/case.h"

namespace upbead {

/// Fewer different soils than these cost less when each is solved: docs/soils.md.
constexpr std::size_t least_soils = 24;

/// Numbers of runs that one model may answer: of one case, with the same settings but for those of soils, loads,
/// sliding and limits, and of at least least_soils different soils; none where the study does not share soils.
std::vector<std::vector<int>> soil_groups(const Study& study);

/// Models of such groups; the last one is kept.
class SoilRuns {
 public:
  explicit SoilRuns(const Study& study) : study_(study), groups_(soil_groups(study)) {}

  /// A run as a member of its group's model, which is made when it is first asked for. None where it is in no group,
  /// where its group has no model, and where the estimate of its error exceeds its scene's tolerance.
  std::optional<Simulation> member(int run, const Case& problem, const std::shared_ptr<const Mesh>& mesh,
                                   const std::function<void()>& meanwhile);
  /// Why the group of the last run has no model, or the run itself is none of it; "" where it is.
  const std::string& why_not() const { return why_not_; }
  /// The last run could not be solved as a member.
  void refuse(const std::string& why) { why_not_ = why; }

 private:
  Case case_of(int run) const;
  void make(int group, const std::shared_ptr<const Mesh>& mesh, const std::function<void()>& meanwhile);

  const Study& study_;
  std::vector<std::vector<int>> groups_;
  int made_ = -1;                     ///< the group of the model
  std::unique_ptr<SoilModel> model_;  ///< null where it has none
  std::string why_no_model_, why_not_;
};

}  // namespace upbead
