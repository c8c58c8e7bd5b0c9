// What `upbead calibrate` tells: summary.json, calibration.csv, results.h5, and the text for people.
#pragma once

#include <string>

#include "../design.h"
#include "design/calibrate.h"

namespace upbead {

/// Throws NumericsError where a number is not finite.
std::string to_json(const Design& design, const Calibration& found);
/// A row per model, wave and r.
std::string calibration_csv(const Calibration& found);
/// The same columns as the bytes of an HDF5 file.
std::string calibration_file(const Design& design, const Calibration& found);
std::string describe(const Design& design, const Calibration& found);
/// For stderr: fits that tell nothing; "" where all do.
std::string notes_and_warnings(const Calibration& found);

}  // namespace upbead
