// What a run writes while it marches: fields at the times that the case asks for, and checkpoints, which --checkpoint
// keeps and --resume goes on from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/stopwatch.h"
#include "output/checkpoint_file.h"
#include "output/fields.h"
#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

class FieldOutput : public MarchObserver {
 public:
  /// Nothing is written where the scene asks for none, and then `folder` may be null. Both must outlive this.
  FieldOutput(const Scene& scene, const OutputFolder* folder) : scene_(scene), folder_(folder) {}

  /// Of the scene that will be marched, which must outlive this.
  MarchObserver* begin(const Simulation& simulation);
  /// Soil that yields and is about to be marched.
  void follow(YieldingSoil& soil);
  /// Writes where it is time.
  void see(const State& state, int step, int n_steps) override;
  bool wants(double time) const override;
  void finish() const;
  double seconds() const { return seconds_; }  ///< that writing has taken

  /// Times (s) and names, relative to the folder, of the files so far.
  std::vector<std::pair<double, std::string>> written() const;
  /// Takes files over from another folder, as if they had been written here.
  void take_over(const std::string& from, const std::vector<std::pair<double, std::string>>& written);
  /// Lays the files so far that are not there yet into another folder.
  void lay_into(const std::string& other) const;

 private:
  const Scene& scene_;
  std::optional<FieldWriter> writer_;
  std::vector<std::pair<double, std::string>> taken_over_;
  const OutputFolder* folder_;
  double seconds_ = 0.;
};

struct CheckpointWish {
  double every = 0.;  ///< wall time between two (s); 0: none are kept
  bool resume = false;
};

/// Kept in RESULTS.checkpoint, beside the folder of the results, by wall time and where the run is interrupted; removed
/// once the results are written. A checkpoint replaces the one before in one step.
class Checkpoints {
 public:
  /// Reads what there is to go on from. Throws InputError where that belongs to another case, mesh, history or version
  /// of the program, or is damaged.
  Checkpoints(const Case& input, const std::string& results, const CheckpointWish& wish);

  /// For the march; takes over the fields that have been written. `fields` and this must outlive the march.
  Checkpointing begin(FieldOutput& fields);
  /// What a person is told: "" where nothing is resumed.
  std::string account() const;
  void remove() const;

 private:
  bool due() const;
  void keep(const MarchCheckpoint& march, const FieldOutput& fields);

  std::string title_, folder_;
  CheckpointWish wish_;
  std::uint64_t fingerprint_ = 0;
  std::optional<CheckpointFile> found_;
  Stopwatch since_last_;
};

}  // namespace upbead
