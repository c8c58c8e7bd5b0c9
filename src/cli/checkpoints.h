// Checkpoints of a run: what --checkpoint keeps and --resume goes on from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/stopwatch.h"
#include "field_output.h"
#include "output/checkpoint_file.h"
#include "upbead/case/case.h"

namespace upbead {

struct CheckpointWish {
  double every = 0.;  ///< wall time between two (s); 0: none are kept
  bool resume = false;
};

/// Throws InputError at the keys of a case whose run keeps no checkpoints.
void check_checkpoints(const Case& input);

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
