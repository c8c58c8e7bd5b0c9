// Runs of a study that differ in their soils: one model answers all of them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "soils/soil_model.h"
#include "study/soil_families.h"

namespace upbead {

/// Models of the groups of a study, by the families in its folder; the last one is kept.
class SoilRuns {
 public:
  SoilRuns(const Study& study, std::string folder)
      : study_(study), folder_(std::move(folder)), groups_(soil_groups(study)) {}

  /// A run as a member of its group's model. None where it is in no group, where its group has no model, and where the
  /// estimate of its error exceeds its scene's tolerance.
  std::optional<Simulation> member(int run, const Case& problem, const std::shared_ptr<const Mesh>& mesh);
  /// Why the group of the last run has no model, or the run itself is none of it; "" where it is.
  const std::string& why_not() const { return why_not_; }
  /// The last run could not be solved as a member.
  void refuse(const std::string& why) { why_not_ = why; }

 private:
  void read(std::size_t group, const std::shared_ptr<const Mesh>& mesh);

  const Study& study_;
  std::string folder_;
  std::vector<std::vector<int>> groups_;
  std::optional<std::size_t> read_;   ///< the group of the model
  std::unique_ptr<SoilModel> model_;  ///< null where it has none
  std::string why_no_model_, why_not_;
};

}  // namespace upbead
