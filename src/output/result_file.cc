#include "output/result_file.h"

#include "hdf5_image.h"

namespace upbead {

std::string dataset_file(const std::string& title, const std::vector<Dataset>& datasets) {
  detail::Hdf5Image image(title);
  for (const Dataset& dataset : datasets) {
    const std::string path = "/" + dataset.name;
    std::vector<hsize_t> shape{dataset.values.size() / dataset.columns};
    if (dataset.columns > 1) shape.push_back(dataset.columns);
    const detail::Label label{dataset.unit, dataset.description};
    if (dataset.may_lack)
      image.numbers_or_none(path, dataset.values, label);
    else
      image.numbers(path, shape, dataset.values.data(), label);
    if (!dataset.reading.empty()) image.attribute(path, "reading", dataset.reading);
  }
  return image.bytes();
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

std::string table_file(const std::string& title, const std::vector<TableColumn>& columns) {
  detail::Hdf5Image image(title);
  for (const TableColumn& column : columns) {
    if (column.texts.empty())
      image.numbers("/" + column.path, {column.numbers.size()}, column.numbers.data(),
                    {column.unit, column.description});
    else
      image.texts("/" + column.path, column.texts);
  }
  return image.bytes();
}

}  // namespace upbead
