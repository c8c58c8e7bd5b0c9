// Sobol indices of a study: which share of the variance of a number is due to each key.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reliability/sobol_study.h"
#include "upbead/base/numbered_warning.h"

namespace upbead {

struct OutputRow;

/// An estimate and the ends of its interval of 95 %.
struct Estimate {
  double value = 0., low = 0., high = 0.;
};

struct KeyIndices {
  std::string key;
  Estimate first;  ///< S_i = Var(E(Y|X_i)) / Var(Y): by the key alone
  Estimate total;  ///< T_i = E(Var(Y|all but X_i)) / Var(Y): by the key, alone and together with others
};

/// The indices of one number of one case.
struct NumberIndices {
  std::string case_file, number;
  int points = 0, left_out = 0, failed = 0, lacking = 0;  ///< see SobolOutputs
  std::optional<double> mean, deviation;                  ///< by the rows of A and B; none without points
  std::string why_not;                                    ///< there are no indices; "" where there are
  std::vector<KeyIndices> keys;                           ///< the largest total first
};

struct StudyIndices {
  std::string title;
  std::vector<NumberIndices> numbers;
};

/// By OpenTURNS: see indices.cc.
StudyIndices find_indices(const SobolStudy& study);

NumberedWarnings warnings_of(const StudyIndices& indices);
std::string describe(const StudyIndices& indices);
/// indices.json. Throws NumericsError where a number is not finite.
std::string to_json(const StudyIndices& indices);
/// The keys of that JSON.
std::vector<OutputRow> rows_of_indices();

}  // namespace upbead
