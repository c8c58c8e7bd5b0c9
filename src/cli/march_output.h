// What a run writes while it marches: fields at the times that the case asks for, and checkpoints, which --checkpoint
// writes and from which --resume continues.
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
  /// Where the scene asks for no fields, nothing is written and `folder` may be null. Of several processes the first
  /// one writes, and `folder` is null on the others. Scene and folder must outlive this.
  FieldOutput(const Scene& scene, const OutputFolder* folder) : scene_(scene), folder_(folder) {}

  /// Starts the output of the scene that will be marched; the simulation must outlive this.
  MarchObserver* begin(const Simulation& simulation);
  /// Follows yielding soil that is about to be marched.
  void follow(YieldingSoil& soil);
  /// Writes the fields where they are due.
  void see(const State& state, int step, int n_steps) override;
  bool wants(double time) const override;
  void finish() const;
  double seconds() const { return seconds_; }  ///< time spent on writing (s)

  /// Times (s) and names, relative to the folder, of the files so far.
  std::vector<std::pair<double, std::string>> written() const;
  /// Takes over files from another folder, as if they had been written here.
  void take_over(const std::string& from, const std::vector<std::pair<double, std::string>>& written);
  /// Links or copies the files written so far into another folder, where they are missing.
  void lay_into(const std::string& other) const;

 private:
  void write(const State& state);

  const Scene& scene_;
  const Simulation* marched_ = nullptr;
  YieldingSoil* soil_ = nullptr;
  std::optional<FieldWriter> writer_;
  std::vector<std::pair<double, std::string>> taken_over_;
  const OutputFolder* folder_;
  double seconds_ = 0.;
};

struct CheckpointWish {
  double every = 0.;  ///< wall time between two checkpoints (s); 0: none are kept
  bool resume = false;
};

/// Checkpoints are kept in RESULTS.checkpoint, beside the folder of the results. They are written at intervals of
/// wall time and when the run is interrupted, and removed once the results are written. A new checkpoint replaces the
/// old one in a single step.
class Checkpoints {
 public:
  /// Reads the checkpoint from which to resume. Throws InputError where it belongs to another case, mesh, history or
  /// version of the program, or is damaged.
  Checkpoints(const Case& input, const std::string& results, const CheckpointWish& wish);

  /// Starts the checkpoints of a march, and takes over the fields that have been written. `writes`: of several
  /// processes the first one alone. `fields` and this must outlive the march.
  Checkpointing begin(FieldOutput& fields, bool writes);
  /// Throws InputError where the march to resume was of fewer cells, as those that no wave reaches until its end.
  void require_fit(const Case& input, const Simulation& simulation) const;
  /// What the user reads about resuming; "" where nothing is resumed.
  std::string account() const;
  void remove() const;

 private:
  void keep(const MarchCheckpoint& march, const FieldOutput& fields);

  std::string title_, folder_;
  CheckpointWish wish_;
  std::uint64_t fingerprint_ = 0;
  std::optional<CheckpointFile> found_;
  Stopwatch since_last_;
};

}  // namespace upbead
