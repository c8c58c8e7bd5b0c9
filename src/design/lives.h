// Lives of a design one by one, so that parts of them can be computed and kept.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "design/design.h"
#include "expected/ways_to_fail.h"
#include "upbead/expected/sliding_law.h"

namespace upbead {

/// All that the statistics ask of a life.
struct LifeNumbers {
  double sliding = 0., waves = 0., answered = 0., taken = 0., highest = 0.;  ///< see Life
  WorstBase base;  ///< by Goda's formulas; of the law dynamic in its own motion, in the wave that tilts most by them
  WaysToFail ways;
  double answered_for_ways = 0.;  ///< waves
};

using LifeByLaw = std::map<Law, LifeNumbers>;
using LivesByLaw = std::map<Law, std::vector<LifeNumbers>>;

/// Computes these lives on all cores; `take` is called with one at a time, in any order.
void compute_lives(const Design& design, const std::vector<int>& lives,
                   const std::function<void(int life, const LifeByLaw& found)>& take);

/// What the journals of a folder hold of a design's lives.
struct KeptLives {
  std::vector<LifeByLaw> lives;  ///< without a law where there is no result
  int torn = 0;                  ///< lines that are not whole

  bool has(int life) const { return !lives[static_cast<std::size_t>(life)].empty(); }
};

/// Throws InputError where they are of another design; `torn_of` as for read_lines().
KeptLives read_lives(const std::string& folder, const Design& design, const std::string& torn_of = "");

/// Computes these lives, and writes each at once to a journal of that name.
void keep_lives(const std::string& folder, const Design& design, const std::vector<int>& lives,
                const std::string& journal);

/// All lives, of which none may lack.
LivesByLaw by_law(const KeptLives& kept);

}  // namespace upbead
