// What findings are made of: a solution, and what other findings have made of it.
#pragma once

#include <functional>
#include <utility>

#include "upbead/run/simulation.h"

namespace upbead {

class Evidence {
 public:
  /// The solution must outlive this. `progress`: called with 0 to 1 by findings that compute long; may be empty.
  explicit Evidence(const Solution& what, std::function<void(double)> while_finding = {})
      : solution(what), simulation(*what.simulation), scene(simulation.scene()), progress(std::move(while_finding)) {}

  /// What that function makes of this evidence. It is called once, so that findings may ask for each other in any
  /// order.
  template <class Value>
  const Value& of(Value (*find)(const Evidence&)) const {
    return found_.of(*this, find);
  }
  /// What it makes of the solution alone: called once for all evidence of it, as where a study varies [sliding].
  template <class Value>
  const Value& of(Value (*find)(const Solution&)) const {
    return solution.found->of(solution, find);
  }

  const Solution& solution;
  const Simulation& simulation;
  const Scene& scene;
  const std::function<void(double)> progress;

 private:
  mutable Memo found_;
};

}  // namespace upbead
