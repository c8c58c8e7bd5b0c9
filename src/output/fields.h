// Fields for ParaView: one VTU file per written time and a PVD file that ties them together.
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

/// What soil that yields bears and has lost, by active cell index.
struct SoilFields {
  std::vector<std::vector<BorneStress>> borne;  ///< at the points of quadrature; none of cells that stay elastic
  std::vector<double> dissipated;               ///< since rest (J/m3); 0 of cells that stay elastic
};

/// Writes displacement, velocity, acceleration, pore pressure, strain and effective stress (of solid regions: stress),
/// each with its unit in its name; where soil yields also what it has lost and the share of strength that it
/// mobilises, by cell. VTU holds single precision: for pictures, not a record.
class FieldWriter {
 public:
  /// `path_of`: where to write a file of a name, such as OutputFolder::path. Files may still be written when whoever
  /// solves the scene has gone, so that the writer keeps what they are made of. Without inertia there is no
  /// acceleration.
  FieldWriter(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Space> space,
              std::shared_ptr<const Unknowns> unknowns, bool inertia,
              std::function<std::string(const std::string&)> path_of);

  /// Soil that yields, which is asked at every file from now on.
  void follow(YieldingSoil& soil) { soil_ = &soil; }
  /// Returns while the file is being written, which takes longer than the steps between two: the march goes on, and
  /// each core may write one. What fails is thrown by a later call. Throws InputError where the disk does not take it.
  void write(const State& state);
  /// Times and names of the files so far, all of them whole.
  const std::vector<std::pair<double, std::string>>& written() const;
  /// Counts files as written that lie there already.
  void take_over(const std::vector<std::pair<double, std::string>>& written);
  /// Writes fields.pvd; call once, last. Throws InputError where the disk does not take it.
  void finish() const;

 private:
  void write_file(const State& state, const SoilFields& soil, const std::string& name, const std::string& path) const;
  SoilFields soil_fields() const;
  /// Until no more than that many files are being written.
  void wait(std::size_t most = 0) const;

  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const Space> space_;
  std::shared_ptr<const Unknowns> unknowns_;
  bool inertia_;
  YieldingSoil* soil_ = nullptr;
  std::function<std::string(const std::string&)> path_of_;
  std::vector<std::pair<double, std::string>> written_;
  mutable std::once_flag grid_made_;
  mutable VtuGrid grid_;                           ///< of all files, made with the first
  mutable std::deque<std::future<void>> pending_;  ///< the last member, as what they use must outlive them
};

}  // namespace upbead
