// Everything that an HDF5 file says, as plain values: what a confined process hands back of it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/parcel.h"
#include "output/hdf5_reader.h"

namespace upbead::detail {

/// An object such as "/modes/pole", and the name of one of its attributes.
using AttributeName = std::pair<std::string, std::string>;

struct Hdf5Contents {
  std::vector<std::string> names;  ///< directly below the root, sorted
  std::map<std::string, NumberArray> numbers;
  std::map<std::string, std::vector<std::string>> texts;
  std::map<AttributeName, double> number_attributes;
  std::map<AttributeName, std::string> text_attributes;
};

/// Reads the file with HDF5: groups down to the eighth, links followed, at most 10,000 objects. Throws InputError where
/// it is none; `what` as in Hdf5Reader.
Hdf5Contents read_contents(const std::string& path, const std::string& what);

/// Whether there are as many values as the shape says: of a null dataspace, and of sizes beyond all numbers, not.
bool has_its_shape(const NumberArray& array);

void put(Parcel& parcel, const Hdf5Contents& contents);
Hdf5Contents take_contents(OpenParcel& parcel);

/// The checksum over all of it but the attribute `checksum` of the root. CRC-32 (zlib, as in gzip): it is to find
/// accidents and hasty changes; whoever wants to deceive can make a new one, and against that stand the checks of
/// sizes, signs and finite numbers.
class Hdf5Checksum {
 public:
  void add(const std::string& path, const std::vector<std::size_t>& shape, const double* values);
  void add(const std::string& path, const std::vector<std::string>& texts);
  void add(const AttributeName& name, double number);
  void add(const AttributeName& name, const std::string& text);
  /// As text; the order in which things were added does not matter.
  std::string value() const;

 private:
  void note(const std::string& key, std::uint32_t sum) { sums_[key] = sum; }
  std::map<std::string, std::uint32_t> sums_;
};

inline const char* const checksum_name = "checksum";

std::string checksum_of(const Hdf5Contents& contents);

}  // namespace upbead::detail
