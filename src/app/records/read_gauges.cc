#include <algorithm>

#include "gauge_keys.h"
#include "record_table.h"

namespace upbead {

const std::vector<std::pair<std::string, Beyond>> beyond_words{
    {"constant", Beyond::constant}, {"none", Beyond::none}, {"to_zero", Beyond::to_zero}};

const GaugeWords wall_words{"heights",
                            "heights y of the transducers; by the names of their columns",
                            "to_base",
                            "to_crest",
                            "heights y of the wall's base and crest; where the pressure falls to zero",
                            "lowest",
                            "highest"};
const GaugeWords bottom_words{
    "positions",    "positions x of the transducers; by the names of their columns", "to_seaward",
    "to_landward",  "positions x of the bottom's seaward and landward end",          "most seaward",
    "most landward"};

namespace {

class GaugeReader {
 public:
  GaugeReader(const GaugeSource& source, const std::string& file, const std::string& path, const Document& document)
      : source_(source), path_(path), document_(document), table_(read_record_table(file, place("gauges"))) {}

  Gauges run() {
    Gauges gauges;
    gauges.beyond = {source_.to_first, source_.to_last};
    if (source_.ends) gauges.zero_at = *source_.ends;
    gauges.time = times();
    find_columns(gauges);
    mistakes_.throw_if_any();
    first_ =
        static_cast<std::size_t>(std::lower_bound(gauges.time.begin(), gauges.time.end(), 0.) - gauges.time.begin());
    if (gauges.time.size() - first_ < 2)
      throw InputError(place("record_start"), "the record is over before the run begins",
                       "give an earlier record_start");
    for (std::vector<double>& p : gauges.pressure) cut(p, gauges.time);
    if (!gauges.load_cell.empty()) cut(gauges.load_cell, gauges.time);
    gauges.time.erase(gauges.time.begin(), gauges.time.begin() + static_cast<std::ptrdiff_t>(first_));
    return gauges;
  }

 private:
  Place place(const std::string& key) const { return document_.place(path_ + "." + key); }

  /// In the run's time.
  std::vector<double> times() {
    std::vector<double> time;
    if (source_.sampling_rate) {
      time.resize(table_.n_rows());
      for (std::size_t i = 0; i < time.size(); ++i) time[i] = static_cast<double>(i) / *source_.sampling_rate;
    } else {
      time = in_si(table_, 0, "s");
    }
    for (std::size_t i = 1; i < time.size(); ++i)
      if (!(time[i] > time[i - 1])) {
        mistakes_.add(table_.place(i),
                      "t = " + number_text(time[i]) + " s does not follow t = " + number_text(time[i - 1]) + " s",
                      "let the times ascend strictly, or give sampling_rate where there is no column of times");
        break;
      }
    at_rest_ = static_cast<std::size_t>(
        std::count_if(time.begin(), time.end(), [&](double t) { return t - time.front() < source_.zero; }));
    for (double& t : time) t -= source_.record_start;
    return time;
  }

  /// Columns in the order of their places.
  void find_columns(Gauges& gauges) {
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [name, at] : source_.place) order.emplace_back(at, name);
    std::sort(order.begin(), order.end());
    for (const auto& [at, name] : order) {
      gauges.name.push_back(name);
      gauges.place.push_back(at);
      gauges.pressure.push_back(column(name, "Pa", source_.gauge_unit));
    }
    if (!source_.load_cell.empty()) gauges.load_cell = column(source_.load_cell, "N/m", "");
  }

  /// With its mean at rest taken off; empty where there is none.
  std::vector<double> column(const std::string& name, const std::string& si, const std::string& unit) {
    const auto found = std::find(table_.names.begin(), table_.names.end(), name);
    if (found == table_.names.end()) {
      mistakes_.add(place("gauges"), "'" + table_.path + "' has no column '" + name + "'",
                    suggestion(name, table_.names, "columns"));
      return {};
    }
    std::vector<double> values;
    try {
      values = in_si(table_, static_cast<std::size_t>(found - table_.names.begin()), si, unit);
    } catch (const InputError& error) {
      mistakes_.add(error);
      return {};
    }
    if (at_rest_ > 0) {
      double mean = 0.;
      for (std::size_t i = 0; i < at_rest_; ++i) mean += values[i] / static_cast<double>(at_rest_);
      for (double& value : values) value -= mean;
    }
    return values;
  }

  void cut(std::vector<double>& values, const std::vector<double>&) const {
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first_));
  }

  const GaugeSource& source_;
  std::string path_;
  const Document& document_;
  CsvTable table_;
  Mistakes mistakes_;
  std::size_t at_rest_ = 0, first_ = 0;  ///< samples of the beginning; the first from t = 0 on
};

}  // namespace

Gauges read_gauges(const GaugeSource& source, const std::string& file, const std::string& path,
                   const Document& document) {
  return GaugeReader(source, file, path, document).run();
}

}  // namespace upbead
