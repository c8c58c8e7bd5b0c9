// All contents of an HDF5 file as plain values, which a confined process returns; and what reading and writing of
// such files have in common.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/parcel.h"
#include "output/hdf5_reader.h"

namespace upbead::detail {

/// An HDF5 identifier with the function that closes it. A negative one, HDF5's sign of failure, is a bug where a file
/// is made, so the constructor throws; where a file is read it is possible (see `maybe`).
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error("HDF5 refuses to make an object");
  }
  /// A handle for an identifier that may be negative; then nothing is closed.
  static Handle maybe(hid_t id, herr_t (*close)(hid_t)) { return Handle(id, id < 0 ? nullptr : close, 0); }
  ~Handle() {
    if (close_ != nullptr) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  Handle(hid_t id, herr_t (*close)(hid_t), int) : id_(id), close_(close) {}

  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// An object such as "/modes/pole", and the name of one of its attributes.
using AttributeName = std::pair<std::string, std::string>;

struct Hdf5Contents {
  std::vector<std::string> names;  ///< directly below the root, sorted
  std::map<std::string, NumberArray> numbers;
  std::map<std::string, std::vector<std::string>> texts;
  std::map<AttributeName, double> number_attributes;
  std::map<AttributeName, std::string> text_attributes;
};

/// Reads the file with HDF5: groups down to the eighth level, links followed, at most 10,000 objects. Throws
/// InputError where it is no HDF5 file; `what` as in Hdf5Reader.
Hdf5Contents read_contents(const std::string& path, const std::string& what);

/// Whether there are as many values as the shape says: false for a null dataspace, and for sizes that overflow.
bool has_its_shape(const NumberArray& array);

void put(Parcel& parcel, const Hdf5Contents& contents);
Hdf5Contents take_contents(OpenParcel& parcel);

/// The checksum over everything except the attribute `checksum` of the root. CRC-32 (zlib, as in gzip): it finds
/// accidents and hasty changes. It is no guard against deceit, as anybody can make a new one; for that there are the
/// checks of sizes, signs and finite numbers.
class Hdf5Checksum {
 public:
  void add(const std::string& path, const std::vector<std::size_t>& shape, const double* values);
  void add(const std::string& path, const std::vector<std::string>& texts);
  void add(const AttributeName& name, double number);
  void add(const AttributeName& name, const std::string& text);
  /// As text; it does not depend on the order in which things were added.
  std::string value() const;

 private:
  void note(const std::string& key, std::uint32_t sum) { sums_[key] = sum; }
  std::map<std::string, std::uint32_t> sums_;
};

inline const char* const checksum_name = "checksum";

std::string checksum_of(const Hdf5Contents& contents);

}  // namespace upbead::detail
