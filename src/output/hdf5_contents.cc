#include "hdf5_contents.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <functional>
#include <optional>
#include <stdexcept>

#include "upbead/base/error.h"

namespace upbead::detail {

namespace {

/// Stops HDF5 from printing each failure to stderr, until the end of the scope: here failures are handled by the
/// caller.
class ErrorsUnprinted {
 public:
  ErrorsUnprinted() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~ErrorsUnprinted() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  ErrorsUnprinted(const ErrorsUnprinted&) = delete;
  ErrorsUnprinted& operator=(const ErrorsUnprinted&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// A shared flock(2) on a file that is read, as HDF5 itself would set, until the end of the scope. Where the file
/// system has none (ENOLCK, ENOSYS, ENOTSUP of some network file systems), the file is read without: HDF5 would call
/// it broken.
class SharedLock {
 public:
  explicit SharedLock(const std::string& path) : file_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    refused_ = file_ >= 0 && flock(file_, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  }
  ~SharedLock() {
    if (file_ >= 0) close(file_);
  }
  SharedLock(const SharedLock&) = delete;
  SharedLock& operator=(const SharedLock&) = delete;
  /// Whether another program holds the lock of a writer.
  bool refused() const { return refused_; }

 private:
  int file_;
  bool refused_ = false;
};

/// Opens the file to read it, without a lock by HDF5; negative where that fails.
hid_t open_unlocked(const std::string& path) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
#if H5_VERSION_GE(1, 12, 1) || (H5_VERSION_GE(1, 10, 7) && !H5_VERSION_GE(1, 12, 0))
  constexpr hbool_t lock = 0, ignore_where_disabled = 1;
  H5Pset_file_locking(access, lock, ignore_where_disabled);
#endif
  return H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
}

/// Reads one object (H5Dread or H5Aread) into a buffer of the given type.
using Read = std::function<herr_t(hid_t type, void* buffer)>;

bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

/// The number of elements of a dataset; none where nothing has been written, or where the file is too small to hold
/// them. So a few damaged bytes, or a dataset without data, cannot ask for all the memory.
std::optional<std::size_t> n_stored(hid_t data, hid_t space) {
  constexpr double most_per_byte = 1100.;  // deflate needs at least 1 byte for 1,032
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

std::optional<NumberArray> read_numbers(hid_t data, hid_t type, hid_t space, const Read& read) {
  const std::optional<std::size_t> n = n_stored(data, space);
  if (!n) return {};
  std::vector<hsize_t> shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  NumberArray array{{shape.begin(), shape.end()}, {}};
  array.values.resize(*n);
  if (!is_number(type) || read(H5T_NATIVE_DOUBLE, array.values.data()) < 0) return {};
  if (!has_its_shape(array)) return {};
  return array;
}

/// Visits the objects of a file.
class ContentsReader {
 public:
  explicit ContentsReader(hid_t file) { visit(file, "", 0); }

  Hdf5Contents contents;

 private:
  static std::vector<std::string> links_of(hid_t group) {
    const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
      static_cast<std::vector<std::string>*>(list)->emplace_back(name);
      return 0;
    };
    std::vector<std::string> list;
    H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &list);
    return list;
  }

  static std::vector<std::string> attributes_of(hid_t object) {
    const auto add = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
      static_cast<std::vector<std::string>*>(list)->emplace_back(name);
      return 0;
    };
    std::vector<std::string> list;
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &list);
    return list;
  }

  /// `path` of the root is "".
  void visit(hid_t object, const std::string& path, int depth) {
    constexpr int deepest = 8, most = 10000;
    if (++n_ > most) return;
    for (const std::string& name : attributes_of(object)) take_attribute(object, {path.empty() ? "/" : path, name});
    if (H5Iget_type(object) == H5I_DATASET) return take_dataset(object, path);
    if (depth == deepest) return;
    const std::vector<std::string> links = links_of(object);
    if (depth == 0) contents.names = links;
    for (const std::string& link : links) {
      const Handle child = Handle::maybe(H5Oopen(object, link.c_str(), H5P_DEFAULT), H5Oclose);
      const H5I_type_t kind = child < 0 ? H5I_BADID : H5Iget_type(child);
      if (kind == H5I_DATASET || kind == H5I_GROUP) visit(child, path + "/" + link, depth + 1);
    }
  }

  void take_dataset(hid_t data, const std::string& path) {
    const Handle type(H5Dget_type(data), H5Tclose), space(H5Dget_space(data), H5Sclose);
    const Read read = [data](hid_t kind, void* buffer) {
      return H5Dread(data, kind, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
    };
    if (is_number(type)) {
      if (auto numbers = read_numbers(data, type, space, read)) contents.numbers[path] = std::move(*numbers);
    } else if (n_stored(data, space)) {
      if (auto texts = read_texts(type, space, read)) contents.texts[path] = std::move(*texts);
    }
  }

  void take_attribute(hid_t object, const AttributeName& name) {
    const Handle attribute = Handle::maybe(H5Aopen(object, name.second.c_str(), H5P_DEFAULT), H5Aclose);
    if (attribute < 0) return;
    const Handle type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
    const Read read = [&attribute](hid_t kind, void* buffer) { return H5Aread(attribute, kind, buffer); };
    if (H5Sget_simple_extent_npoints(space) != 1) return;
    double number = 0.;
    if (is_number(type)) {
      if (read(H5T_NATIVE_DOUBLE, &number) >= 0) contents.number_attributes[name] = number;
    } else if (const auto texts = read_texts(type, space, read)) {
      contents.text_attributes[name] = texts->front();
    }
  }

  int n_ = 0;
};

template <class Value>
void pack(Parcel& parcel, const Value& value) {
  parcel.put(value);
}

void pack(Parcel& parcel, const AttributeName& name) {
  parcel.put(name.first);
  parcel.put(name.second);
}

void pack(Parcel& parcel, const NumberArray& array) {
  parcel.put(array.shape);
  parcel.put(array.values);
}

template <class Key, class Value>
void pack(Parcel& parcel, const std::map<Key, Value>& map) {
  parcel.put(map.size());
  for (const auto& [key, value] : map) {
    pack(parcel, key);
    pack(parcel, value);
  }
}

void unpack(OpenParcel& parcel, double& number) {
  number = parcel.value<double>();
}

void unpack(OpenParcel& parcel, std::string& text) {
  text = parcel.text();
}

void unpack(OpenParcel& parcel, std::vector<std::string>& texts) {
  texts = parcel.texts();
}

void unpack(OpenParcel& parcel, AttributeName& name) {
  unpack(parcel, name.first);
  unpack(parcel, name.second);
}

void unpack(OpenParcel& parcel, NumberArray& array) {
  array.shape = parcel.list<std::size_t>();
  array.values = parcel.list<double>();
  if (!has_its_shape(array)) throw std::runtime_error("an array that has another shape than it says");
}

template <class Key, class Value>
void unpack(OpenParcel& parcel, std::map<Key, Value>& map) {
  for (auto n = parcel.value<std::size_t>(); n > 0; --n) {
    std::pair<Key, Value> entry;
    unpack(parcel, entry.first);
    unpack(parcel, entry.second);
    map.insert_or_assign(std::move(entry.first), std::move(entry.second));
  }
}

/// Continues the checksum `sum` with further bytes.
std::uint32_t crc(const void* data, std::size_t size, std::uint32_t sum = 0) {
  return static_cast<std::uint32_t>(crc32_z(sum, static_cast<const Bytef*>(data), size));
}

/// Files hold texts up to their first zero byte. The zero is included, so that "ab", "c" differs from "a", "bc".
std::uint32_t crc_of_text(const std::string& text, std::uint32_t sum = 0) {
  const std::string kept = text.c_str();
  return crc(kept.c_str(), kept.size() + 1, sum);
}

std::string key_of(const AttributeName& name) {
  return name.first + "\n" + name.second;
}

}  // namespace

bool has_its_shape(const NumberArray& array) {
  if (std::find(array.shape.begin(), array.shape.end(), 0U) != array.shape.end()) return array.values.empty();
  std::size_t n = 1;
  for (const std::size_t size : array.shape)
    if (__builtin_mul_overflow(n, size, &n)) return false;
  return n == array.values.size();
}

Hdf5Contents read_contents(const std::string& path, const std::string& what) {
  const ErrorsUnprinted errors_unprinted;
  if (H5Fis_hdf5(path.c_str()) <= 0) throw InputError({path}, "no HDF5 file", "give " + what);
  const SharedLock lock(path);
  if (lock.refused()) throw InputError({path}, "another program writes to it", "wait until it has been written");
  const Handle file = Handle::maybe(open_unlocked(path), H5Fclose);
  if (file < 0)
    throw InputError({path}, "an HDF5 file that is not whole, or that another program writes to",
                     "wait until it has been written, or make it again");
  return std::move(ContentsReader(file).contents);
}

void put(Parcel& parcel, const Hdf5Contents& contents) {
  parcel.put(contents.names);
  pack(parcel, contents.numbers);
  pack(parcel, contents.texts);
  pack(parcel, contents.number_attributes);
  pack(parcel, contents.text_attributes);
}

Hdf5Contents take_contents(OpenParcel& parcel) {
  Hdf5Contents contents;
  contents.names = parcel.texts();
  unpack(parcel, contents.numbers);
  unpack(parcel, contents.texts);
  unpack(parcel, contents.number_attributes);
  unpack(parcel, contents.text_attributes);
  return contents;
}

void Hdf5Checksum::add(const std::string& path, const std::vector<std::size_t>& shape, const double* values) {
  std::uint32_t sum = 0;
  std::size_t n = 1;
  for (const std::uint64_t size : shape) {
    sum = crc(&size, sizeof size, sum);
    n *= size;
  }
  note(path, n > 0 ? crc(values, n * sizeof(double), sum) : sum);
}

void Hdf5Checksum::add(const std::string& path, const std::vector<std::string>& texts) {
  std::uint32_t sum = 0;
  for (const std::string& text : texts) sum = crc_of_text(text, sum);
  note(path, sum);
}

void Hdf5Checksum::add(const AttributeName& name, double number) {
  note(key_of(name), crc(&number, sizeof number));
}

void Hdf5Checksum::add(const AttributeName& name, const std::string& text) {
  if (name != AttributeName("/", checksum_name)) note(key_of(name), crc_of_text(text));
}

std::string Hdf5Checksum::value() const {
  std::uint32_t sum = 0;
  for (const auto& [key, part] : sums_) sum = crc(&part, sizeof part, crc_of_text(key, sum));
  char text[16];
  std::snprintf(text, sizeof text, "crc32:%08x", sum);
  return text;
}

std::string checksum_of(const Hdf5Contents& contents) {
  Hdf5Checksum checksum;
  for (const auto& [path, array] : contents.numbers) checksum.add(path, array.shape, array.values.data());
  for (const auto& [path, texts] : contents.texts) checksum.add(path, texts);
  for (const auto& [name, number] : contents.number_attributes) checksum.add(name, number);
  for (const auto& [name, text] : contents.text_attributes) checksum.add(name, text);
  return checksum.value();
}

}  // namespace upbead::detail
