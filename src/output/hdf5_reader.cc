#include "output/hdf5_reader.h"

#include <filesystem>
#include <limits>
#include <stdexcept>

#include "base/confined_work.h"
#include "base/text_file.h"
#include "hdf5_contents.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

namespace fs = std::filesystem;
using detail::Hdf5Contents;

void require_file(const std::string& path, const std::string& what) {
  std::error_code ignored;  // a file without permission cannot be read either
  if (fs::is_directory(path, ignored)) throw InputError({path}, "a folder, not a file", "give " + what);
  require_readable(path, std::numeric_limits<std::uintmax_t>::max(), {});
}

template <class Map, class Key>
std::optional<typename Map::mapped_type> found(const Map& map, const Key& key) {
  const auto at = map.find(key);
  return at == map.end() ? std::nullopt : std::optional(at->second);
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::string& path, const std::string& what) {
  require_file(path, what);
  const ConfinedOutcome outcome = work_confined(
      [&] {
        Parcel parcel;
        put(parcel, detail::read_contents(path, what));
        return parcel.take();
      },
      limits_for_file(path));
  if (!outcome.result) throw InputError({path}, "HDF5 " + outcome.end + " on it, so it is damaged", "give " + what);
  try {
    OpenParcel parcel(*outcome.result);
    contents_ = std::make_unique<const Hdf5Contents>(detail::take_contents(parcel));
  } catch (const std::runtime_error& error) {  // the file may have controlled the other process
    throw InputError({path}, "what HDF5 reads of it does not fit together: " + std::string(error.what()),
                     "give " + what);
  }
}

Hdf5Reader::~Hdf5Reader() = default;

const std::vector<std::string>& Hdf5Reader::names() const {
  return contents_->names;
}

std::optional<NumberArray> Hdf5Reader::numbers(const std::string& path) const {
  return found(contents_->numbers, path);
}

std::optional<std::vector<std::string>> Hdf5Reader::texts(const std::string& path) const {
  return found(contents_->texts, path);
}

std::optional<double> Hdf5Reader::number_attribute(const std::string& object, const std::string& name) const {
  return found(contents_->number_attributes, std::pair(object, name));
}

std::optional<std::string> Hdf5Reader::text_attribute(const std::string& object, const std::string& name) const {
  return found(contents_->text_attributes, std::pair(object, name));
}

std::optional<bool> Hdf5Reader::checksum_holds() const {
  const auto told = text_attribute("/", detail::checksum_name);
  if (!told) return std::nullopt;
  return *told == detail::checksum_of(*contents_);
}

}  // namespace upbead
