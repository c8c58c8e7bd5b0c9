// Parts of the file of a reduced model: datasets and attributes, each checked as it is read.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "hdf5_image.h"
#include "output/hdf5_reader.h"
#include "upbead/output/model_file.h"

namespace upbead::detail {

inline const char* const model_kind = "upbead reduced model";
constexpr int model_version = 1;  ///< of the layout; raise it when a reader of the old one would misread the new one

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

/// Row by row.
void write_matrix(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& values, const Label& label);

/// Names, units and descriptions of readings, in a group of their own.
void write_labels(Hdf5Image& image, const std::string& group, const std::vector<ReadingLabel>& labels);
/// The same from a file; what is wrong is noted.
std::vector<ReadingLabel> read_labels(ModelParts& parts, const std::string& group);

/// Fields are a function that shows name and value of each attribute to a visitor, the same for the writer and the
/// reader.
constexpr bool positive = true;  ///< said behind a number that must not be 0

template <class Fields, class T>
void write_attributes(Hdf5Image& image, const std::string& group, const Fields& fields, const T& of) {
  fields(of, [&](const char* name, const auto& value, bool = false) { image.attribute(group, name, value); });
}

template <class Fields, class T>
void read_attributes(ModelParts& parts, const std::string& group, const Fields& fields, T& of) {
  fields(of, [&](const char* name, auto& value, bool is_positive = false) {
    using V = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<V, double>)
      value = parts.number(group, name, is_positive);
    else if constexpr (std::is_same_v<V, int>)
      value = parts.count(group, name);
    else
      value = parts.text(group, name);
  });
}

/// The part of a reduced model's file that lets the caisson slip: the group /slip.
void write_slip(Hdf5Image& image, const ModelSlip& slip);

/// None where the file has no such group; what is wrong with it is noted.
std::optional<ModelSlip> read_slip(ModelParts& parts);

}  // namespace upbead::detail
