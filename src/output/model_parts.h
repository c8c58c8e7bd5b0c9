// Datasets and attributes of the file of a reduced model, each checked as it is read.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "output/hdf5_reader.h"
#include "upbead/base/error.h"

namespace upbead::detail {

/// Reads parts of a model and collects what is wrong with them; a wrong part comes back as zeros or empty texts.
class ModelParts {
 public:
  using Shape = std::vector<std::size_t>;

  /// Throws InputError where the file cannot be read, is no reduced model, or one of another format.
  explicit ModelParts(const std::string& path);

  /// An attribute.
  std::string text(const std::string& object, const std::string& name);
  /// An attribute that is finite and not below zero, nor zero where it must be positive.
  double number(const std::string& object, const std::string& name, bool positive = false);
  /// The same, which may be absent.
  std::optional<double> optional_number(const std::string& object, const std::string& name);
  bool has(const std::string& object, const std::string& name) const;
  int count(const std::string& object, const std::string& name);

  /// A dataset of texts, of that size where one is given.
  std::vector<std::string> texts(const std::string& path, std::optional<std::size_t> size = {});
  /// A dataset of finite numbers of that shape, row by row.
  std::vector<double> numbers(const std::string& path, const Shape& shape);
  Eigen::MatrixXd matrix(const std::string& path, std::size_t rows, std::size_t columns);
  /// A matrix or a column, its real and imaginary parts along one more axis.
  Eigen::MatrixXcd complex_matrix(const std::string& path, Shape shape);
  /// The length of a dataset's first axis; 0 where it has none.
  std::size_t length(const std::string& path) const;

  /// Notes it where the parts are sound by themselves, but not what was written. A file without a checksum, as older
  /// versions wrote them, is taken as it is.
  void require_checksum();
  /// Notes a mistake.
  void wrong(const std::string& what);
  void throw_if_any() const { mistakes_.throw_if_any(); }

 private:
  std::string path_;
  Hdf5Reader file_;
  Diagnostics mistakes_;
};

}  // namespace upbead::detail
