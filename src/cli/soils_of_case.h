// A case as one reduced model for a box of soils and all waves.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "output/soil_model_file.h"
#include "upbead/case/case.h"

namespace upbead {

/// All results of `reduce --soils`.
struct SoilsOfCase {
  SoilModelFile file;
  int unseen = 0;                ///< soils at random that took no part
  int over = 0;                  ///< of these: whose estimate exceeds the case's tolerance
  double largest_estimate = 0.;  ///< among these
  double seconds = 0.;
  NumberedWarnings warnings;  ///< of the case's own soil
};

/// Makes the model for the soils of a box, with progress on the terminal. `folder`: from where the model's own copy of
/// the case sees its files. Throws InputError where the case allows no such model, or numbers decide otherwise about
/// flow, deformation or compressibility somewhere in the box; NumericsError where a soil cannot be reduced.
SoilsOfCase soils_of_case(Case& input, const CaseOptions& options, const std::vector<SoilAxis>& box,
                          const std::string& folder);

/// The model and how it was made, for people; `path`: of its file.
std::string describe(const SoilsOfCase& made, const std::string& path);
std::string to_json(const SoilsOfCase& made, const std::string& path);

}  // namespace upbead
