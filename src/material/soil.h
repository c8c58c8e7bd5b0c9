// Soil at one point, or at eight side by side so that a processor computes them at once: its law of stress, whichever
// it is, and its history.
#pragma once

#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "base/lanes.h"
#include "upbead/material/elastic_law.h"

namespace upbead {

/// Components of a strain, a lane for each point.
struct PackTensor {
  detail::Lanes xx{}, yy{}, xy{};
};

/// Components of a stress, a lane for each point.
struct PackStress {
  detail::Lanes xx{}, yy{}, xy{}, zz{};
};

/// The numbers of n points side by side.
template <int n>
struct Beside {
  using Number = double;
  using Strain = PlaneStrain;
  using Stress = PlaneStress;
};
template <>
struct Beside<detail::lanes> {
  using Number = detail::Lanes;
  using Strain = PackTensor;
  using Stress = PackStress;
};

template <int n>
class SoilAt;
using SoilPoint = SoilAt<1>;
/// The same point of quadrature of 1 to 8 cells. Lanes without a cell always have zero strain.
using SoilPack = SoilAt<detail::lanes>;
/// The points of quadrature of a cell.
using SoilPoints = std::vector<std::unique_ptr<SoilPoint>>;

/// Gives the difference between the stress of elastic soil and that of this soil. Strain, stress and energy are counted
/// from the state at rest.
template <int n>
class SoilAt {
 public:
  using Number = typename Beside<n>::Number;
  using Strain = typename Beside<n>::Strain;
  using Stress = typename Beside<n>::Stress;

  virtual ~SoilAt() = default;
  /// Whether its stress is asked of elsewhere; then foresee() tells the strain of the next correct() or commit(), so
  /// that all points can be asked for at once.
  virtual bool asks() const { return false; }
  virtual void foresee(const Strain& /*strain*/) const {}
  /// D strain - sigma (Pa), with D the soil's own elastic law, starting from the committed state, which is not changed.
  /// Exactly zero where nothing has yielded.
  virtual void correct(const Strain& strain, Stress& correction) const = 0;
  /// Commits the strain. Adds the energy dissipated since the last commit (J/m3).
  virtual void commit(const Strain& strain, Number& dissipated) = 0;
  /// Energy stored since rest, less that of D and the work of the stresses at rest, which weights have done; at the
  /// committed strain (J/m3).
  virtual void stored_beside_elastic(const Strain& strain, Number& energy) const = 0;
  /// Norm of the change of strain since the commit below which nothing yields and the correction stays bitwise the
  /// same. 0 where it is not known.
  virtual void margin(const Strain& /*strain*/, Number& margin) const { margin = Number{}; }
  /// Share of the strength that is mobilised after that change of stress since rest (see the laws); 1 if all is.
  virtual double mobilised(int lane, const PlaneStress& change) const = 0;
  /// Appends the committed history, for checkpoints; recall() reads it back and returns the position behind it.
  virtual void remember(std::vector<double>& /*memory*/) const { throw std::invalid_argument(no_memory); }
  virtual const double* recall(const double* /*memory*/) { throw std::invalid_argument(no_memory); }
  /// Cells of soil of this kind in lanes, a pack for each point of quadrature; none where it has no lanes.
  virtual std::vector<std::unique_ptr<SoilPack>> in_lanes(const std::vector<SoilPoints>& /*cells*/) const { return {}; }

 private:
  static constexpr const char* no_memory = "this soil keeps no checkpoints";
};

/// The points of 1 to 8 cells side by side, all cells with the same number of points: a pack for each point. In lanes
/// where the soil can; `by_points`: never, which is the reference.
std::vector<std::unique_ptr<SoilPack>> side_by_side(std::vector<SoilPoints> cells, bool by_points = false);

/// Makes the soil of a cell at a point of quadrature.
using PointMaker = std::function<std::unique_ptr<SoilPoint>(unsigned point)>;

inline PlaneStress sum(const PlaneStress& a, const PlaneStress& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy, a.zz + b.zz};
}
inline PlaneStress difference(const PlaneStress& a, const PlaneStress& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy, a.zz - b.zz};
}
/// Compression positive (Pa).
inline double mean_stress(const PlaneStress& s) {
  return -(s.xx + s.yy + s.zz) / 3.;
}
inline double bulk_modulus(const ElasticLaw& law) {
  return law.lambda + 2. / 3. * law.G;
}

inline PlaneStrain in_lane(const PackTensor& strain, int lane) {
  return {strain.xx[lane], strain.yy[lane], strain.xy[lane]};
}
inline PlaneStress in_lane(const PackStress& s, int lane) {
  return {s.xx[lane], s.yy[lane], s.xy[lane], s.zz[lane]};
}
inline PlaneStress in_lane(const PlaneStress& s, int /*lane*/) {
  return s;
}
/// Appends the numbers of a structure of numbers or lanes, for checkpoints; reads them back and returns the position
/// behind them.
template <class Numbers>
void remember_numbers(const Numbers& numbers, std::vector<double>& memory) {
  const auto* first = reinterpret_cast<const double*>(&numbers);
  memory.insert(memory.end(), first, first + sizeof numbers / sizeof(double));
}
template <class Numbers>
const double* recall_numbers(const double* memory, Numbers& numbers) {
  std::memcpy(static_cast<void*>(&numbers), memory, sizeof numbers);
  return memory + sizeof numbers / sizeof(double);
}

/// Sets a lane of a structure of lanes to the structure of numbers with the same members.
template <class One, class Eight>
void set_lane(const One& one, int lane, Eight& eight) {
  static_assert(sizeof(Eight) == detail::lanes * sizeof(One));
  const auto* from = reinterpret_cast<const double*>(&one);
  auto* to = reinterpret_cast<double*>(&eight);
  for (std::size_t i = 0; i < sizeof(One) / sizeof(double); ++i)
    to[i * detail::lanes + static_cast<std::size_t>(lane)] = from[i];
}
inline void set_lane(const PlaneStress& s, int /*lane*/, PlaneStress& to) {
  to = s;
}

}  // namespace upbead
