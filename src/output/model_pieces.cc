#include "model_pieces.h"

namespace upbead::detail {

void write_matrix(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& values, const Label& label) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = values;
  image.numbers(path, {static_cast<hsize_t>(rows.rows()), static_cast<hsize_t>(rows.cols())}, rows.data(), label);
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

}  // namespace upbead::detail
