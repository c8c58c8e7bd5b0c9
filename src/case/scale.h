// The similar case: the same breakwater at another size, by Froude's law.
#pragma once

#include <string>
#include <vector>

#include "upbead/case/case.h"

namespace upbead {

/// How the soil's constants with a dimension are scaled: G, E, K_f, K_s (Pa) and the hydraulic conductivity k (m/s).
enum class SoilScaling {
  froude,  ///< as everything else, so that every dimensionless result stays the same
  same,    ///< not scaled: it is the same soil
};

struct ScaleOptions {
  double factor = 1.;  ///< length of the new case over that of the old one
  SoilScaling soil = SoilScaling::froude;
  std::vector<std::string> ratios;  ///< KEY=VALUE: multiplies that key by VALUE instead
};

/// A file that a case names, and its contents.
struct NamedText {
  std::string path;  ///< relative to the case
  std::string text;
};

struct ScaledCase {
  std::string text;                  ///< TOML, with every default written out
  std::vector<NamedText> histories;  ///< of loads and uplift
  std::vector<std::string> kept;     ///< keys whose numbers stay as they are though they have a dimension
};

/// The power of the length's factor with which a number of that unit scales by Froude's law: g and the densities
/// stay, so a length has 1, a time 1/2, a mass 3. Units are products of powers of kg, m, s, N, Pa, Hz and rad, with
/// divisors after a "/", such as "kg m2/m"; "" and "-" have none. Throws std::invalid_argument for any other.
double froude_exponent(const std::string& unit);

/// The case at another size, to be written into `folder`. Throws InputError where a factor is not positive, where a
/// ratio names no number of the case or leaves its range, where the mesh is finished (.msh), and where a parameter of
/// the .geo has no unit.
ScaledCase scale_case(const Case& problem, const ScaleOptions& options, const std::string& folder);

}  // namespace upbead
