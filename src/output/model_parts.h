// Parts of the file of a reduced model: datasets and attributes, each checked when it is read.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "hdf5_image.h"
#include "output/hdf5_reader.h"
#include "upbead/output/model_file.h"

namespace upbead::detail {

/// A kind of file that holds a model.
struct ModelKind {
  const char* kind;     ///< the attribute of the root
  int oldest;           ///< format of the layout
  int newest;           ///< raise it when a reader of the old layout would misread the new one
  const char* name;     ///< in messages
  const char* command;  ///< that makes it
};
constexpr int model_version = 1;
constexpr int two_levels_version = 2;  ///< of files with /still_water, without which S and margins are too good
inline constexpr ModelKind reduced_model_kind{"upbead reduced model", model_version, two_levels_version,
                                              "reduced model", "upbead reduce"};
inline constexpr ModelKind soil_model_kind{"upbead soil model", 1, 1, "model of soils", "upbead reduce --soils"};
inline constexpr ModelKind soil_family_kind{"upbead family of soils", 1, 1, "family of soils", "upbead study"};

/// Reads parts of a model and collects their mistakes; a wrong part is returned as zeros or empty texts.
class ModelParts {
 public:
  using Shape = std::vector<std::size_t>;

  /// Throws InputError where the file cannot be read, is of none of these kinds, or has another format.
  ModelParts(const std::string& path, const std::vector<ModelKind>& kinds);
  /// That of the file.
  const ModelKind& kind() const { return kind_; }

  /// An attribute.
  std::string text(const std::string& object, const std::string& name);
  /// An attribute that is finite and not negative, and above zero where it must be positive.
  double number(const std::string& object, const std::string& name, bool positive = false);
  /// The same for an attribute that may be absent.
  std::optional<double> optional_number(const std::string& object, const std::string& name);
  bool has(const std::string& object, const std::string& name) const;
  int count(const std::string& object, const std::string& name);

  /// A dataset of texts, with that size where one is given.
  std::vector<std::string> texts(const std::string& path, std::optional<std::size_t> size = {});
  /// A dataset of finite numbers of that shape, row by row.
  std::vector<double> numbers(const std::string& path, const Shape& shape);
  Eigen::MatrixXd matrix(const std::string& path, std::size_t rows, std::size_t columns);
  /// A matrix or a column, with real and imaginary parts along another axis.
  Eigen::MatrixXcd complex_matrix(const std::string& path, Shape shape);
  /// The length of a dataset's first axis; 0 where it has none.
  std::size_t length(const std::string& path) const;
  /// Of its second axis.
  std::size_t width(const std::string& path) const;
  bool has_dataset(const std::string& path) const { return file_.numbers(path).has_value(); }

  /// Notes a mistake where all parts are valid but the checksum shows that the file was changed. A file without a
  /// checksum, from an older version, is accepted.
  void require_checksum();
  /// Notes a mistake.
  void wrong(const std::string& what);
  bool is_sound() const { return mistakes_.empty(); }
  void throw_if_any() const { mistakes_.throw_if_any(); }

 private:
  std::string path_;
  Hdf5Reader file_;
  ModelKind kind_;
  Diagnostics mistakes_;
};

/// Writes a matrix row by row.
void write_matrix(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& values, const Label& label);

/// The same, compressed.
void write_packed(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& values, const Label& label);

/// Writes names, units and descriptions of readings, in a group of their own.
void write_labels(Hdf5Image& image, const std::string& group, const std::vector<ReadingLabel>& labels);
/// Reads the same from a file, and notes mistakes.
std::vector<ReadingLabel> read_labels(ModelParts& parts, const std::string& group);

/// Integers from `least` up to, but not including, `end`; notes others.
std::vector<int> read_indices(ModelParts& parts, const std::string& path, std::size_t size, int least, int end);
/// Each of the first coordinates must be prescribed by one load, and no other coordinate by any load.
void require_prescribed(ModelParts& parts, const std::string& group, const ReducedSystem& system);

/// Fields are a function that passes name and value of each attribute to a visitor, the same for the writer and the
/// reader.
constexpr bool positive = true;  ///< follows a number that must not be 0

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

/// Writes the modes of a model, in a group that exists.
void write_modes(Hdf5Image& image, const std::string& group, const ModalModel& modes);
/// Reads the same for the loads and readings that `modes` names, and notes mistakes.
void read_modes(ModelParts& parts, const std::string& group, ModalModel& modes);

/// Writes the part of a reduced model's file with its slip circles: the group /circles.
void write_circles(Hdf5Image& image, const CircleModel& circles);
/// Reads that group, and notes mistakes; none where the file has no such group. `loads`: of the model.
std::optional<CircleModel> read_circles(ModelParts& parts, const std::vector<std::string>& loads);

/// Writes the part of a reduced model's file for a caisson that slips: the group /slip.
void write_slip(Hdf5Image& image, const ModelSlip& slip);

/// Reads that group, and notes mistakes; none where the file has no such group.
std::optional<ModelSlip> read_slip(ModelParts& parts);

/// Writes the part of a reduced model's file for contact node by node: the group /contact.
void write_contact(Hdf5Image& image, const GroundModel& model);
/// Reads that group, and notes mistakes; null where the file has no such group. `loads`: of the model.
std::shared_ptr<const GroundModel> read_contact(ModelParts& parts, const std::vector<std::string>& loads);

/// Writes all of a reduced model but the kind of the file.
void write_model(Hdf5Image& image, const ReducedModelFile& model);
/// Reads the same, and notes mistakes.
ReducedModelFile read_model(ModelParts& parts);

}  // namespace upbead::detail
