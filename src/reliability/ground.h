// A section on the ground of a reduced model, whose soil may be random: F_T and the forces on the base in one wave.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "design/design_tables.h"
#include "soils/soil_answers.h"
#include "upbead/base/error.h"

namespace upbead {

/// One wave on one soil.
struct GroundWave {
  Section section;  ///< at its water level, with the factors of mu and W
  Water water;
  DesignWave wave;
  WaveFactors factors;            ///< of P and U
  Soil soil;                      ///< all keys of the model's box; empty where it has one soil
  std::optional<double> sliding;  ///< S that is too far (m)
};

/// What that wave does, per metre.
struct GroundPoint {
  double resistance = 0.;         ///< mu (W' + dW') (N/m)
  double force = 0.;              ///< largest F_T + mu U, with a push of still water (N/m)
  std::optional<double> holding;  ///< the resistance with which S is `sliding` (N/m)
  std::optional<WorstBase> base;  ///< none where the model has no readings of it
  std::string why_not{};          ///< why the soil has no answer, which counts as a failure; then there is nothing else
};

/// Whether limit states by F_T are asked for: [reliability] dynamics, or a variable that acts on soil.
bool asks_for_ground(const DesignTables& tables);

/// Whether a variable acts on a key of soil.
bool is_of_soil(const std::string& acts_on);

/// Keeps the models of the soils that it was asked for last.
class ModelledGround {
 public:
  /// Reads the model of [dynamics]. Throws InputError with every mistake at `place`.
  ModelledGround(const DesignTables& tables, const std::string& file, const Place& place);
  /// All keys of the box, with the values of [dynamics] soil, else of the model's case; empty for one soil.
  Soil soil() const { return soils_ ? soils_->whole(soil_) : Soil(); }
  /// The box; empty for one soil.
  std::vector<SoilAxis> box() const { return soils_ ? soils_->file().box : std::vector<SoilAxis>(); }
  /// Of a key of the box.
  std::string unit(const std::string& key) const { return soils_->unit(key); }
  bool knows_base() const { return knows_base_; }
  /// Of the scene of the model.
  const NumberedWarnings& warnings() const { return warnings_; }

  /// Throws NumericsError where a soil cannot be answered.
  GroundPoint at(const GroundWave& asked);
  /// Estimate of the error of F_T in that wave, over its peak, by the nested models of the soil; none without these.
  std::optional<double> error(const GroundWave& asked);

 private:
  /// The model of a soil, and what tells its error.
  struct Held {
    ShearModel shear;
    std::shared_ptr<const NestedModels> nested;
  };
  const Held& held(const Soil& soil);
  Breakwater breakwater_of(const GroundWave& asked) const;
  /// Of samples in time (s).
  double step_of(const Breakwater& breakwater, const GroundWave& asked) const;
  Held held_of(const ReducedModelFile& file) const;
  /// Keeps the first model, and what is to be told of it.
  void tell(const ReducedModelFile& file);

  DynamicsTable table_;
  Breakwater certain_;
  ImpactAssumptions impact_;
  Place place_;
  Soil soil_;
  std::optional<SoilAnswers> soils_;
  bool knows_base_ = false;
  NumberedWarnings warnings_;
  std::map<Soil, Held> kept_;
};

/// Checks [dynamics] and the variables that act on its soil: each within the box of the model. Completes the soil of
/// [dynamics] with the keys that are not given.
void check_ground(DesignTables& tables, const Document& document, Diagnostics& report);

}  // namespace upbead
