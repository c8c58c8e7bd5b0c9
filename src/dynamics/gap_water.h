// Water from outside in the gaps under the edges of a body that lifts.
#pragma once

#include <array>
#include <vector>

#include "dynamics/contact.h"

namespace upbead {

/// What an interface whose gaps are open to the sea has beside it, at its first node and at its last.
struct GapWater {
  /// Forces that press the bodies apart while all is closed, as the loads of the system have them.
  struct Closed {
    Vector node;            ///< at f = 1 (N/m)
    TimeFunction pressure;  ///< f
  };
  std::array<TimeFunction, 2> foot;  ///< pressure of the water beside each edge (Pa)
  std::vector<Closed> closed;
};

namespace detail {

/// The forces of that water at the nodes, beyond those of the closed interface. A gap, which is as long as the nodes
/// from its edge on are open, has the pressure at its mouth all along: the larger of that of the water beside the edge
/// and that of the closed interface there, on the safe side. Between two gaps, and between a
/// gap and an edge that is closed, the pressure runs in a straight line; a closed edge has that of the closed
/// interface. So do dams with cracks under them: Ebeling, Nuss, Tracy and Brand (2000), ERDC/ITL TR-00-1. Where all is
/// open the line runs from edge to edge.
class GapForces {
 public:
  /// None where the interface has no such water. It must outlive this.
  explicit GapForces(const Interface& interface) : interface_(interface) {}

  /// Takes the gaps from a state of the nodes.
  void open(const std::vector<ContactState>& status);
  bool act() const { return !share_.empty(); }
  /// At a time, on the piece that contains the time `inside` (N/m).
  Vector at(double time, double inside) const;

 private:
  const Interface& interface_;
  std::vector<double> share_;  ///< of the pressure at the first end of the line in that of each node
  std::array<bool, 2> is_open_{{false, false}};
};

}  // namespace detail

}  // namespace upbead
