// Waves as the user supplies them: CSV or HDF5 files with the loads of a reduced model over time.
#pragma once

#include <string>
#include <vector>

#include "base/numbers.h"
#include "case/records/record_layout.h"
#include "dynamics/batch_response.h"

namespace upbead {

/// The waves of one file, all at the same times; straight between these, zero before and after.
struct WaveFile {
  std::string name;          ///< of the file, without folder and ending; numbered where other files share it
  std::vector<double> time;  ///< N >= 2, ascending, not negative (s)
  WaveSamples value;         ///< N columns; the K loads of the first wave, then those of the second ...
  int n_loads = 0;
  RecordNotes notes;        ///< how the file was read
  bool rings_down = false;  ///< its times go on for as long as is asked for after its loads, as those of a case do

  int n_waves() const { return static_cast<int>(value.rows()) / n_loads; }
  /// The loads of a wave, K x N.
  auto wave(int w) const { return value.middleRows(w * n_loads, n_loads); }
};

/// Reads files for a model with those loads; loads that a file does not give are zero. `units`: of the loads (SI),
/// where known; a unit in the file is converted, and must be one of the same quantity.
/// - CSV: a column of times (s), then columns named like loads; of a model with one load, one column of any name.
/// - HDF5 (.h5, .hdf5): /time (N) and /LOAD, (waves x N) or (N), the latter for all waves of the file.
/// `end`: until when they are answered at least (s). Throws InputError with the mistakes of all files.
std::vector<WaveFile> read_wave_files(const std::vector<std::string>& paths, const std::vector<std::string>& loads,
                                      const std::vector<std::string>& units = {}, double end = infinity);

/// Of each kind the first, rather one that voids; `others` tells of the rest, after their number.
NumberedWarnings first_of_each(const NumberedWarnings& all, const std::string& others);

}  // namespace upbead
