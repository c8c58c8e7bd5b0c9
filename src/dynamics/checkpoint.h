// A march that stands still after some of its steps, with all that it needs to go on as if it never had.
#pragma once

#include "upbead/dynamics/march.h"

namespace upbead {

/// What a scheme carries from step to step beside the state and what it can make anew.
struct SchemeMemory {
  LoadedState balanced;
  std::vector<double> end_load;
  std::vector<double> largest_load;  ///< |f_k| so far, of generalised-alpha; else empty
  double last_step = 0.;             ///< of generalised-alpha (s); 0 before the first
  EnergyAccount energy;
};

struct MarchCheckpoint {
  Response so_far;  ///< with the state that the march stands at, and the steps done
  SchemeMemory memory;
  std::vector<double> observed;  ///< memories of the observers, one after the other
};

}  // namespace upbead
