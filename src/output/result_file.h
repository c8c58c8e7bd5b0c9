// Files of numbers: results.h5, time histories as named datasets with unit and description; columns of a table.
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
  bool may_lack = false;    ///< a list some of whose values may be no number
};

/// The bytes of an HDF5 file with the datasets /history/NAME, each with the string attributes `unit` and `description`,
/// and the root attributes `title` and `program`. Made in memory: HDF5 1.10 does not survive a disk that is full when
/// it closes a file, whoever writes these bytes can. Throws NumericsError where a value is not finite.
/// `others` are datasets beside /history, wherever their names say: "interface/slip" is /interface/slip.
std::string result_file(const std::string& title, const std::vector<Dataset>& histories,
                        const std::vector<Dataset>& others = {});

/// The same with datasets wherever their names say: "lives/sliding" is /lives/sliding.
std::string dataset_file(const std::string& title, const std::vector<Dataset>& datasets);

/// A dataset of a table: numbers or, where there are none, texts.
struct TableColumn {
  std::string path;               ///< below the root, such as "runs/status"
  std::string unit, description;  ///< of numbers
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// A cell of a CSV file: quoted where it holds what separates cells.
std::string csv_cell(const std::string& text);

/// The bytes of the file, made in memory. Throws NumericsError where a number is not finite.
std::string table_file(const std::string& title, const std::vector<TableColumn>& columns);

}  // namespace upbead
