#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers.h"
#include "base/text.h"
#include "base/units.h"
#include "case/records/record_layout.h"
#include "output/hdf5_reader.h"
#include "wave_checks.h"

namespace upbead::detail {

namespace {

/// What is left of numbers that decay in some program, as in CSV files.
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
  std::string several_;   ///< a load that is given wave by wave
  bool unknown_ = false;  ///< a dataset was no load, and has been told
};

}  // namespace

WaveFile read_hdf5_waves(const std::string& path, const Names& loads, const Names& units) {
  return WaveDatasets(path, loads, units).take();
}

}  // namespace upbead::detail
