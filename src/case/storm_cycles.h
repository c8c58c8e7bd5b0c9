// The waves of a storm, [cycles]: as the table gives them, or of sea states whose heights are Rayleigh's.
#pragma once

#include <vector>

#include "base/files.h"
#include "input/schema.h"
#include "upbead/expected/sliding_law.h"
#include "upbead/model/scene.h"

namespace upbead {

struct Case;

/// The table [cycles] as written; `cycles` of Scene is made of it.
struct CyclesTable : Cycles {
  std::vector<double> significant_height;  ///< H_1/3 of each part (m), in place of heights
  std::vector<double> duration;            ///< of each part (s), in place of numbers
  double highest = 1.8;                    ///< largest height over H_1/3; higher waves break to it
};

TableSchema<CyclesTable> cycles_schema();

/// What is contradictory in the table by itself.
Diagnostics diagnose(const CyclesTable& table);

/// The waves of sea states, in the order of time: in groups of some 200, and in a group by classes of height, the
/// highest last. The height of a class is that whose fourth power is the mean of its waves', as pressure grows with
/// some fourth power of the shear. Waves above `highest` H_1/3 break to it.
Cycles rayleigh_cycles(const std::vector<SeaState>& states, double highest, double run_height);

/// Makes `cycles` of the scene, whose loads are known: explicit keys first, then the sea state of the wave load, then
/// the record [sea] of the same file.
void make_cycles(Case& problem, Diagnostics& report);

/// The record of sea states, where the storm is taken from it.
std::vector<InputFile> files_of_cycles(const Case& problem);

}  // namespace upbead
