// The table of the laws of soil that yields: all that other code asks of a law. A new law is a file with its row, and a
// line in soil_law.cc.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "material/compacting_point.h"
#include "material/soil.h"

namespace upbead {

struct MohrCoulombStrength {
  double friction_angle = 0.;   ///< phi' (degrees), below 90
  double cohesion = 0.;         ///< c' (Pa)
  double dilatancy_angle = 0.;  ///< psi' (degrees), from 0 to phi'
  double tension = 0.;          ///< largest tensile stress (Pa); never above c' / tan phi'
  /// c' cos phi' + s'_m sin phi' with the mean effective stress s'_m (Pa).
  double shear(double mean) const;
};

/// G/G_max over the shear strain.
struct ModulusCurve {
  std::function<double(double)> modulus_ratio;
  double reference_strain = 0.;
  std::optional<std::array<double, 2>> range;  ///< strains of the table that it was measured at
};

/// What is known of the soil of a region that has a law.
struct RegionSoil {
  std::string region;
  std::optional<MohrCoulombStrength> strength;
  std::optional<ModulusCurve> curve;
};

/// What is known of that soil in a cell.
struct CellSoil {
  ElasticLaw elastic;
  double mean = 0.;                  ///< effective stress at rest that its strength follows (Pa)
  std::vector<PlaneStress> at_rest;  ///< by points of quadrature, or one for all (Pa)
};

struct CellPoints {
  PointMaker point;
  bool beyond = false;  ///< whether the stress at rest exceeds the strength
};

enum class SoilNeeds {
  curve_or_strength,  ///< either, or both
  strength,           ///< and takes no curve
  function,           ///< of Python, which answers while the program runs; neither curve nor strength
};

/// The stress at rest that soil starts from.
enum class RestStress {
  given,     ///< by initial.start
  balanced,  ///< within the strength and in equilibrium with all weights
};

struct SoilLawRow {
  const char* word;  ///< in cases
  const char* soil;  ///< in messages
  SoilNeeds needs;
  RestStress rest;
  const char* how;  ///< how stress follows strain, for the reference of cases
  std::function<CellPoints(const CellSoil&)> (*make)(const RegionSoil&);
  /// A point that packs denser under cycles of shear, around one of this law; null where that is not offered.
  std::unique_ptr<CompactingPoint> (*compacting)(std::unique_ptr<SoilPoint> soil, const ElasticLaw& elastic,
                                                 const ShearCompaction& law, double mean_at_rest);
};

/// In the order of SoilLaw, without SoilLaw::elastic, its first.
const std::vector<const SoilLawRow*>& soil_law_rows();

}  // namespace upbead
