// How wrong S is.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// Of a run with contact node by node.
struct ContactError {
  ShearError mesh, time;
  double slip = 0.;  ///< of S (m)
};

/// By the same march on cells half as large, and with steps half as long; fills in that of [sliding], too. Throws
/// NumericsError as that does.
ContactError error_of_contact(Run& run);

/// Fills in how wrong S is by eq. (4) on F_T(t) and of the caisson that slips as a whole, with [sliding]; the errors of
/// F_T must be there. S moves by so much on cells half as large, and where F_T, uplift and normal force are all larger
/// or smaller by the estimated error of the peak: near the threshold the one is zero while the other is not.
void estimate_slip_error(Run& run);

/// Fills in why nothing is told of it.
void tell_why_no_slip_error(Run& run);

}  // namespace upbead
