// summary.json: what a run found, in SI numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "upbead/dynamics/energy.h"
#include "upbead/response/shear_response.h"

namespace upbead {

struct Discretisation {
  int cells = 0;
  int unknowns = 0;
  int degree = 0;
  std::string scheme;
  double time_step = 0.;  ///< the largest (s)
  int steps = 0;
  int solves = 0;
  int factorisations = 0;
};

/// What was left out, and why.
struct Skipped {
  std::string what;
  std::string why;
};

/// Wall times (s). `factorise` and `march` do not overlap; `total` runs from the start of the program.
struct Timing {
  double mesh = 0., compile = 0., factorise = 0., march = 0., output = 0., total = 0.;
};

struct Summary {
  std::string title;
  Discretisation discretisation;
  std::optional<ShearResponse> response;  ///< none without a caisson
  std::vector<LoadOnCaisson> loads;
  EnergyAccount energy;
  std::vector<Skipped> skipped;
  Timing timing;
};

/// JSON with the keys of docs/output.md; null where a value does not exist. Throws NumericsError where one is not
/// finite.
std::string to_json(const Summary& summary);

}  // namespace upbead
