// Reading HDF5 files that people or other programs have made: whatever may be missing or of another kind.
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

/// What a file says, read as a whole by HDF5 in a confined process (see base/confined_work.h): HDF5 1.10 breaks down on
/// many a damaged file. Paths are as "/modes/pole". What is not there, is of another kind or cannot be read is not
/// returned; what that means is for the caller to say.
class Hdf5Reader {
 public:
  /// `what`: what the file should be, for the cure, such as "a model made by 'upbead reduce'". Throws InputError where
  /// the file cannot be read, is no HDF5 file, or is so damaged that HDF5 breaks down.
  Hdf5Reader(const std::string& path, const std::string& what);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  /// Everything directly below the root, sorted.
  const std::vector<std::string>& names() const;
  /// Integers and floating-point numbers of any length.
  std::optional<NumberArray> numbers(const std::string& path) const;
  /// Texts of fixed or variable length; of a single text a list of one.
  std::optional<std::vector<std::string>> texts(const std::string& path) const;
  std::optional<double> number_attribute(const std::string& object, const std::string& name) const;
  std::optional<std::string> text_attribute(const std::string& object, const std::string& name) const;
  /// Whether the file is as it was sealed, see detail::Hdf5Image; none where it has no checksum.
  std::optional<bool> checksum_holds() const;

 private:
  std::unique_ptr<const detail::Hdf5Contents> contents_;
};

}  // namespace upbead
