#include "upbead/app/wave_files.h"

#include <algorithm>
#include <filesystem>

#include "upbead/base/csv.h"
#include "wave_checks.h"

namespace upbead {

namespace {

namespace fs = std::filesystem;
using detail::find;
using detail::Names;

/// The load of each column but the first.
std::vector<std::size_t> loads_of_columns(const CsvTable& table, const Names& loads, Mistakes& mistakes) {
  const Place header{table.path, 1, 1};
  if (table.names.size() == 2 && loads.size() == 1) return {0};
  if (find(loads, table.names[0]) < loads.size())
    mistakes.add(header, "the first column is the load '" + table.names[0] + "', not the time",
                 "begin with a column of times (s)");
  if (table.names.size() < 2) mistakes.add(header, "a wave without a load", "give a time (s) and a load in every row");
  std::vector<std::size_t> list;
  for (std::size_t c = 1; c < table.names.size(); ++c) {
    const std::size_t k = find(loads, table.names[c]);
    if (k == loads.size())
      detail::add_unknown_load(header, "column", table.names[c], loads, mistakes);
    else if (std::find(list.begin(), list.end(), k) != list.end())
      mistakes.add(header, "two columns are called '" + table.names[c] + "'", "give each load once");
    list.push_back(k);
  }
  return list;
}

WaveFile read_csv_wave(const std::string& path, const Names& loads) {
  const CsvTable table = read_csv(path, Place());
  Mistakes mistakes;
  const std::vector<std::size_t> load = loads_of_columns(table, loads, mistakes);
  detail::check_times(
      table.columns[0], [&table](std::size_t row) { return table.place(row); }, mistakes);
  mistakes.throw_if_any();
  WaveFile file;
  file.time = table.columns[0];
  file.n_loads = static_cast<int>(loads.size());
  file.value.setZero(file.n_loads, static_cast<Eigen::Index>(file.time.size()));
  for (std::size_t c = 1; c < table.columns.size(); ++c)
    for (std::size_t n = 0; n < file.time.size(); ++n)
      file.value(static_cast<Eigen::Index>(load[c - 1]), static_cast<Eigen::Index>(n)) = table.columns[c][n];
  return file;
}

/// Appends -2, -3, ... to a name that another file has.
void number_duplicates(std::vector<WaveFile>& files) {
  Names taken;
  for (WaveFile& file : files) {
    const std::string name = file.name;
    for (int n = 2; find(taken, file.name) < taken.size(); ++n) file.name = name + "-" + std::to_string(n);
    taken.push_back(file.name);
  }
}

}  // namespace

std::vector<WaveFile> read_wave_files(const std::vector<std::string>& paths, const std::vector<std::string>& loads) {
  Mistakes mistakes;
  std::vector<WaveFile> files;
  for (const std::string& path : paths) try {
      const std::string ending = fs::path(path).extension().string();
      const bool hdf5 = ending == ".h5" || ending == ".hdf5";
      files.push_back(hdf5 ? detail::read_hdf5_waves(path, loads) : read_csv_wave(path, loads));
      files.back().name = fs::path(path).stem().string();
    } catch (const InputError& error) {
      mistakes.add(error);
    }
  mistakes.throw_if_any();
  number_duplicates(files);
  return files;
}

}  // namespace upbead
