// A model of soils of three coordinates, for tests of files and answers.
#pragma once

#include "output/soil_model_file.h"

namespace upbead::test {

/// The oscillator of sample_model.h on sand whose G is its spring and whose mobility drains its one pressure.
SoilModelFile two_soils();

}  // namespace upbead::test
