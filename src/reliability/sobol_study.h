// The results of a study with sample = "sobol", as `upbead study` wrote them, for Sobol indices.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// One number that was read of each run of one case.
struct SobolOutputs {
  std::string case_file, number;
  /// By point that has the number in all its runs: of the row of A, of B, of A with the value of each key of B.
  std::vector<std::vector<double>> points;
  int failed = 0;    ///< runs of the case that failed
  int lacking = 0;   ///< runs that are done and have no such number
  int left_out = 0;  ///< points, as one of their runs failed or lacks the number
};

struct SobolStudy {
  std::string title;
  std::vector<std::string> keys;  ///< that were varied, in the order of the matrices
  std::vector<SobolOutputs> outputs;
};

/// Reads study.h5 and summary.json of a folder. `of`: numbers, as paths into summary.json; all that were read where it
/// is empty. Throws InputError where there is no such file, where its sample is another one, or where it has no such
/// number.
SobolStudy read_sobol_study(const std::string& folder, const std::vector<std::string>& of);

}  // namespace upbead
