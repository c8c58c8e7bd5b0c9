// The breakwater of scenes.h on ground that has strengths: for slip circles.
#pragma once

#include "scenes.h"

namespace upbead::test {

/// Under a triangular pulse of that peak (N/m), still water 6 m high, solved by a reduced model until 0.6 s.
inline Scene strong_breakwater(double peak) {
  Scene scene = breakwater(triangle(peak, 0.2));
  scene.initial.emplace().water_level = 6.;
  scene.regions["seabed"].strength = Strength{35., 0.};
  scene.regions["mound"].strength = Strength{40., 20e3};
  scene.time.end = 0.6;
  scene.time.scheme = TimeScheme::reduced;
  return scene;
}

}  // namespace upbead::test
