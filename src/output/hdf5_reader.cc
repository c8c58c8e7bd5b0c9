#include "upbead/output/hdf5_reader.h"

#include <filesystem>
#include <fstream>
#include <functional>

#include "hdf5_handle.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using detail::Handle;

/// HDF5 tells of every failure on stderr; here failures are answers. Holds until the end of the scope.
class Silence {
 public:
  Silence() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// Reads into a buffer of the type: H5Dread or H5Aread of one object.
using Read = std::function<herr_t(hid_t type, void* buffer)>;

bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

/// The number of elements of a dataset that the file really holds: none where nothing has been written, or where the
/// file is too small for them. So a few damaged bytes, or a dataset without data, do not ask for all the memory.
std::optional<std::size_t> n_stored(hid_t data, hid_t space) {
  constexpr double most_per_byte = 1100.;  // of deflate, which takes 1 byte for 1,032
  const hssize_t n = H5Sget_simple_extent_npoints(space);
  if (n < 0) return {};
  const auto stored = static_cast<double>(H5Dget_storage_size(data));
  hsize_t size = 0;
  if (H5Fget_filesize(Handle(H5Iget_file_id(data), H5Fclose), &size) < 0) return {};
  if (stored > static_cast<double>(size) || static_cast<double>(n) > most_per_byte * stored) return {};
  return static_cast<std::size_t>(n);
}

std::optional<std::vector<std::string>> read_texts(hid_t type, hid_t space, const Read& read) {
  if (H5Tget_class(type) != H5T_STRING) return {};
  const auto n = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  std::vector<std::string> texts;
  if (H5Tis_variable_str(type) > 0) {
    std::vector<char*> pointers(n, nullptr);
    if (read(type, pointers.data()) < 0) return {};
    for (const char* pointer : pointers) texts.emplace_back(pointer != nullptr ? pointer : "");
    H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
    return texts;
  }
  const std::size_t size = H5Tget_size(type);
  std::string buffer(n * size, '\0');
  if (read(type, buffer.data()) < 0) return {};
  for (std::size_t i = 0; i < n; ++i) texts.emplace_back(buffer.substr(i * size, size).c_str());
  return texts;
}

Read reader_of(const Handle& data) {
  return [&data](hid_t type, void* buffer) { return H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer); };
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::string& path, const std::string& what) {
  const Silence silence;
  std::error_code ignored;  // what may not be looked at cannot be read either
  if (std::filesystem::is_directory(path, ignored)) throw InputError({path}, "a folder, not a file", "give " + what);
  if (!std::ifstream(path).good()) throw InputError({}, "cannot read '" + path + "'", "check the path and the rights");
  if (H5Fis_hdf5(path.c_str()) <= 0) throw InputError({path}, "no HDF5 file", "give " + what);
  file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file_ < 0)
    throw InputError({path}, "an HDF5 file that is not whole, or that another program writes to",
                     "wait until it has been written, or make it again");
}

Hdf5Reader::~Hdf5Reader() {
  H5Fclose(file_);
}

std::vector<std::string> Hdf5Reader::names() const {
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  std::vector<std::string> list;
  H5Literate(file_, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &list);
  return list;
}

std::optional<NumberArray> Hdf5Reader::numbers(const std::string& path) const {
  const Silence silence;
  const Handle data = Handle::maybe(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (data < 0) return {};
  const Handle type(H5Dget_type(data), H5Tclose), space(H5Dget_space(data), H5Sclose);
  const std::optional<std::size_t> n = n_stored(data, space);
  if (!is_number(type) || !n) return {};
  std::vector<hsize_t> shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  NumberArray array{{shape.begin(), shape.end()}, {}};
  array.values.resize(*n);
  if (reader_of(data)(H5T_NATIVE_DOUBLE, array.values.data()) < 0) return {};
  return array;
}

std::optional<std::vector<std::string>> Hdf5Reader::texts(const std::string& path) const {
  const Silence silence;
  const Handle data = Handle::maybe(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (data < 0) return {};
  const Handle type(H5Dget_type(data), H5Tclose), space(H5Dget_space(data), H5Sclose);
  if (!n_stored(data, space)) return {};
  return read_texts(type, space, reader_of(data));
}

std::optional<double> Hdf5Reader::number_attribute(const std::string& object, const std::string& name) const {
  const Silence silence;
  const Handle attribute =
      Handle::maybe(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (attribute < 0) return {};
  const Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  double value = 0.;
  if (!is_number(type) || H5Sget_simple_extent_npoints(space) != 1) return {};
  if (H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0) return {};
  return value;
}

std::optional<std::string> Hdf5Reader::text_attribute(const std::string& object, const std::string& name) const {
  const Silence silence;
  const Handle attribute =
      Handle::maybe(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (attribute < 0) return {};
  const auto texts = read_texts(Handle(H5Aget_type(attribute), H5Tclose), Handle(H5Aget_space(attribute), H5Sclose),
                                [&](hid_t type, void* buffer) { return H5Aread(attribute, type, buffer); });
  if (!texts || texts->size() != 1) return {};
  return texts->front();
}

}  // namespace upbead
