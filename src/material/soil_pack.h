// Points of soil of eight cells side by side, so that a processor takes several at a time.
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

/// Of a stress.
struct PackStress {
  detail::Lanes xx{}, yy{}, xy{}, zz{};
};

/// eps : D : eps / 2 (J/m3).
inline double elastic_energy(const ElasticLaw& D, const PlaneStrain& strain) {
  const PlaneStress s = D.stress(strain);
  return 0.5 * (s.xx * strain.xx + s.yy * strain.yy) + s.xy * strain.xy;
}

/// Tells the stress that the elastic law D has and the soil has not.
class SoilPack {
 public:
  virtual ~SoilPack() = default;
  /// D strain - sigma of the n-th points of all cells (Pa), sigma counted from rest, from the committed state, which
  /// stays. Exactly zero where nothing has yielded and D is the law's own. Several threads may call it for packs of
  /// their own.
  virtual void correct(int n, const PackTensor& strain, PackStress& correction) = 0;
  /// The strain becomes history. Adds what was dissipated since the last commit (J/m3).
  virtual void commit(int n, const PackTensor& strain, detail::Lanes& dissipated) = 0;
  /// Energy stored since rest as of SoilPoint::stored(), less that of D, at the committed strain (J/m3).
  virtual void stored_beside_elastic(int n, const PackTensor& strain, detail::Lanes& energy) const = 0;
  /// As long as the norm of the change of strain since the commit is smaller, nothing yields and the correction stays
  /// as it is, to the last bit. 0 where that is not known.
  virtual void margin(int /*n*/, const PackTensor& /*strain*/, detail::Lanes& margin) const {
    margin = detail::Lanes{};
  }
  /// As of SoilPoint, of the n-th point of one cell.
  virtual double mobilised(int n, int lane, const PlaneStress& change) const = 0;
  /// As of SoilPoint, of all points.
  virtual void remember(std::vector<double>& memory) const = 0;
  virtual const double* recall(const double* memory) = 0;
};

/// The numbers of tensors and stresses in lanes, for memories.
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

/// A cell that yields: the soil of its points, and the elastic law whose stiffness the system has for it.
struct PackedCell {
  ElasticLaw elastic;
  std::vector<std::unique_ptr<SoilPoint>> points;
};

/// Which cells can lie in one pack.
enum class PackKind {
  hysteretic,    ///< all points by one HystereticLaw, from one state at rest
  mohr_coulomb,  ///< all points by one MohrCoulombLaw, from rest
  points,        ///< each by its own SoilPoint: the reference, and every law without lanes
};
PackKind pack_kind(const PackedCell& cell);

/// Of 1 to 8 cells of that kind with as many points each. Other lanes have a strain of zero at all times.
std::unique_ptr<SoilPack> soil_pack(PackKind kind, std::vector<PackedCell> cells);
std::unique_ptr<SoilPack> hysteretic_pack(const std::vector<PackedCell>& cells);
std::unique_ptr<SoilPack> mohr_coulomb_pack(const std::vector<PackedCell>& cells);

}  // namespace upbead
