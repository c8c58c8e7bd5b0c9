#include "upbead/output/result_file.h"

#include "hdf5_image.h"

namespace upbead {

std::string result_file(const std::string& title, const std::vector<History>& histories) {
  detail::Hdf5Image image(title);
  for (const History& history : histories)
    image.numbers("/history/" + history.name, {history.values.size()}, history.values.data(),
                  {history.unit, history.description});
  return image.bytes();
}

std::string dataset_file(const std::string& title, const std::vector<History>& datasets) {
  detail::Hdf5Image image(title);
  for (const History& dataset : datasets)
    image.numbers("/" + dataset.name, {dataset.values.size()}, dataset.values.data(),
                  {dataset.unit, dataset.description});
  return image.bytes();
}

}  // namespace upbead
