// Slip and lift node by node of waves, on the reduced ground of a model.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "dynamics/ground_model.h"
#include "dynamics/readings_at.h"
#include "output/wave_response.h"
#include "respond/wave_grid.h"
#include "run/sliding/uplift_course.h"

namespace upbead {

namespace detail {
struct GroundStages;
}

/// The loads of one wave in time.
struct LoadsOfWave {
  std::vector<TimeFunction> history;
  Scene scene;      ///< with these loads, and the end: what chooses steps
  TimeFunction P;   ///< horizontal force on the caisson (N/m)
  double arm = 0.;  ///< of the largest of these, above the centre of gravity (m)
  Interface interface;
  std::vector<UpliftLoad> uplift;
};

/// Contact node by node under one law of friction; const, and safe to share between threads.
class WaveContacts {
 public:
  /// `sliding`: friction, W' and uplift where they are not the case's. The model has contact and must outlive this.
  WaveContacts(const ReducedModelFile& model, const std::optional<ModelSliding>& sliding);
  ~WaveContacts();

  /// Sets contact, response and why_not_contact of a wave whose bonded answer is there. `loads`: at the times of the
  /// grid; `batch`: of equal steps, and ends at zero.
  void answer(const WaveFile& file, int wave, double end, const WaveSamples& loads, const WaveGrid& grid,
              const ReadingsAt* at, WaveResponse& out) const;
  /// The same of loads that may have an interface and an uplift of their own. Where no model of the ground meets the
  /// tolerance, out.contact has what the largest says, and its error.
  void answer(const LoadsOfWave& functions, const WaveSamples& loads, const WaveGrid& grid, const ReadingsAt* at,
              WaveResponse& out) const;
  LoadsOfWave loads_of(const WaveFile& file, int wave, double end) const;
  const ModalModel& demand() const { return contact_.demand; }

 private:
  struct Marched;
  struct Room;

  std::vector<UpliftLoad> uplift_of(const LoadsOfWave& loads) const;
  double apparent_period(double s, double arm) const;
  TimeGrid steps_of(const LoadsOfWave& loads) const;
  const MarchedGround& ground(std::size_t number) const;
  Marched march_level(std::size_t number, const LoadsOfWave& loads, const TimeGrid& grid, Room& room) const;
  void march_wave(const LoadsOfWave& loads, WaveResponse& out) const;
  std::unique_ptr<Room> take_room() const;

  const ReducedModelFile& model_;
  const GroundModel& contact_;
  std::optional<ModelSliding> sliding_;
  Interface interface_;
  Eigen::RowVectorXd force_;  ///< P per unit of each load
  mutable std::mutex lock_;
  mutable std::vector<std::unique_ptr<MarchedGround>> grounds_;
  mutable std::vector<std::unique_ptr<Room>> rooms_;             ///< that no thread uses now
  mutable std::map<std::pair<double, double>, double> periods_;  ///< by s and arm
};

}  // namespace upbead
