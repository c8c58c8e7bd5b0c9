// What `upbead expected` tells: summary.json, results.h5, and the text for people.
#pragma once

#include <string>

#include "expected_work.h"

namespace upbead {

/// Wall times (s).
struct ExpectedTiming {
  double read = 0., total = 0.;
};

/// Throws NumericsError where a number is not finite.
std::string to_json(const Design& design, const ExpectedAnswer& answer, const ExpectedTiming& timing);
/// The bytes of results.h5.
std::string expected_file(const Design& design, const ExpectedAnswer& answer);
std::string describe(const Design& design, const ExpectedAnswer& answer);
/// For stderr: what makes the numbers doubtful; "" where nothing does.
std::string notes_and_warnings(const ExpectedAnswer& answer);

}  // namespace upbead
