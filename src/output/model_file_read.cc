#include <cmath>
#include <numeric>

#include "model_layout.h"
#include "upbead/base/suggest.h"
#include "upbead/base/text.h"
#include "upbead/output/hdf5_reader.h"
#include "upbead/output/model_file.h"

namespace upbead {

namespace {

using Shape = std::vector<std::size_t>;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr const char* again = "make it again with 'upbead reduce'";

std::string to_string(const Shape& shape) {
  std::vector<std::string> sizes;
  if (shape.empty()) return "of a single number";
  for (const std::size_t size : shape) sizes.push_back(std::to_string(size));
  return join(sizes, " x ");
}

/// Reads the parts of a model and collects what is wrong with them; a wrong part comes back empty.
class Parts {
 public:
  explicit Parts(const std::string& path) : path_(path), file_(path, "a model made by 'upbead reduce'") {}

  void require_kind() const {
    if (file_.text_attribute("/", "kind").value_or("") != detail::model_layout::kind)
      throw InputError({path_}, "an HDF5 file, but no reduced model", "give a model made by 'upbead reduce'");
    const double version = file_.number_attribute("/", "format_version").value_or(0.);
    if (version != detail::model_layout::version)
      throw InputError({path_},
                       "a reduced model in format " + significant(version) + "; this program reads format " +
                           std::to_string(detail::model_layout::version),
                       std::string(again) + " of the same version");
  }

  std::string text(const std::string& object, const std::string& name) {
    const auto value = file_.text_attribute(object, name);
    if (!value) wrong("the attribute '" + name + "' of " + object + " is missing");
    return value.value_or("");
  }

  /// A number that is finite and not below zero, nor zero where it must be positive.
  double number(const std::string& object, const std::string& name, bool positive = false) {
    const auto value = file_.number_attribute(object, name);
    if (!value)
      wrong("the attribute '" + name + "' of " + object + " is missing");
    else if (!std::isfinite(*value) || *value < 0. || (positive && *value == 0.))
      wrong("the attribute '" + name + "' of " + object + " is " + significant(*value));
    return value.value_or(0.);
  }

  std::optional<double> optional_number(const std::string& object, const std::string& name) {
    if (!file_.number_attribute(object, name)) return {};
    return number(object, name);
  }

  int count(const std::string& object, const std::string& name) {
    const double value = number(object, name);
    return value < 2e9 ? static_cast<int>(value) : 0;
  }

  std::vector<std::string> texts(const std::string& path, std::optional<std::size_t> size = {}) {
    auto values = file_.texts(path);
    if (!values)
      wrong(path + " is missing, or holds no texts");
    else if (size && values->size() != *size)
      wrong(path + " has " + std::to_string(values->size()) + " entries, not " + std::to_string(*size));
    return values && (!size || values->size() == *size) ? *values : std::vector<std::string>(size.value_or(0));
  }

  /// Finite numbers of that shape; zeros of that shape where they are wrong.
  std::vector<double> numbers(const std::string& path, const Shape& shape) {
    auto array = file_.numbers(path);
    if (!array)
      wrong(path + " is missing, or cannot be read as numbers");
    else if (array->shape != shape)
      wrong(path + " has the shape " + to_string(array->shape) + ", not " + to_string(shape));
    else if (!all_finite(array->values))
      wrong(path + " holds a number that is not finite");
    else
      return std::move(array->values);
    return std::vector<double>(std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()));
  }

  Eigen::MatrixXd matrix(const std::string& path, std::size_t rows, std::size_t columns) {
    const std::vector<double> values = numbers(path, {rows, columns});
    return Eigen::Map<const RowMajor>(values.data(), static_cast<Eigen::Index>(rows),
                                      static_cast<Eigen::Index>(columns));
  }

  Eigen::MatrixXcd complex_matrix(const std::string& path, Shape shape) {
    const auto columns = static_cast<Eigen::Index>(shape.size() > 1 ? shape[1] : 1);
    const auto rows = static_cast<Eigen::Index>(shape[0]);
    shape.push_back(2);
    const std::vector<double> values = numbers(path, shape);
    Eigen::MatrixXcd matrix(rows, columns);
    for (Eigen::Index r = 0; r < rows; ++r)
      for (Eigen::Index c = 0; c < columns; ++c) {
        const auto pair = static_cast<std::size_t>(2 * (r * columns + c));
        matrix(r, c) = {values[pair], values[pair + 1]};
      }
    return matrix;
  }

  /// The length of a dataset's first axis; 0 where it is none.
  std::size_t length(const std::string& path) const {
    const auto array = file_.numbers(path);
    return array && !array->shape.empty() ? array->shape[0] : 0;
  }

  void wrong(const std::string& what) { mistakes_.add({path_}, what, again); }
  void throw_if_any() const { mistakes_.throw_if_any(); }

 private:
  static bool all_finite(const std::vector<double>& values) {
    for (const double value : values)
      if (!std::isfinite(value)) return false;
    return true;
  }

  std::string path_;
  Hdf5Reader file_;
  Mistakes mistakes_;
};

void read_loads(Parts& parts, ReducedModelFile& model) {
  const std::vector<std::string> names = parts.texts("/loads/name");
  const std::size_t k = names.size();
  if (k == 0) parts.wrong("/loads/name names no load");
  const std::vector<std::string> units = parts.texts("/loads/unit", k);
  const std::vector<double> peaks = parts.numbers("/loads/peak", {k}),
                            durations = parts.numbers("/loads/duration", {k});
  for (std::size_t n = 0; n < k; ++n) model.loads.push_back({names[n], units[n], peaks[n], durations[n]});
  model.modes.load_name = names;
}

void read_readings(Parts& parts, ReducedModelFile& model) {
  const std::vector<std::string> names = parts.texts("/readings/name");
  const std::size_t size = names.size();
  const std::vector<std::string> units = parts.texts("/readings/unit", size);
  const std::vector<std::string> descriptions = parts.texts("/readings/description", size);
  for (std::size_t i = 0; i < size; ++i) model.modes.reading_label.push_back({names[i], units[i], descriptions[i]});
}

void read_modes(Parts& parts, ModalModel& modes) {
  const std::size_t m = parts.length("/modes/pole"), k = modes.load_name.size(), i = modes.reading_label.size();
  modes.pole = parts.complex_matrix("/modes/pole", {m});
  modes.load = parts.complex_matrix("/modes/load", {m, k});
  modes.reading = parts.complex_matrix("/modes/reading", {i, m});
  modes.feedthrough = parts.matrix("/modes/feedthrough", i, k);
  modes.impulse = parts.matrix("/modes/impulse", i, k);
  for (int n = 0; n < modes.n_modes(); ++n)
    if (modes.pole[n].real() > 0.)
      parts.wrong("mode " + std::to_string(n) + " grows: Re of its pole is " + significant(modes.pole[n].real()) +
                  " 1/s, and must not be above 0");
}

void read_validity(Parts& parts, ReducedModelFile& model) {
  model.highest_frequency = parts.number("/validity", "highest_frequency", true);
  model.tolerance = parts.number("/validity", "tolerance");
  model.error = parts.number("/validity", "error");
  model.error_peak = parts.number("/validity", "error_peak");
  model.error_march = parts.optional_number("/validity", "error_march");
}

void read_origin(Parts& parts, ReducedModelFile& model) {
  model.title = parts.text("/", "title");
  const std::vector<std::string> text = parts.texts("/case", 1);
  model.case_text = text.front();
  model.caisson_mass = parts.number("/case", "caisson_mass");
  model.end = parts.number("/case", "end");
  model.unknowns = parts.count("/case", "unknowns");
  model.solves = parts.count("/case", "solves");
  model.factorisations = parts.count("/case", "factorisations");
}

}  // namespace

ReducedModelFile read_model_file(const std::string& path) {
  Parts parts(path);
  parts.require_kind();
  ReducedModelFile model;
  read_origin(parts, model);
  read_loads(parts, model);
  read_readings(parts, model);
  read_modes(parts, model.modes);
  read_validity(parts, model);
  parts.throw_if_any();
  return model;
}

}  // namespace upbead
