// What of a scene its system of equations depends on.
#pragma once

#include <map>
#include <string>

#include "upbead/model/scene.h"

namespace upbead {

/// This alone reaches the assembly: a scene that differs elsewhere has the same System, but for the course in time of
/// its loads. Two of these are equal only if all members are; NaN equals nothing.
struct SystemScene {
  double gravity = 0.;
  Fluid fluid;
  int degree = 0;
  std::map<std::string, Region> regions;
  std::map<std::string, Boundary> boundaries;
  std::map<std::string, Load> loads;  ///< factor 1 where they act, else 0; without course and duration
  std::map<std::string, Probe> probes;
  bool base_stress = false;
  bool inertia = true;
};

/// The part of a resolved scene.
SystemScene system_scene(const Scene& scene);

/// A scene of that part, with nothing else in it.
Scene as_scene(const SystemScene& part);

bool operator==(const SystemScene& a, const SystemScene& b);

}  // namespace upbead
