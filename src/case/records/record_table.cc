#include "record_table.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "base/magnitude.h"
#include "base/quoted.h"
#include "base/units.h"
#include "output/hdf5_reader.h"

namespace upbead {

namespace {

constexpr std::size_t most_datasets = 10'000;

CsvTable read_hdf5_table(const std::string& path) {
  const Hdf5Reader file(path, "an HDF5 file of records, one dataset for the time and one for each column");
  CsvTable table;
  table.path = path;
  std::vector<std::string> names = file.names();
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name == "time"; });
  if (names.size() > most_datasets)
    throw InputError({path},
                     std::to_string(names.size()) + " datasets; at most " + std::to_string(most_datasets) +
                         " are read, more than any record has",
                     "is it the right file? keep the time and the records that are needed");
  for (const std::string& name : names) {
    std::optional<NumberArray> data = file.numbers("/" + name);
    if (!data || data->shape.size() != 1) continue;
    if (const std::string objection = objection_to(data->values); !objection.empty())
      throw InputError({path}, "a number of /" + excerpt(name) + " " + objection, "repair the record");
    if (!table.columns.empty() && data->values.size() != table.columns.front().size())
      throw InputError({path}, "/" + excerpt(name) + " is not as long as /" + excerpt(table.names.front()),
                       "let all records of a file have the same length");
    table.names.push_back(name);
    table.units.push_back(file.text_attribute("/" + name, "unit").value_or(""));
    table.columns.push_back(std::move(data->values));
  }
  if (table.columns.empty() || table.columns.front().empty())
    throw InputError({path}, "no one-dimensional dataset of numbers below the root",
                     "write /time and a dataset a record");
  table.lines.resize(table.columns.front().size());
  std::iota(table.lines.begin(), table.lines.end(), 1);
  return table;
}

bool is_hdf5(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".h5" || ending == ".hdf5";
}

}  // namespace

CsvTable read_record_table(const std::string& path, const Place& place) {
  return is_hdf5(path) ? read_hdf5_table(path) : read_csv(path, place);
}

CsvTable read_record_head(const std::string& path) {
  return is_hdf5(path) ? read_hdf5_table(path) : read_csv_head(path, 1'000'000);
}

std::vector<double> in_si(const CsvTable& table, std::size_t column, const std::string& si, const std::string& unit) {
  const std::string written = unit.empty() ? table.units[column] : unit;
  std::vector<double> values = table.columns[column];
  if (written.empty()) return values;
  const std::optional<Unit> known = unit_of(written);
  if (!known || known->si != si)
    throw InputError({table.path},
                     "the unit " + in_quotes(written) + " of column " + in_quotes(table.names[column]) +
                         " is none of " + (si == "s" ? "a time" : "what it should hold, " + si),
                     "write one of " + units_like(si));
  if (known->factor != 1.)
    for (double& value : values) value *= known->factor;
  return values;
}

}  // namespace upbead
