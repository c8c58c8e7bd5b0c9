#include "model_modes.h"

#include <algorithm>
#include <complex>

#include "base/text.h"
#include "fem/reading_names.h"
#include "model_pieces.h"

namespace upbead::detail {

namespace {

const std::string nested_group = "/nested";

/// Real and imaginary parts along one more axis, the last. std::complex lies in memory as such a pair.
void write(Hdf5Image& image, const std::string& path, const Eigen::MatrixXcd& values, std::vector<hsize_t> shape,
           const Label& label) {
  const Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = values;
  shape.push_back(2);
  image.numbers(path, shape, reinterpret_cast<const double*>(rows.data()), label);
}

}  // namespace

void write_modes(Hdf5Image& image, const std::string& group, const ModalModel& modes) {
  const hsize_t m = modes.n_modes(), k = modes.n_loads(), i = modes.n_readings();
  write(image, group + "/pole", modes.pole, {m}, {"1/s", "pole_m of z_m' = pole_m z_m + sum_k load_mk f_k, Re and Im"});
  write(image, group + "/load", modes.load, {m, k}, {"", "load_mk, Re and Im"});
  write(image, group + "/reading", modes.reading, {i, m},
        {"", "reading_im of y_i = Re sum_m reading_im z_m + sum_k (feedthrough_ik f_k + impulse_ik int f_k dt)"});
  write_matrix(image, group + "/feedthrough", modes.feedthrough,
               {"unit of the reading / unit of the load", "feedthrough_ik"});
  write_matrix(image, group + "/impulse", modes.impulse, {"unit of the reading / (unit of the load s)", "impulse_ik"});
}

void read_modes(ModelParts& parts, const std::string& group, ModalModel& modes) {
  const std::size_t m = parts.length(group + "/pole"), k = modes.load_name.size(), i = modes.reading_label.size();
  modes.pole = parts.complex_matrix(group + "/pole", {m});
  modes.load = parts.complex_matrix(group + "/load", {m, k});
  modes.reading = parts.complex_matrix(group + "/reading", {i, m});
  modes.feedthrough = parts.matrix(group + "/feedthrough", i, k);
  modes.impulse = parts.matrix(group + "/impulse", i, k);
  for (int n = 0; n < modes.n_modes(); ++n)
    if (modes.pole[n].real() > 0.)
      parts.wrong((group == "/modes" ? "" : group + ": ") + "mode " + std::to_string(n) + " grows: Re of its pole is " +
                  significant(modes.pole[n].real()) + " 1/s, and must not be above 0");
}

void write_nested(Hdf5Image& image, const NestedModels& nested) {
  image.group(nested_group);
  write_modes(image, nested_group + "/middle", nested.middle);
  write_modes(image, nested_group + "/reference", nested.reference);
  image.attribute(nested_group, "solves", nested.solves);
  image.attribute(nested_group, "factorisations", nested.factorisations);
}

std::optional<NestedModels> read_nested(ModelParts& parts, const ModalModel& modes) {
  if (!parts.has(nested_group, "solves")) return std::nullopt;
  const auto shear = std::find_if(modes.reading_label.begin(), modes.reading_label.end(),
                                  [](const ReadingLabel& label) { return label.name == reading::shear_force; });
  if (shear == modes.reading_label.end()) {
    parts.wrong(nested_group + " is there, but no reading '" + reading::shear_force + "' that it belongs to");
    return std::nullopt;
  }
  NestedModels nested;
  for (ModalModel* larger : {&nested.middle, &nested.reference}) {
    larger->load_name = modes.load_name;
    larger->reading_label = {*shear};
  }
  read_modes(parts, nested_group + "/middle", nested.middle);
  read_modes(parts, nested_group + "/reference", nested.reference);
  nested.solves = parts.count(nested_group, "solves");
  nested.factorisations = parts.count(nested_group, "factorisations");
  return nested;
}

}  // namespace upbead::detail
