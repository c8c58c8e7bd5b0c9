#include "joined_loads.h"

namespace upbead {

void join_pore_pressures(ModalModel& model) {
  const std::string suffix = ".pore_pressure";
  for (int k = model.n_loads() - 1; k > 0; --k) {
    const std::string& name = model.load_name[static_cast<std::size_t>(k)];
    const std::string& before = model.load_name[static_cast<std::size_t>(k - 1)];
    if (name == before + suffix) model.join_loads(k - 1, k);
  }
}

}  // namespace upbead
