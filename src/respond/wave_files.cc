#include "respond/wave_files.h"

#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "case/records/record_layout.h"
#include "case/records/record_table.h"
#include "wave_checks.h"

namespace upbead {

namespace {

namespace fs = std::filesystem;
using detail::find;
using detail::Names;

/// The load of each column of values.
std::vector<std::size_t> loads_of_columns(const CsvTable& table, const RecordLayout& layout, const Names& loads,
                                          Diagnostics& mistakes) {
  const Place header{table.path, 1, 1};
  if (layout.values.size() == 1 && loads.size() == 1) return {0};
  if (layout.time && find(loads, table.names[*layout.time]) < loads.size())
    mistakes.add(header, "the first column is the load " + in_quotes(table.names[*layout.time]) + ", not the time",
                 "begin with a column of times (s)");
  if (layout.values.empty()) mistakes.add(header, "a wave without a load", "give a time (s) and a load in every row");
  std::vector<std::size_t> list;
  for (const std::size_t c : layout.values) {
    const std::size_t k = find(loads, table.names[c]);
    if (k == loads.size())
      detail::add_unknown_load(header, "column", table.names[c], loads, mistakes);
    else if (std::find(list.begin(), list.end(), k) != list.end())
      mistakes.add(header, "two columns are called " + in_quotes(table.names[c]), "give each load once");
    list.push_back(k);
  }
  return list;
}

WaveFile read_csv_wave(const std::string& path, const Names& loads, const Names& units) {
  const CsvTable table = read_record_table(path, Place());
  const RecordLayout layout = layout_of(table);
  Diagnostics mistakes;
  const std::vector<std::size_t> load = loads_of_columns(table, layout, loads, mistakes);
  mistakes.throw_if_any();
  WaveFile file;
  file.time = times_of(table, layout);
  detail::check_times(
      file.time, [&table](std::size_t row) { return table.place(row); }, mistakes);
  mistakes.throw_if_any();
  file.n_loads = static_cast<int>(loads.size());
  file.value.setZero(file.n_loads, static_cast<Eigen::Index>(file.time.size()));
  for (std::size_t i = 0; i < load.size(); ++i) {
    const std::vector<double> values = detail::in_unit_of_load(table, layout.values[i], load[i], units);
    file.value.row(static_cast<Eigen::Index>(load[i])) =
        Eigen::Map<const Eigen::RowVectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  }
  note_layout(table, layout, file.notes);
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

std::vector<WaveFile> read_wave_files(const std::vector<std::string>& paths, const std::vector<std::string>& loads,
                                      const std::vector<std::string>& units) {
  Diagnostics mistakes;
  std::vector<WaveFile> files;
  for (const std::string& path : paths) try {
      const std::string ending = fs::path(path).extension().string();
      const bool hdf5 = ending == ".h5" || ending == ".hdf5";
      files.push_back(hdf5 ? detail::read_hdf5_waves(path, loads, units) : read_csv_wave(path, loads, units));
      files.back().name = fs::path(path).stem().string();
    } catch (const InputError& error) {
      mistakes.add(error.diagnostics());
    }
  mistakes.throw_if_any();
  number_duplicates(files);
  return files;
}

}  // namespace upbead
