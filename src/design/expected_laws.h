// The sliding laws of a design.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "expected/dynamic_law.h"
#include "expected_work.h"

namespace upbead {

/// Sound tables as a climate.
StormClimate climate_of(const StormsTable& table);

/// Storms from the median to that of which one in 10,000 is higher, at low and high tide.
std::vector<SeaState> typical_storms(const Design& design);

/// Safe to share between threads.
class Laws {
 public:
  /// Reads the reduced model where the design names one. `record`: for the step of its answers.
  Laws(const Design& design, const std::vector<SeaState>& record);
  std::unique_ptr<SlidingLaw> make(Law law, const SeaState& state) const;
  /// The law dynamic; only where there is a model.
  std::unique_ptr<DynamicLaw> dynamic(const SeaState& state) const;
  /// Those that can be made.
  std::vector<Law> known() const;
  /// The one to take where nobody says: dynamic where there is a model, else exact.
  Law best() const { return answer_ ? Law::dynamic : Law::exact; }
  const std::optional<ModelUsed>& model() const { return model_; }

 private:
  void read_model(const Design& design, const std::vector<SeaState>& record);

  Breakwater breakwater_;
  ImpactAssumptions impact_;
  std::optional<ModelUsed> model_;
  std::shared_ptr<const ShearAnswer> answer_;
};

}  // namespace upbead
