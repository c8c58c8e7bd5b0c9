// Histories of readings that are asked for by name, and how wrong a model of soils has them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/wave_response.h"
#include "respond/wave_reading.h"

namespace upbead {

/// Readings by name; `fewer`: the same soil in fewer coordinates, which has these readings, too (null: none), and the
/// factor on the difference, which is the estimate of the error.
struct AskedHistories {
  std::vector<std::string> names;
  std::shared_ptr<const ModalModel> fewer;
  double safety = 0.;
};

/// Throws InputError with the model's readings where it has none of a name, or a name is given twice.
void require_readings(const std::vector<ReadingLabel>& labels, const std::vector<std::string>& names);

/// Answers the waves of one file on their grid.
class WaveHistories {
 public:
  WaveHistories(const ModalModel& model, const AskedHistories& asked, const WaveGrid& grid);
  /// Makes room for n waves.
  std::vector<WaveHistory> empty(int n_waves, const WaveGrid& grid) const;
  /// Sets one wave of each history; may be called for different waves at the same time.
  void answer(const WaveSamples& loads, const WaveGrid& grid, bool ends_at_zero, int wave,
              std::vector<WaveHistory>& out) const;

 private:
  struct Asked {
    ReadingLabel label;
    WaveReading full;
    std::unique_ptr<WaveReading> fewer;
  };
  std::vector<Asked> list_;
  double safety_;
};

}  // namespace upbead
