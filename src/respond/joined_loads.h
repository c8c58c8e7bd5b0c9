// Loads of a case that are two loads of its system.
#pragma once

#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// A load that prescribes a pore pressure is two loads of the system, with one history: makes them one again.
void join_pore_pressures(ModalModel& model);

}  // namespace upbead
