// A scene solved with and without the parts that may be left out.
#pragma once

#include <memory>
#include <string>

#include "record.h"
#include "scenes.h"

namespace upbead::test {

/// The shipped section between seas of three depths, or without any, under a triangle of 1.6 MN/m on the front.
Scene section_scene(bool sea, double duration);

/// Results of one way to solve a scene.
struct Solved {
  ShearResponse shear;
  int unknowns = 0;
  std::vector<Decision> decisions;
};

/// Marches by the scene's own choices to its end in steps of a twelfth of `duration`.
Solved solve(const Scene& scene, const Mesh& mesh, double duration);

/// The value that the program chose for a key of a region; "" if it chose none.
std::string decided(const Solved& solved, const std::string& region, const std::string& key);

/// Asserts and records that peak F_T changes by less than 0.1 %, and records the unknowns of both.
void compare(Record& record, const std::string& what, const Solved& without, const Solved& with);

}  // namespace upbead::test
