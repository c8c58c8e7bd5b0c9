// How exact a run is to be, and whether it shall tell how exact it is.
#pragma once

namespace upbead {

/// What the tolerance is asked of: the peak of F_T alone, or F_T at every time, which bounds the peak as well.
enum class AccuracyOf { peak, history };

struct AccuracyChoice {
  AccuracyOf of = AccuracyOf::history;
  bool estimate = false;  ///< solve once more on cells half as large, where the case gives the refinements
};

}  // namespace upbead
