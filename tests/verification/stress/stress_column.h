// The columns of tests/reference/ref9_stress.json.
#pragma once

#include "column_case.h"

namespace upbead::test {

/// The test whose id begins with that letter.
Json stress_case(char letter);

/// The column of a test (height L, constants `mat`) with hydraulic conductivity k (m/s), under a load in units of q,
/// with probes `top` and `base`.
Scene stress_column(const Json& test, double k, const std::string& model, const TimeFunction& load);

}  // namespace upbead::test
