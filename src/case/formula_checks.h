// The checks of a section in one wave by formulas: Goda's with the impulsive pressure coefficient at the crest, and the
// standing wave of finite height at crest and trough. They need no solved scene, and stand beside its checks.
#pragma once

#include <string>

#include "output/checks.h"
#include "upbead/model/scene.h"
#include "upbead/waves/standing_stability.h"

namespace upbead {

/// S of a wave by formulas (m), and how it was found.
struct FormulaSliding {
  double distance = 0.;
  std::string by, key;  ///< the key without the wave's
};

/// The larger of S by eqs. (4) and (6), and of 1998, with a standing wave besides the pulse.
FormulaSliding larger_sliding(double exact, double combined);

/// A wave on a section by formulas.
struct FormulaAnswer {
  std::string wave, level;  ///< names; "" for no level
  Stability stability;      ///< by Goda's formulas with alpha*
  StandingResult standing;  ///< in case the wave does not break
  FormulaSliding sliding;
  std::string key;  ///< of the summary, in which these numbers stand, with the final "."
};

/// Sliding, overturning and p_e, landward and seaward. A safety factor has the limit 1 where [limits] gives none.
Checks formula_checks(const FormulaAnswer& answer, const Limits& limits);

/// Warning levels_not_used: what is told is not of these levels of [levels], one of which may be worse.
NumberedWarnings levels_not_used(std::size_t levels, const std::string& told, const std::string& cure);

/// Warns of the least factor of a kind that is above 1 and below 1.2, where [limits] asks for none.
NumberedWarnings factor_warnings(const Checks& checks, const Limits& limits);

}  // namespace upbead
