// HDF5 files made in memory: the common part of all files of numbers that the program writes.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "hdf5_contents.h"

namespace upbead::detail {

/// The attributes of a dataset that people read.
struct Label {
  std::string unit;
  std::string description;
};

/// A file in memory. HDF5 1.10 crashes where the disk is full when it closes a file; a program that writes these
/// bytes itself does not. Equal contents make equal bytes. Datasets are at paths such as "/modes/pole"; the groups in
/// these paths are made.
class Hdf5Image {
 public:
  /// With the root attributes `title` and `program`.
  explicit Hdf5Image(const std::string& title);

  /// An attribute of the root "/", or of a group or dataset that has been made.
  void attribute(const std::string& object, const std::string& name, const std::string& text);
  /// Throws NumericsError where the number is not finite.
  void attribute(const std::string& object, const std::string& name, double number);
  void attribute(const std::string& object, const std::string& name, int number);

  void group(const std::string& path);
  /// Numbers row by row, with the attributes `unit` and `description`. Throws NumericsError where one is not finite.
  void numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values, const Label& label);
  /// The same, compressed (deflate). Numbers that stand at another path already, with the same label, take no more
  /// room.
  void packed_numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values,
                      const Label& label);
  /// A list in which NaN stands for a missing number. Throws NumericsError where a number is infinite.
  void numbers_or_none(const std::string& path, const std::vector<double>& values, const Label& label);
  /// A list of texts (UTF-8).
  void texts(const std::string& path, const std::vector<std::string>& values);
  /// One text (UTF-8).
  void text(const std::string& path, const std::string& value);

  /// Writes the checksum of all that has been written so far: the last call before bytes().
  void seal();

  /// The file as it would be on a disk.
  std::string bytes() const;

 private:
  void write_numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values,
                     const Label& label);
  void write_numbers(const std::string& path, const std::vector<hsize_t>& shape, const double* values,
                     const Label& label, hid_t creation);
  Handle access_, file_, links_, creation_;
  Hdf5Checksum checksum_;
  /// Path by shape, values, unit and description.
  std::map<std::tuple<std::vector<hsize_t>, std::vector<double>, std::string, std::string>, std::string> packed_;
};

}  // namespace upbead::detail
