// Points of soil in eight cells side by side, so that a processor computes several at a time.
#pragma once

#include <cstring>
#include <memory>
#include <vector>

#include "base/lanes.h"
#include "material/soil_point.h"

namespace upbead {

/// Components of a strain, a lane for each cell.
struct PackTensor {
  detail::Lanes xx{}, yy{}, xy{};
};

/// Components of a stress, a lane for each cell.
struct PackStress {
  detail::Lanes xx{}, yy{}, xy{}, zz{};
};

/// eps : D : eps / 2 (J/m3).
inline double elastic_energy(const ElasticLaw& D, const PlaneStrain& strain) {
  const PlaneStress s = D.stress(strain);
  return 0.5 * (s.xx * strain.xx + s.yy * strain.yy) + s.xy * strain.xy;
}

/// Gives the difference between the stress of the elastic law D and that of the soil.
class SoilPack {
 public:
  virtual ~SoilPack() = default;
  /// D strain - sigma at the n-th points of all cells (Pa), with sigma counted from rest, starting from the committed
  /// state, which is not changed. Exactly zero where nothing has yielded and D is the law's own. Several threads may
  /// call it, each for its own packs.
  virtual void correct(int n, const PackTensor& strain, PackStress& correction) = 0;
  /// Commits the strain. Adds the energy dissipated since the last commit (J/m3).
  virtual void commit(int n, const PackTensor& strain, detail::Lanes& dissipated) = 0;
  /// Energy stored since rest, as in SoilPoint::stored(), less that of D, at the committed strain (J/m3).
  virtual void stored_beside_elastic(int n, const PackTensor& strain, detail::Lanes& energy) const = 0;
  /// Norm of the change of strain since the commit below which nothing yields and the correction stays bitwise the
  /// same. 0 where it is not known.
  virtual void margin(int /*n*/, const PackTensor& /*strain*/, detail::Lanes& margin) const {
    margin = detail::Lanes{};
  }
  /// As in SoilPoint, for the n-th point of one cell.
  virtual double mobilised(int n, int lane, const PlaneStress& change) const = 0;
  /// As in SoilPoint, for all points.
  virtual void remember(std::vector<double>& memory) const = 0;
  virtual const double* recall(const double* memory) = 0;
};

/// Appends the numbers of tensors and stresses in lanes, for checkpoints.
template <class Tensor>
void remember_lanes(const Tensor& tensor, std::vector<double>& memory) {
  const auto* first = reinterpret_cast<const double*>(&tensor);
  memory.insert(memory.end(), first, first + sizeof(Tensor) / sizeof(double));
}
template <class Tensor>
const double* recall_lanes(const double* memory, Tensor& tensor) {
  std::memcpy(static_cast<void*>(&tensor), memory, sizeof tensor);
  return memory + sizeof(Tensor) / sizeof(double);
}

/// A cell that yields: the soil at its points, and the elastic law whose stiffness the system has for this cell.
struct PackedCell {
  ElasticLaw elastic;
  std::vector<std::unique_ptr<SoilPoint>> points;
};

/// Only cells of the same kind can be in one pack.
enum class PackKind {
  hysteretic,    ///< all points by one HystereticLaw, from one state at rest
  mohr_coulomb,  ///< all points by one MohrCoulombLaw, from rest
  points,        ///< each by its own SoilPoint: the reference, and laws without lanes
};
PackKind pack_kind(const PackedCell& cell);

/// A pack of 1 to 8 cells of that kind, all with the same number of points. Other lanes always have zero strain.
std::unique_ptr<SoilPack> soil_pack(PackKind kind, std::vector<PackedCell> cells);
std::unique_ptr<SoilPack> hysteretic_pack(const std::vector<PackedCell>& cells);
std::unique_ptr<SoilPack> mohr_coulomb_pack(const std::vector<PackedCell>& cells);

}  // namespace upbead
