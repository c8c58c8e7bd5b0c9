// Fields for ParaView: one VTU file for each written time, and a PVD file that lists them.
#pragma once

#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "fem/unknowns.h"
#include "fem/yielding_soil.h"
#include "output/vtu_file.h"
#include "upbead/system/system.h"

namespace upbead {

/// Patterns of the files that a FieldWriter writes, for OutputFolder::commit().
inline const std::vector<std::string> field_files{"fields.pvd", "fields/fields_[0-9][0-9][0-9][0-9]*.vtu"};

/// State of yielding soil, by active cell index.
struct SoilFields {
  std::vector<std::vector<BorneStress>> borne;  ///< at the points of quadrature; none for cells that stay elastic
  std::vector<double> dissipated;               ///< since rest (J/m3); 0 for cells that stay elastic
};

/// Writes displacement, velocity, acceleration, pore pressure, strain and effective stress (for solid regions:
/// stress), each with its unit in its name; where soil yields also the energy that it has lost and the share of
/// strength that it mobilises, by cell. VTU holds single precision: the files are for pictures, not a record.
class FieldWriter {
 public:
  /// `path_of`: gives the path for a file name, such as OutputFolder::path. Files may still be in writing when the
  /// simulation is gone, so the writer shares ownership of what it needs. Without inertia there is no acceleration.
  FieldWriter(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Space> space,
              std::shared_ptr<const Unknowns> unknowns, bool inertia,
              std::function<std::string(const std::string&)> path_of);

  /// Follows soil that yields: its state is read at every file from now on.
  void follow(YieldingSoil& soil) { soil_ = &soil; }
  /// Returns while the file is still being written, which takes longer than the steps between two files: the march
  /// goes on, and each core may write one file. Failures are thrown by a later call. Throws InputError where the disk
  /// is full or refuses.
  void write(const State& state);
  /// Times and names of the files so far, all of them complete.
  const std::vector<std::pair<double, std::string>>& written() const;
  /// Counts files as written that exist already.
  void take_over(const std::vector<std::pair<double, std::string>>& written);
  /// Writes fields.pvd; to be called once, at the end. Throws InputError where the disk is full or refuses.
  void finish() const;

 private:
  void write_file(const State& state, const SoilFields& soil, const std::string& name, const std::string& path) const;
  SoilFields soil_fields() const;
  /// Waits until at most that many files are still being written.
  void wait(std::size_t most = 0) const;

  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const Space> space_;
  std::shared_ptr<const Unknowns> unknowns_;
  bool inertia_;
  YieldingSoil* soil_ = nullptr;
  std::function<std::string(const std::string&)> path_of_;
  std::vector<std::pair<double, std::string>> written_;
  mutable std::once_flag grid_made_;
  mutable VtuGrid grid_;                           ///< of all files, made with the first file
  mutable std::deque<std::future<void>> pending_;  ///< the last member, as all others must outlive these tasks
};

}  // namespace upbead
