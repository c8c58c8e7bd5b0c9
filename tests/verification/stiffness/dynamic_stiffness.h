// One soil of tests/reference/ref4_strip.json: the program's dynamic stiffness of a bonded strip against theory.
#pragma once

#include "record.h"
#include "reference.h"
#include "stiffness_scene.h"

namespace upbead::test {

/// The entry of the table for a strip bonded to that soil; an infinite depth is the half-plane.
Json compliance_entry(const ElasticSoil& soil);

/// Largest of the differences in K_v, K_hh and K_rr, each over its own magnitude, and in K_hr over
/// sqrt(|K_hh| |K_rr|), which is a stiffness per length and angle as K_hr is.
double stiffness_error(const Stiffness& K, const Stiffness& exact);

/// "half-plane, nu = 0.3", "layer H = 1.5 b, nu = 0.3".
std::string name_of(const ElasticSoil& soil);

/// All frequencies of the table: the program against theoretical_stiffness, both against the table where it is right.
/// `draw`: curves of all components.
void compare_dynamic_stiffness(const ElasticSoil& soil, bool draw);

}  // namespace upbead::test
