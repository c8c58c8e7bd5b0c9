#include "sdirk4.h"

namespace upbead::detail {

void Sdirk4::advance(State& state, double h) {
  dirk_.step(state, h, state.time + 0.5 * h, matrices_, meter());
  n_solves_ += dirk_.n_stages();
  end_load_ = dirk_.load();
  balanced_.state = state;
  balanced_.load = end_load_;
}

}  // namespace upbead::detail
