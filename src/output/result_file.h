// results.h5: time histories as named datasets with unit and description.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// One dataset.
struct Dataset {
  std::string name;  ///< path below /history, such as "caisson/displacement_x"
  std::string unit;
  std::string description;
  std::vector<double> values;
  std::size_t columns = 1;  ///< of a table: values row by row; a list has one
  std::string reading{};    ///< attribute: the history that a measured one belongs to; "" without
};

/// The bytes of an HDF5 file with the datasets /history/NAME, each with the string attributes `unit` and `description`,
/// and the root attributes `title` and `program`. Made in memory: HDF5 1.10 does not survive a disk that is full when
/// it closes a file, whoever writes these bytes can. Throws NumericsError where a value is not finite.
/// `others` are datasets beside /history, wherever their names say: "interface/slip" is /interface/slip.
std::string result_file(const std::string& title, const std::vector<Dataset>& histories,
                        const std::vector<Dataset>& others = {});

/// The same with datasets wherever their names say: "lives/sliding" is /lives/sliding.
std::string dataset_file(const std::string& title, const std::vector<Dataset>& datasets);

}  // namespace upbead
