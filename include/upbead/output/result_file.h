// results.h5: time histories as named datasets with unit and description.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace upbead {

/// One dataset.
struct History {
  std::string name;  ///< path below /history, such as "caisson/displacement_x"
  std::string unit;
  std::string description;
  std::vector<double> values;
};

/// Writes an HDF5 file with the datasets /history/NAME, each with the string attributes `unit` and `description`, and
/// the root attributes `title` and `program`. Throws NumericsError where a value is not finite, InputError (with
/// `place_name` for the reader) where the disk does not take it.
void write_result_file(const std::string& path, const std::string& place_name, const std::string& title,
                       const std::vector<History>& histories);

}  // namespace upbead
