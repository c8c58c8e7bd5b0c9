// Files of numbers: results.h5, histories as named datasets with unit and description; columns of a table.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// One dataset.
struct Dataset {
  std::string name;  ///< path in the file; of a history below /history, such as "caisson/displacement_x"
  std::string unit;
  std::string description;
  std::vector<double> values;
  std::size_t columns = 1;  ///< of a table, whose values are row by row; a list has one
  std::string reading{};    ///< attribute of a measured history: the computed one it belongs to; else ""
  bool may_lack = false;    ///< a list in which NaN may stand for a missing value
};

/// The bytes of an HDF5 file with the datasets at the paths of their names ("interface/slip" is /interface/slip), each
/// with the string attributes `unit` and `description`, and the root attributes `title` and `program`. Made in memory,
/// as HDF5 1.10 crashes where the disk is full when it closes a file. Throws NumericsError where a value is not finite.
std::string dataset_file(const std::string& title, const std::vector<Dataset>& datasets);

/// A dataset of a table: numbers or, where it has none, texts.
struct TableColumn {
  std::string path;               ///< below the root, such as "runs/status"
  std::string unit, description;  ///< of numbers
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// A cell of a CSV file; in quotes where it contains a separator.
std::string csv_cell(const std::string& text);

/// The bytes of the file, made in memory. Throws NumericsError where a number is not finite.
std::string table_file(const std::string& title, const std::vector<TableColumn>& columns);

}  // namespace upbead
