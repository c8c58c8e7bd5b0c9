// The times at which the response of a reduced model to a wave is computed.
#pragma once

#include <optional>

#include "respond/wave_files.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead {

/// Begins at 0 and ends where the response ends; contains every time of the waves up to there.
struct WaveGrid {
  std::vector<double> time;         ///< s
  std::optional<double> equal;      ///< the step, where all are equal (s)
  std::size_t first = 0;            ///< index of the waves' first time
  std::optional<std::size_t> last;  ///< index of the waves' last time, where the grid goes on after it
};

/// When the answer to a file's waves ends (s): not before `end`, and `echo` after the last of their loads, but with a
/// file that is cut off under load.
double end_of_answer(const WaveFile& file, double end, double echo);

/// No part of the grid is longer than `longest_step` (s). Times that start at 0 with equal steps no longer than that
/// are kept, and continue with the same step up to `end` or the first time past it; longer steps are cut into equal
/// parts if these meet `end`. Throws InputError (without a place) where there would be more than 10,000,000 times.
WaveGrid make_wave_grid(const std::vector<double>& time, double longest_step, double end);

/// A wave at the times of the grid, K rows; straight between its own times and zero outside them.
WaveSamples on_grid(const WaveFile& file, int wave, const std::vector<double>& time);

/// The same for the exact response: loads jump from zero to their first value, and from their last value to zero.
SampledLoads with_jumps(const WaveSamples& samples, const WaveGrid& grid);

/// Equally spaced times from 0 to `until` or just past it, to compute frequencies: those of the grid where they are
/// equal; else not farther apart than the grid's, but never closer than a tenth of `longest_step`.
std::vector<double> equal_times(const WaveGrid& grid, double longest_step, double until);

}  // namespace upbead
