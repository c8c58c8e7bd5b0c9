#include "model_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/numbers.h"
#include "base/text.h"

namespace upbead::detail {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::string command_in_quotes(const ModelKind& kind) {
  return "'" + std::string(kind.command) + "'";
}

std::string made_by(const ModelKind& kind) {
  return "a model made by " + command_in_quotes(kind);
}

std::string again(const ModelKind& kind) {
  return "make it again with " + command_in_quotes(kind);
}

std::string formats(const ModelKind& kind) {
  if (kind.oldest == kind.newest) return "reads format " + std::to_string(kind.oldest);
  return "reads formats " + std::to_string(kind.oldest) + " and " + std::to_string(kind.newest);
}

std::string to_string(const ModelParts::Shape& shape) {
  std::vector<std::string> sizes;
  if (shape.empty()) return "of a single number";
  for (const std::size_t size : shape) sizes.push_back(std::to_string(size));
  return join(sizes, " x ");
}

}  // namespace

ModelParts::ModelParts(const std::string& path, const std::vector<ModelKind>& kinds)
    : path_(path), file_(path, made_by(kinds.front())), kind_(kinds.front()) {
  const std::string told = file_.text_attribute("/", "kind").value_or("");
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const ModelKind& kind) { return told == kind.kind; });
  if (found == kinds.end())
    throw InputError({path_}, "an HDF5 file, but no " + std::string(kind_.name), "give " + made_by(kind_));
  kind_ = *found;
  const double version = file_.number_attribute("/", "format_version").value_or(0.);
  if (version < kind_.oldest || version > kind_.newest || version != std::floor(version))
    throw InputError(
        {path_},
        "a " + std::string(kind_.name) + " in format " + significant(version) + "; this program " + formats(kind_),
        again(kind_) + " of the same version");
}

std::string ModelParts::text(const std::string& object, const std::string& name) {
  const auto value = file_.text_attribute(object, name);
  if (!value) wrong("the attribute '" + name + "' of " + object + " is missing");
  return value.value_or("");
}

double ModelParts::number(const std::string& object, const std::string& name, bool above_0) {
  const auto value = file_.number_attribute(object, name);
  if (!value)
    wrong("the attribute '" + name + "' of " + object + " is missing");
  else if (!objection_to({*value}).empty() || *value < 0. || (above_0 && *value == 0.))
    wrong("the attribute '" + name + "' of " + object + " is " + significant(*value));
  return value.value_or(0.);
}

std::optional<double> ModelParts::optional_number(const std::string& object, const std::string& name) {
  if (!file_.number_attribute(object, name)) return {};
  return number(object, name);
}

bool ModelParts::has(const std::string& object, const std::string& name) const {
  return file_.number_attribute(object, name).has_value();
}

int ModelParts::count(const std::string& object, const std::string& name) {
  constexpr double most = 2e9;  // fits an int
  return static_cast<int>(std::clamp(number(object, name), 0., most));
}

std::vector<std::string> ModelParts::texts(const std::string& path, std::optional<std::size_t> size) {
  const auto values = file_.texts(path);
  if (values && (!size || values->size() == *size)) return *values;
  wrong(values ? path + " has " + std::to_string(values->size()) + " entries, not " + std::to_string(*size)
               : path + " is missing, or holds no texts");
  return std::vector<std::string>(size.value_or(0));
}

std::vector<double> ModelParts::numbers(const std::string& path, const Shape& shape) {
  auto array = file_.numbers(path);
  if (!array)
    wrong(path + " is missing, or cannot be read as numbers");
  else if (array->shape != shape)
    wrong(path + " has the shape " + to_string(array->shape) + ", not " + to_string(shape));
  else if (const std::string objection = objection_to(array->values); !objection.empty())
    wrong(path + " holds a number that " + objection);
  else
    return std::move(array->values);
  constexpr double many = 1e8;  // a wrong part is replaced by zeros, only to check the other parts as well
  if (std::accumulate(shape.begin(), shape.end(), 1., std::multiplies<>()) > many) mistakes_.throw_if_any();
  return std::vector<double>(std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()));
}

Eigen::MatrixXd ModelParts::matrix(const std::string& path, std::size_t rows, std::size_t columns) {
  const std::vector<double> values = numbers(path, {rows, columns});
  return Eigen::Map<const RowMajor>(values.data(), static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
}

Eigen::MatrixXcd ModelParts::complex_matrix(const std::string& path, Shape shape) {
  const auto rows = static_cast<Eigen::Index>(shape[0]);
  const auto columns = static_cast<Eigen::Index>(shape.size() > 1 ? shape[1] : 1);
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

std::size_t ModelParts::length(const std::string& path) const {
  const auto array = file_.numbers(path);
  return array && !array->shape.empty() ? array->shape[0] : 0;
}

std::size_t ModelParts::width(const std::string& path) const {
  const auto array = file_.numbers(path);
  return array && array->shape.size() > 1 ? array->shape[1] : 0;
}

void ModelParts::require_checksum() {
  if (mistakes_.empty() && !file_.checksum_holds().value_or(true))
    wrong("its checksum does not fit: numbers or texts were changed after " + command_in_quotes(kind_) +
          " had written them");
}

void ModelParts::wrong(const std::string& what) {
  mistakes_.add({path_}, what, again(kind_));
}

void write_matrix(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& values, const Label& label) {
  const RowMajor rows = values;
  image.numbers(path, {static_cast<hsize_t>(rows.rows()), static_cast<hsize_t>(rows.cols())}, rows.data(), label);
}

void write_packed(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& values, const Label& label) {
  const RowMajor rows = values;
  image.packed_numbers(path, {static_cast<hsize_t>(rows.rows()), static_cast<hsize_t>(rows.cols())}, rows.data(),
                       label);
}

void write_labels(Hdf5Image& image, const std::string& group, const std::vector<ReadingLabel>& labels) {
  std::vector<std::string> name, unit, description;
  for (const ReadingLabel& label : labels) {
    name.push_back(label.name);
    unit.push_back(label.unit);
    description.push_back(label.description);
  }
  image.group(group);
  image.texts(group + "/name", name);
  image.texts(group + "/unit", unit);
  image.texts(group + "/description", description);
}

std::vector<ReadingLabel> read_labels(ModelParts& parts, const std::string& group) {
  const std::vector<std::string> names = parts.texts(group + "/name");
  const std::size_t size = names.size();
  const std::vector<std::string> units = parts.texts(group + "/unit", size);
  const std::vector<std::string> descriptions = parts.texts(group + "/description", size);
  std::vector<ReadingLabel> labels;
  for (std::size_t i = 0; i < size; ++i) labels.push_back({names[i], units[i], descriptions[i]});
  return labels;
}

std::vector<int> read_indices(ModelParts& parts, const std::string& path, std::size_t size, int least, int end) {
  std::vector<int> list;
  for (const double value : parts.numbers(path, {size})) {
    const bool fits = value >= least && value < end && value == std::floor(value);
    if (!fits) parts.wrong(path + " holds " + significant(value));
    list.push_back(fits ? static_cast<int>(value) : least);
  }
  return list;
}

void require_prescribed(ModelParts& parts, const std::string& group, const ReducedSystem& s) {
  std::vector<int> coordinates;
  for (const int p : s.prescribed)
    if (p >= 0) coordinates.push_back(p);
  std::sort(coordinates.begin(), coordinates.end());
  std::vector<int> first(static_cast<std::size_t>(std::clamp(s.n_prescribed, 0, s.size())));
  std::iota(first.begin(), first.end(), 0);
  if (coordinates != first || s.n_prescribed > s.size())
    parts.wrong(group + "/prescribed does not fit its n_prescribed, " + std::to_string(s.n_prescribed));
}

}  // namespace upbead::detail
