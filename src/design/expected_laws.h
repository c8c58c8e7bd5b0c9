// The basis of `expected` and `calibrate`: the record of sea states, the reduced model under the waves, the laws of
// sliding.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/records/sea_states.h"
#include "design/expected_report.h"
#include "design_tables.h"
#include "expected/dynamic_law.h"
#include "soils/soil_answers.h"
#include "upbead/base/error.h"
#include "upbead/expected/life.h"
#include "upbead/expected/sliding_law.h"

namespace upbead {

inline constexpr double steps_of_a_rise = 80.;  ///< steps of a response in the shortest rise of a force

/// The part of a model's file that `expected` uses.
struct WaveModel {
  std::string title;
  std::string load;  ///< name of the load that stands for the wave
  ShearModel shear;
  NumberedWarnings warnings;                        ///< of its scene
  std::shared_ptr<const ReducedModelFile> nodes{};  ///< the file, where it has contact node by node; else null
  std::optional<NestedModels> nested{};             ///< larger models, which tell errors of F_T; none in old files
  double tolerance = 0.;                            ///< that the model was made for, of F_T over its peak
};

/// Chooses the load of a reduced model. Throws InputError with every mistake, at `place` (of [dynamics]): no caisson,
/// no such load, a load without horizontal force, or a mass that differs from the section's weight by more than 1 %.
WaveModel wave_model(const ReducedModelFile& file, const DynamicsTable& table, const Section& section,
                     const Water& water, const Place& place);
/// The same of a file: of a reduced model, or of a model of soils with the soil of the table.
WaveModel read_wave_model(const std::string& path, const DynamicsTable& table, const Section& section,
                          const Water& water, const Place& place);

/// The reduced model of a soil. Throws InputError with every mistake at `place`, NumericsError as SoilAnswers does.
ReducedModelFile of_soil(const SoilAnswers& soils, const Soil& soil, const Place& place);

/// A table without mistakes as a climate.
StormClimate climate_of(const StormsTable& table);

/// Storms from the median to the storm that one in 10,000 exceeds, at low and high tide.
std::vector<SeaState> typical_storms(const Design& design);

/// The laws of sliding for a design. Safe to share between threads.
class Laws {
 public:
  /// Reads the reduced model where the design names one. `record`: determines the step of its responses.
  Laws(const Design& design, const std::vector<SeaState>& record);
  std::unique_ptr<SlidingLaw> make(Law law, const SeaState& state) const;
  /// The law `dynamic`; only where there is a model.
  std::unique_ptr<DynamicLaw> dynamic(const SeaState& state) const;
  /// The base at rest and in a wave, by the reduced model or by Goda's formulas; none where the model has no such
  /// readings.
  std::optional<WorstBase> base(Law law, const DrawnWave& wave) const;
  /// Why the law `dynamic` gives no results for the base; "" where it gives them.
  std::string why_no_dynamic_base() const;
  /// Whether ways() has an answer: the reduced model has slip circles, and readings of the base.
  bool knows_ways() const { return answer_ && answer_->circles(); }
  /// Every way to fail in a wave, by the reduced model; only where they are known.
  WaysToFail ways(const DrawnWave& wave) const;
  /// The same at rest.
  WaysToFail ways_at_rest() const;
  /// The model's circles; null where there are none.
  const CircleModel* circles() const { return circles_.get(); }
  /// The laws that can be made.
  std::vector<Law> known() const;
  /// The default law: dynamic where there is a model, else exact.
  Law best() const { return answer_ ? Law::dynamic : Law::exact; }
  const std::optional<ModelUsed>& model() const { return model_; }
  /// S of waves with slip and lift node by node; only where knows_nodes().
  std::vector<DearSlip> slips(const NodeAnswer& answer, const std::vector<SampledWave>& waves) const;
  bool knows_nodes() const { return nodes_ != nullptr; }
  /// Warnings reduced_model_error and no_error_estimate of F_T in a wave of that height, as respond tells them of its
  /// waves; none without a model.
  NumberedWarnings error_warnings(const SeaState& state, double height) const;

 private:
  void read_model(const Design& design, const std::vector<SeaState>& record);

  Breakwater breakwater_;
  ImpactAssumptions impact_;
  std::optional<ModelUsed> model_;
  std::shared_ptr<const WaveModel> of_file_;
  std::shared_ptr<const ShearAnswer> answer_;
  std::shared_ptr<const CircleModel> circles_;
  std::shared_ptr<const ReducedModelFile> nodes_;
  int load_ = 0;  ///< of the model, that is the wave
};

}  // namespace upbead
