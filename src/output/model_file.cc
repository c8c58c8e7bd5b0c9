#include "upbead/output/model_file.h"

#include "hdf5_image.h"
#include "model_layout.h"
#include "model_pieces.h"
#include "model_slip.h"

namespace upbead {

namespace {

using detail::Hdf5Image;
using detail::write_matrix;

/// Real and imaginary parts along one more axis, the last. std::complex lies in memory as such a pair.
void write(Hdf5Image& image, const std::string& path, const Eigen::MatrixXcd& values, std::vector<hsize_t> shape,
           const detail::Label& label) {
  const Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = values;
  shape.push_back(2);
  image.numbers(path, shape, reinterpret_cast<const double*>(rows.data()), label);
}

void write_modes(Hdf5Image& image, const ModalModel& modes) {
  const hsize_t m = modes.n_modes(), k = modes.n_loads(), i = modes.n_readings();
  write(image, "/modes/pole", modes.pole, {m}, {"1/s", "pole_m of z_m' = pole_m z_m + sum_k load_mk f_k, Re and Im"});
  write(image, "/modes/load", modes.load, {m, k}, {"", "load_mk, Re and Im"});
  write(image, "/modes/reading", modes.reading, {i, m},
        {"", "reading_im of y_i = Re sum_m reading_im z_m + sum_k (feedthrough_ik f_k + impulse_ik int f_k dt)"});
  write_matrix(image, "/modes/feedthrough", modes.feedthrough,
               {"unit of the reading / unit of the load", "feedthrough_ik"});
  write_matrix(image, "/modes/impulse", modes.impulse, {"unit of the reading / (unit of the load s)", "impulse_ik"});
}

void write_loads(Hdf5Image& image, const std::vector<ModelLoad>& loads) {
  std::vector<std::string> name, unit;
  std::vector<double> peak, duration;
  for (const ModelLoad& load : loads) {
    name.push_back(load.name);
    unit.push_back(load.unit);
    peak.push_back(load.peak);
    duration.push_back(load.duration);
  }
  image.group("/loads");
  image.texts("/loads/name", name);
  image.texts("/loads/unit", unit);
  image.numbers("/loads/peak", {peak.size()}, peak.data(), {"that of the load", "largest |f_k| of the case"});
  image.numbers("/loads/duration", {duration.size()}, duration.data(),
                {"s", "shortest time in which the load rises and falls in the case"});
}

void write_validity(Hdf5Image& image, const ReducedModelFile& model) {
  image.group("/validity");
  image.attribute("/validity", "highest_frequency", model.highest_frequency);
  image.attribute("/validity", "tolerance", model.tolerance);
  image.attribute("/validity", "error", model.error);
  image.attribute("/validity", "error_peak", model.error_peak);
  if (model.error_march) image.attribute("/validity", "error_march", *model.error_march);
}

void write_origin(Hdf5Image& image, const ReducedModelFile& model) {
  image.text("/case", model.case_text);
  image.attribute("/case", "caisson_mass", model.caisson_mass);
  image.attribute("/case", "end", model.end);
  image.attribute("/case", "unknowns", model.unknowns);
  image.attribute("/case", "solves", model.solves);
  image.attribute("/case", "factorisations", model.factorisations);
}

void write_sliding(Hdf5Image& image, const ModelSliding& sliding) {
  image.group("/sliding");
  image.attribute("/sliding", "friction", sliding.friction);
  image.attribute("/sliding", "buoyant_weight", sliding.buoyant_weight);
  image.attribute("/sliding", "drag", sliding.drag);
  image.attribute("/sliding", "uplift", sliding.uplift);
  image.attribute("/sliding", "uplift_per_force", sliding.uplift_per_force);
  image.attribute("/sliding", "lag", sliding.lag);
}

}  // namespace

std::string model_file(const ReducedModelFile& model) {
  Hdf5Image image(model.title);
  image.attribute("/", "kind", std::string(detail::model_layout::kind));
  image.attribute("/", "format_version", detail::model_layout::version);
  write_origin(image, model);
  write_loads(image, model.loads);
  detail::write_labels(image, "/readings", model.modes.reading_label);
  write_modes(image, model.modes);
  write_validity(image, model);
  if (model.sliding) write_sliding(image, *model.sliding);
  if (model.slip) detail::write_slip(image, *model.slip);
  return image.bytes();
}

}  // namespace upbead
