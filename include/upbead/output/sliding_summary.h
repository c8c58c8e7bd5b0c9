// The object `sliding` of summary.json.
#pragma once

#include <optional>
#include <string>

#include "upbead/sliding/history_sliding.h"

namespace upbead {

/// S by tau_0 of eqs. (8)-(11) of Shimosako and Takahashi (1994) and the run's own F_Smax.
struct PulseSliding {
  double standing_duration = 0.;  ///< tau_0F (s)
  double factor = 0.;             ///< k(alpha*)
  double duration = 0.;           ///< tau_0 (s)
  double paper = 0.;              ///< S_CAL, eq. (7) (m)
  PaperParts paper_parts;         ///< S_1 and S_2
  double exact = 0.;              ///< by integrating eqs. (4) and (6) (m)
};

struct SlidingSummary {
  double weight = 0.;          ///< W (N/m)
  double buoyant_weight = 0.;  ///< W' (N/m)
  double friction = 0.;        ///< mu
  double drag = 0.;            ///< F_D over velocity (N s/m2)
  std::string uplift;          ///< none, prescribed or computed
  HistorySliding history;
  std::optional<PulseSliding> pulse;  ///< where the case names a wave
};

}  // namespace upbead
