#include "respond/wave_files.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/csv.h"
#include "base/numbers.h"
#include "base/text.h"
#include "base/units.h"
#include "case/records/record_layout.h"
#include "case/records/record_table.h"
#include "model/record.h"
#include "output/hdf5_reader.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using Names = std::vector<std::string>;

/// Index of a name in the list; the size of the list where the name is missing.
std::size_t find(const Names& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Reports a name that is no load; `what`: "column" or "dataset".
void add_unknown_load(const Place& place, const std::string& what, const std::string& name, const Names& loads,
                      Diagnostics& mistakes) {
  const std::string near = nearest(name, loads), all = "the model's loads are: " + join(loads);
  mistakes.add(place, what + " " + in_quotes(name) + " is no load of the model",
               near.empty() ? all : "did you mean " + in_quotes(near) + "? " + all);
}

/// Times must be two or more, ascending, and not negative. `place`: of the time with that index.
void check_times(const std::vector<double>& time, const std::function<Place(std::size_t)>& place,
                 Diagnostics& mistakes) {
  if (time.size() < 2) return mistakes.add(place(0), "a wave of one time", "give two times or more");
  if (time.front() < 0.)
    mistakes.add(place(0), "the wave starts at t = " + significant(time.front(), 6) + " s, before the response",
                 "let it start at 0 or later");
  for (std::size_t n = 1; n < time.size(); ++n)
    if (!(time[n] > time[n - 1]))
      return mistakes.add(
          place(n), "t = " + significant(time[n], 6) + " s does not follow t = " + significant(time[n - 1], 6) + " s",
          "let the times ascend strictly");
}

/// Factor from a unit to that of load `k`; where the load's unit is not known, to the SI unit of a force or pressure.
/// Throws InputError where the unit is one of another quantity; `who`: the column or dataset with that unit.
double factor_to_load(const std::string& unit, std::size_t k, const Names& units, const Place& place,
                      const std::string& who) {
  if (unit.empty()) return 1.;
  const std::string wanted = k < units.size() ? units[k] : "";
  const std::optional<Unit> known = unit_of(unit);
  if (known && (wanted.empty() ? known->si == "N/m" || known->si == "Pa" : known->si == wanted)) return known->factor;
  throw InputError(
      place,
      "the unit " + in_quotes(unit) + " of " + who + " is none of the load, " + (wanted.empty() ? "N/m or Pa" : wanted),
      "write one of " + units_like(wanted.empty() ? "N/m" : wanted));
}

/// A column in the unit of load `k`.
std::vector<double> in_unit_of_load(const CsvTable& table, std::size_t column, std::size_t k, const Names& units) {
  const auto end = unit_at_end(table.names[column]);
  const bool by_name = table.units[column].empty() && end && !may_be_a_name(end->unit);
  const double factor = factor_to_load(by_name ? end->unit : table.units[column], k, units, {table.path, 1, 1},
                                       "column " + in_quotes(table.names[column]));
  if (!by_name && table.units[column].empty())
    refuse_unread_unit(table.path, table.names[column], k < units.size() && !units[k].empty() ? units[k] : "N/m");
  std::vector<double> values = table.numbers(column);
  refuse_missing_marks(table, column);
  for (double& value : values) value *= factor;
  return values;
}

/// Sets to zero the tiny numbers that are left where values decay in some program, as in CSV files.
void clear_small(std::vector<double>& values) {
  for (double& value : values)
    if (is_too_small(value)) value = 0.;
}

std::string shape_text(const NumberArray& array) {
  Names sizes;
  for (const std::size_t size : array.shape) sizes.push_back(std::to_string(size));
  return sizes.empty() ? "of a single number" : join(sizes, " x ");
}

/// The datasets of an HDF5 file of waves, checked one by one.
class WaveDatasets {
 public:
  WaveDatasets(const std::string& path, const Names& loads, const Names& units)
      : path_(path),
        loads_(loads),
        units_(units),
        file_(path, "a file with the datasets time and " + join(loads, " or ")) {
    read_time();
    for (const std::string& name : file_.names())
      if (name != "time") read_load(name);
    if (values_.empty() && !unknown_)
      mistakes_.add({path_}, "a file without a load", "add a dataset named like a load of the model: " + join(loads_));
    mistakes_.throw_if_any();
  }

  WaveFile take() {
    WaveFile file;
    file.n_loads = static_cast<int>(loads_.size());
    const auto n = static_cast<Eigen::Index>(time_.size());
    file.value.setZero(static_cast<Eigen::Index>(n_waves_) * file.n_loads, n);
    for (const auto& [k, array] : values_)
      for (std::size_t w = 0; w < n_waves_; ++w) {
        const std::size_t row = array.shape.size() == 2 ? w : 0;
        file.value.row(static_cast<Eigen::Index>(w * loads_.size() + k)) =
            Eigen::Map<const Eigen::RowVectorXd>(array.values.data() + row * time_.size(), n);
      }
    file.time = std::move(time_);
    return file;
  }

 private:
  void read_time() {
    const auto array = file_.numbers("/time");
    if (!array || array->shape.size() != 1 || array->values.empty())
      throw InputError({path_}, "no dataset /time with one time (s) a sample", "add it");
    time_ = array->values;
    clear_small(time_);
    if (const auto unit = file_.text_attribute("/time", "unit"); unit && !unit->empty()) {
      const std::optional<Unit> known = unit_of(unit_of_time("time", *unit));
      if (!known)
        throw InputError({path_}, "the unit " + in_quotes(*unit) + " of /time is none of a time",
                         "write one of " + units_like("s"));
      for (double& t : time_) t *= known->factor;
    }
    if (const std::string objection = objection_to(time_); !objection.empty())
      mistakes_.add({path_}, "/time holds a number that " + objection, "give finite times");
    else
      check_times(
          time_, [this](std::size_t n) { return Place{path_ + ": /time[" + std::to_string(n) + "]"}; }, mistakes_);
  }

  void read_load(const std::string& name) {
    const std::size_t k = find(loads_, name);
    if (k == loads_.size()) {
      unknown_ = true;
      return add_unknown_load({path_}, "dataset", name, loads_, mistakes_);
    }
    auto array = file_.numbers("/" + name);
    if (!array)
      return mistakes_.add({path_}, "/" + excerpt(name) + " cannot be read as numbers", "write it as an array");
    clear_small(array->values);
    const double factor =
        factor_to_load(file_.text_attribute("/" + name, "unit").value_or(""), k, units_, {path_}, "/" + excerpt(name));
    for (double& value : array->values) value *= factor;
    const std::size_t rank = array->shape.size();
    if (rank < 1 || rank > 2 || array->shape.back() != time_.size() || array->values.empty())
      mistakes_.add({path_}, "/" + name + " has the shape " + shape_text(*array),
                    "give it the length of /time, " + std::to_string(time_.size()) + ", or waves x that length");
    else if (const std::string objection = objection_to(array->values); !objection.empty())
      mistakes_.add({path_}, "/" + name + " holds a number that " + objection, "give finite numbers");
    else if (rank == 2 && !several_.empty() && array->shape[0] != n_waves_)
      mistakes_.add({path_},
                    "/" + name + " has " + std::to_string(array->shape[0]) + " waves, /" + several_ + " has " +
                        std::to_string(n_waves_),
                    "give every load of the file as many waves");
    else if (rank == 2)
      note_waves(name, array->shape[0]);
    values_.emplace(k, std::move(*array));
  }

  void note_waves(const std::string& name, std::size_t n) {
    several_ = name;
    n_waves_ = n;
  }

  std::string path_;
  const Names &loads_, &units_;
  Hdf5Reader file_;
  Diagnostics mistakes_;
  std::vector<double> time_;
  std::map<std::size_t, NumberArray> values_;  ///< by load
  std::size_t n_waves_ = 1;
  std::string several_;   ///< a load that is given for each wave
  bool unknown_ = false;  ///< a dataset was no load, and that has been reported
};

/// The waves of one HDF5 file, without a name; throws InputError.
WaveFile read_hdf5_waves(const std::string& path, const Names& loads, const Names& units) {
  return WaveDatasets(path, loads, units).take();
}

namespace fs = std::filesystem;

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
    std::size_t k = find(loads, table.names[c]);
    if (const auto end = unit_at_end(table.names[c]); k == loads.size() && end) k = find(loads, end->name);
    if (k == loads.size())
      add_unknown_load(header, "column", table.names[c], loads, mistakes);
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
  check_times(
      file.time, [&table](std::size_t row) { return table.place(row); }, mistakes);
  mistakes.throw_if_any();
  file.n_loads = static_cast<int>(loads.size());
  file.value.setZero(file.n_loads, static_cast<Eigen::Index>(file.time.size()));
  for (std::size_t i = 0; i < load.size(); ++i) {
    const std::vector<double> values = in_unit_of_load(table, layout.values[i], load[i], units);
    file.value.row(static_cast<Eigen::Index>(load[i])) =
        Eigen::Map<const Eigen::RowVectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  }
  note_layout(table, layout, file.notes);
  return file;
}

/// What the records of a file's waves are wrong by, where an answer goes on until `end`.
void note_faults(WaveFile& file, double end) {
  NumberedWarnings all;
  for (Eigen::Index row = 0; row < file.value.rows(); ++row) {
    const Eigen::RowVectorXd values = file.value.row(row);
    if (values.isZero(0.)) continue;  // load_zero
    append(all, record_warnings({file.name, file.time, {values.data(), values.data() + values.size()}, end}));
  }
  append(file.notes.warnings, first_of_each(all, "more of its waves and loads, too"));
}

/// Appends -2, -3, ... to a name that another file has, too.
void number_duplicates(std::vector<WaveFile>& files) {
  Names taken;
  for (WaveFile& file : files) {
    const std::string name = file.name;
    for (int n = 2; find(taken, file.name) < taken.size(); ++n) file.name = name + "-" + std::to_string(n);
    taken.push_back(file.name);
  }
}

}  // namespace

NumberedWarnings first_of_each(const NumberedWarnings& all, const std::string& others) {
  std::map<std::string, NumberedWarning> first;
  std::map<std::string, int> number;
  for (const NumberedWarning& warning : all) {
    NumberedWarning& one = first.emplace(warning.name, warning).first->second;
    if (warning.voids && !one.voids) one = warning;
    ++number[warning.name];
  }
  NumberedWarnings list;
  for (auto& [name, warning] : first) {
    if (number[name] > 1) warning.what += "; " + std::to_string(number[name] - 1) + " " + others;
    list.push_back(warning);
  }
  return list;
}

std::vector<WaveFile> read_wave_files(const std::vector<std::string>& paths, const std::vector<std::string>& loads,
                                      const std::vector<std::string>& units, double end) {
  Diagnostics mistakes;
  std::vector<WaveFile> files;
  for (const std::string& path : paths) try {
      files.push_back(is_hdf5(path) ? read_hdf5_waves(path, loads, units) : read_csv_wave(path, loads, units));
      files.back().name = fs::path(path).stem().string();
      note_faults(files.back(), end);
    } catch (const InputError& error) {
      mistakes.add(error.diagnostics());
    }
  mistakes.throw_if_any();
  number_duplicates(files);
  return files;
}

}  // namespace upbead
