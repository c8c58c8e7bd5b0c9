// The pressure of a rigid bottom on its ground.
#pragma once

namespace upbead {

/// Effective pressures of the edges (Pa) of a bottom of width B under `force` N' (N/m) and `moment` M' about its middle
/// (N m/m, overturning landward positive), stress linear over what touches: N'/B (1 -+ 6 e/B) where |e| = |M'/N'| <=
/// B/6, else 0 and 2 N' / (3 t), t = B/2 - |e| (the bearing pressure p_e of Goda, Random Seas and Design of Maritime
/// Structures, ch. 4). A bottom that stands on its edge would crush it: t >= B/1000. 0 where N' <= 0.
struct EdgePressures {
  double seaward = 0., landward = 0.;
};
EdgePressures edge_pressures(double force, double moment, double width);

}  // namespace upbead
