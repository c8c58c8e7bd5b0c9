#include "upbead/output/result_file.h"

#include <deal.II/base/hdf5.h>
#include <hdf5.h>

#include <cmath>
#include <map>

#include "upbead/base/error.h"
#include "upbead/base/version.h"

namespace upbead {

using namespace dealii;

namespace {

void require_finite(const History& history) {
  for (const double value : history.values)
    if (!std::isfinite(value))
      throw NumericsError("the history '" + history.name + "' holds a number that is not finite; nothing was written");
}

/// The group of a dataset's path, made with its parents on first use.
HDF5::Group& group_of(std::map<std::string, HDF5::Group>& groups, HDF5::Group& root, const std::string& path) {
  if (const auto found = groups.find(path); found != groups.end()) return found->second;
  const auto slash = path.rfind('/');
  HDF5::Group& parent = slash == std::string::npos ? root : group_of(groups, root, path.substr(0, slash));
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  return groups.emplace(path, parent.create_group(name)).first->second;
}

void write_histories(HDF5::File& file, const std::string& title, const std::vector<History>& histories) {
  file.set_attribute("title", title);
  file.set_attribute("program", std::string(program_version()));
  std::map<std::string, HDF5::Group> groups;
  for (const History& history : histories) {
    const std::string path = "history/" + history.name;
    const auto slash = path.rfind('/');
    HDF5::Group& group = group_of(groups, file, path.substr(0, slash));
    auto dataset = group.create_dataset<double>(path.substr(slash + 1), {history.values.size()});
    dataset.write(history.values);
    dataset.set_attribute("unit", history.unit);
    dataset.set_attribute("description", history.description);
  }
}

}  // namespace

void write_result_file(const std::string& path, const std::string& place_name, const std::string& title,
                       const std::vector<History>& histories) {
  for (const History& history : histories) require_finite(history);
  H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);  // errors are ours to tell, in words
  try {
    {
      HDF5::File file(path, HDF5::File::FileAccessMode::create);
      write_histories(file, title, histories);
    }
    // What a full disk did not take when the file was closed shows only now: HDF5 refuses to open a truncated file.
    const HDF5::File complete(path, HDF5::File::FileAccessMode::open);
  } catch (const dealii::ExceptionBase&) {
    throw InputError({place_name}, "the results cannot be written",
                     "is the disk full? choose another folder with --out DIR");
  }
}

}  // namespace upbead
