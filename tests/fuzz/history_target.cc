// An accepted table holds finite numbers; a history made of it is finite and passes through its samples; the force
// and the warnings of transducers are finite.
#include <cmath>

#include "base/csv.h"
#include "base/table_text.h"
#include "case/records/gauge_load.h"
#include "case/records/history_load.h"
#include "respond/wave_files.h"
#include "respond/wave_grid.h"
#include "target.h"

namespace upbead::fuzz {

namespace {

void check_table(const CsvTable& table) {
  require(table.n_rows() > 0 && table.columns.size() == table.names.size(), "a table has rows and named columns");
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    require(table.columns[c].size() == table.n_rows(), "all columns are as long");
    read_or_refuse([&] {
      for (const double number : table.numbers(c)) require(std::isfinite(number), "numbers are finite");
    });
  }
  for (const std::string& name : table.names) require(end_of_utf8(name) == name.size(), "names are text");
}

void check_function(const TimeFunction& f) {
  const std::vector<double>& time = f.samples();
  for (std::size_t i = 0; i < time.size(); ++i) {
    require(std::isfinite(f(time[i])), "a history is finite at its samples");
    if (i > 0) require(std::isfinite(f(0.5 * (time[i - 1] + time[i]))), "a history is finite between its samples");
  }
  if (time.size() > 40) return;  // the remaining checks take long
  require(std::isfinite(integral(f, 0., time.back())), "the integral of a history is finite");
  const Extremum highest = extremum(f, 0., time.back(), 1), lowest = extremum(f, 0., time.back(), -1);
  require(highest.value >= lowest.value, "the highest value is not below the lowest");
}

void check_waves(const WaveFile& file) {
  for (int w = 0; w < file.n_waves(); ++w) require(file.wave(w).allFinite(), "waves are finite");
  constexpr double many = 1000.;
  const double end = file.time.back();
  const WaveGrid grid = make_wave_grid(file.time, end / many, end);
  for (int w = 0; w < file.n_waves(); ++w) {
    const SampledLoads loads = with_jumps(on_grid(file, w, grid.time), grid);
    require(loads.begin.allFinite() && loads.end.allFinite(), "waves are finite on a grid");
  }
}

/// Checks the table as a record of transducers, one in every column but the first.
void check_gauges(const CsvTable& table, const std::string& path) {
  GaugeKeys source;
  for (std::size_t c = 1; c < table.names.size(); ++c) source.place[table.names[c]] = static_cast<double>(c);
  source.ends = {0., static_cast<double>(table.names.size())};
  source.to_last = Beyond::to_zero;
  source.zero = 0.1;
  Gauges gauges;
  if (!read_or_refuse([&] { gauges = read_gauges(source, path, "loads.wall", Document()).gauges; })) return;
  const Resultant sum = resultant(gauges, 0., static_cast<double>(table.names.size()));
  for (std::size_t t = 0; t < gauges.time.size(); ++t)
    require(std::isfinite(sum.force[t]) && std::isfinite(sum.moment[t]), "the force by transducers is finite");
  const InterpolationError error = interpolation_error(gauges);
  require(std::isfinite(error.force) && std::isfinite(error.arm), "its error is finite");
  for (const NumberedWarning& warning : gauge_warnings("loads.wall", gauges, sum.force))
    require(std::isfinite(warning.value) && std::isfinite(warning.limit), "warnings have numbers");
}

}  // namespace

void try_history(std::string_view bytes) {
  const std::string path = memory_file("history.csv", bytes);
  const Place key{"case.toml", 1, 1};
  CsvTable table;
  if (!read_or_refuse([&] { check_table(table = read_csv(path, key)); })) return;
  if (table.names.size() > 1) check_gauges(table, path);
  FileHistory history;
  if (read_or_refuse([&] { history = read_history(path, key, LoadKind::force, 1., {}); })) {
    check_function(history.function);
    require(history.duration.value_or(0.) >= 0., "a duration is a number, not below zero");
  }
  read_or_refuse([&] { check_function(read_uplift(path, key, {}).function); });
  read_or_refuse([&] { check_waves(read_wave_files({path}, {"impact", "slow"}).front()); });
  read_or_refuse([&] { check_waves(read_wave_files({path}, {"impact"}).front()); });
}

}  // namespace upbead::fuzz
