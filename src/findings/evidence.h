// What findings are made of: a solution, and what other findings have made of it.
#pragma once

#include <functional>
#include <map>
#include <memory>
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
    std::shared_ptr<const void>& found = found_[reinterpret_cast<void (*)()>(find)];
    if (!found) found = std::make_shared<const Value>(find(*this));
    return *static_cast<const Value*>(found.get());
  }

  const Solution& solution;
  const Simulation& simulation;
  const Scene& scene;
  const std::function<void(double)> progress;

 private:
  mutable std::map<void (*)(), std::shared_ptr<const void>> found_;
};

}  // namespace upbead
