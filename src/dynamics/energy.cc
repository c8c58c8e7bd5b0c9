#include "upbead/dynamics/energy.h"

#include <cmath>

namespace upbead {

double EnergyAccount::mismatch() const {
  if (largest_work == 0.) return 0.;
  return std::abs(work - stored() - drag - damping - radiated - scheme - friction) / largest_work;
}

}  // namespace upbead
