// What `expected` and `calibrate` rest on: the record of sea states, the reduced model that answers waves, sliding
// laws.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/records/record_layout.h"
#include "design/expected_report.h"
#include "design_tables.h"
#include "expected/dynamic_law.h"
#include "upbead/base/error.h"
#include "upbead/expected/life.h"
#include "upbead/expected/sliding_law.h"

namespace upbead {

inline constexpr double steps_of_a_rise = 80.;  ///< of the answers, in the shortest rise of a force

/// Reads a CSV file with the columns significant_height (m), period (s), waves, and, on demand, angle (degrees) and
/// water_level (m), in any order; units in the header count, a counter is left out and added to `notes`. Throws
/// InputError with every mistake; a file that cannot be read is one at `place`.
std::vector<SeaState> read_sea_states(const std::string& path, const Place& place, RecordNotes& notes);

/// What `expected` takes of a model's file.
struct WaveModel {
  std::string title;
  std::string load;  ///< name of the load that is the wave
  ShearModel shear;
};

/// Reads it and chooses the load. Throws InputError with every mistake, at `place` (of [dynamics]): no caisson, no such
/// load, a load without horizontal force, or a mass that is not the section's weight within 1 %.
WaveModel read_wave_model(const std::string& path, const DynamicsTable& table, const Section& section,
                          const Water& water, const Place& place);

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
  /// At rest and in a wave, by its reduced model or by Goda's formulas; none where the model cannot tell.
  std::optional<WorstBase> base(Law law, const DrawnWave& wave) const;
  /// Why the law dynamic tells nothing about the base; "" where it does.
  std::string why_no_dynamic_base() const;
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
