// Columns of numbers and of texts as an HDF5 file.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// A dataset: numbers or, where there are none, texts.
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
