// The errors of F_T and S by source.
#pragma once

#include <optional>
#include <string>

#include "findings/evidence.h"

namespace upbead {

struct Errors {
  std::optional<ErrorEstimate> peak;     ///< of F_T; none where it was not estimated
  std::optional<ErrorEstimate> history;  ///< with it
  std::optional<double> slip;            ///< of S by eq. (4) on F_T(t) (m)
  std::optional<double> slip_as_whole;   ///< of the caisson that slips as a whole (m)
  std::optional<double> slip_of_nodes;   ///< of friction node by node (m)
  std::string why_no_slip;               ///< why `slip` is missing, where there is [sliding]
};

/// Where the mesh was made for the tolerance, or the case asks for it (accuracy.estimate). They come from
/// - the cells: change of F_T and S on cells half as large;
/// - the steps of a march: change of F_T with steps half as long, on the coarse mesh from which the refinement started;
///   for contact node by node on the mesh itself;
/// - the vectors of a reduced model: difference of its F_T to that of the last smaller model;
/// - the far sides, for the peak alone, on the coarse mesh: sides that hold (roller, sealed) and sides that give way
///   (free, open) reflect waves with opposite signs, so that the mean of both has no echo (Smith 1974); the error is
///   the difference of the case's F_T to that mean at the time of its peak. Far sides may be meant as they are; the
///   exact solution, to which all other errors refer, has the same far sides.
/// Those of S follow from its change on cells half as large, and from its change where F_T, uplift and normal force are
/// all larger or smaller by the estimated error of the peak: near the threshold one change is zero while the other is
/// not. Throws NumericsError as a march does.
Errors find_errors(const Evidence& e);

}  // namespace upbead
