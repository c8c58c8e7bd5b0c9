// Reading of HDF5 files made by people or other programs: any part may be missing or of another kind.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace upbead {

namespace detail {
struct Hdf5Contents;
}

/// Numbers of a dataset, row by row.
struct NumberArray {
  std::vector<std::size_t> shape;  ///< empty for a single number
  std::vector<double> values;
};

/// The contents of a file, read as a whole by HDF5 in a confined process (see base/confined_work.h): HDF5 1.10
/// crashes on many damaged files. Paths are written as "/modes/pole". Parts that are missing, of another kind or
/// unreadable are not returned; the caller decides what that means.
class Hdf5Reader {
 public:
  /// `what`: what the file should be, for the advice in messages, such as "a model made by 'upbead reduce'". Throws
  /// InputError where the file cannot be read, is no HDF5 file, or is so damaged that HDF5 crashes.
  Hdf5Reader(const std::string& path, const std::string& what);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  /// Everything directly below the root, sorted.
  const std::vector<std::string>& names() const;
  /// Integers and floating-point numbers of any length.
  std::optional<NumberArray> numbers(const std::string& path) const;
  /// Texts of fixed or variable length; a single text gives a list of one.
  std::optional<std::vector<std::string>> texts(const std::string& path) const;
  std::optional<double> number_attribute(const std::string& object, const std::string& name) const;
  std::optional<std::string> text_attribute(const std::string& object, const std::string& name) const;
  /// Whether the file is unchanged since it was sealed, see detail::Hdf5Image; none where it has no checksum.
  std::optional<bool> checksum_holds() const;

 private:
  std::unique_ptr<const detail::Hdf5Contents> contents_;
};

}  // namespace upbead
