// What `respond` is given: its options, waves, and the sliding to compute.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/respond_cases.h"

namespace upbead {

struct RespondArguments {
  std::string model;
  std::vector<std::string> forces, soil;
  std::string histories;
  bool json = false;
  std::string out;
  std::optional<double> end, friction, submerged_weight;

  /// Whether soils come from standard input, `--soil -`.
  bool serves() const;
};

/// Throws InputError where options contradict each other or are out of range.
void check(const RespondArguments& arguments);

/// The sliding to compute: what the model knows of its case's [sliding], changed by the options.
std::optional<ModelSliding> sliding_of(const RespondArguments& arguments, const ReducedModelFile& model);

/// Warning implausible where a number of the options is none of a caisson like the model's, such as kN/m for N/m.
NumberedWarnings warnings_of_options(const RespondArguments& arguments, const ReducedModelFile& model);

/// Waves of files, then those that are the loads of cases; of a case alone its own.
std::vector<WaveFile> waves_of(const RespondArguments& arguments, const RespondCases& cases,
                               const ReducedModelFile& model);

}  // namespace upbead
