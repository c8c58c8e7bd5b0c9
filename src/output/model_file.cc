#include "upbead/output/model_file.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "base/text.h"
#include "fem/caisson/reading_names.h"
#include "model_parts.h"

namespace upbead {

namespace detail {

namespace {

/// Writes real and imaginary parts along another axis, the last one. std::complex is such a pair in memory.
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

}  // namespace detail

namespace {

using namespace detail;

const std::string nested_group = "/nested";

const auto fields_of_nested = [](auto& nested, const auto& visit) {
  visit("solves", nested.solves);
  visit("factorisations", nested.factorisations);
};

const auto fields_of_validity = [](auto& model, const auto& visit) {
  visit("highest_frequency", model.highest_frequency, positive);
  visit("tolerance", model.tolerance);
  visit("error", model.error);
  visit("error_peak", model.error_peak);
};

const auto fields_of_case = [](auto& model, const auto& visit) {
  visit("caisson_mass", model.caisson_mass);
  visit("end", model.end);
  visit("unknowns", model.unknowns);
  visit("solves", model.solves);
  visit("factorisations", model.factorisations);
};

const auto fields_of_sliding = [](auto& sliding, const auto& visit) {
  visit("friction", sliding.friction, positive);
  visit("buoyant_weight", sliding.submerged_weight, positive);
  visit("drag", sliding.drag);
  visit("uplift", sliding.uplift);
  visit("uplift_per_force", sliding.uplift_per_force);
  visit("lag", sliding.lag);
};

const char* const still_group = "/still_water";

const auto fields_of_still = [](auto& still, const auto& visit) {
  visit("push", still.push);
  visit("push_moment", still.push_moment);
  visit("weight", still.weight);
};

/// Gives its part to what rests on the base.
void add_still_water(ReducedModelFile& model) {
  if (!model.still) return;
  if (model.sliding) model.sliding->push = model.still->push;
  if (!model.base) return;
  model.base->push = model.still->push;
  model.base->push_moment = model.still->push_moment;
}

void write_nested(Hdf5Image& image, const NestedModels& nested) {
  image.group(nested_group);
  write_modes(image, nested_group + "/middle", nested.middle);
  write_modes(image, nested_group + "/reference", nested.reference);
  write_attributes(image, nested_group, fields_of_nested, nested);
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
  read_attributes(parts, nested_group, fields_of_nested, nested);
  return nested;
}

const char* const base_path = "/base";

void write_base(Hdf5Image& image, const ModelBase& base) {
  const std::vector<double> values{base.width, base.weight, base.weight_moment, base.uplift_moment_per_force};
  image.numbers(base_path, {values.size()}, values.data(),
                {"",
                 "width of the base (m), W' (N/m), its moment about the middle, overturning landward positive (N m/m), "
                 "moment per force of a prescribed uplift (m)"});
}

std::optional<ModelBase> read_base(ModelParts& parts) {
  if (parts.length(base_path) == 0) return std::nullopt;
  const std::vector<double> values = parts.numbers(base_path, {4});
  if (values[0] > 0. && values[1] > 0.) return ModelBase{values[0], values[1], values[2], values[3]};
  parts.wrong(std::string(base_path) + " holds a width or a weight that is not above 0");
  return std::nullopt;
}

const char* const path_of_moments = "/loads/moment";

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
  if (std::any_of(loads.begin(), loads.end(), [](const ModelLoad& load) { return !load.moment; })) return;
  std::vector<double> moment;
  for (const ModelLoad& load : loads) moment.push_back(*load.moment);
  image.numbers(path_of_moments, {moment.size()}, moment.data(),
                {"that of the load times m",
                 "moment of one unit on the caisson about its bottom's middle, overturning landward positive"});
}

void read_loads(ModelParts& parts, ReducedModelFile& model) {
  const std::vector<std::string> names = parts.texts("/loads/name");
  const std::size_t k = names.size();
  if (k == 0) parts.wrong("/loads/name names no load");
  const std::vector<std::string> units = parts.texts("/loads/unit", k);
  const std::vector<double> peaks = parts.numbers("/loads/peak", {k}),
                            durations = parts.numbers("/loads/duration", {k});
  for (const auto& [path, values] : {std::pair("/loads/peak", &peaks), std::pair("/loads/duration", &durations)})
    for (const double value : *values)
      if (value < 0.) parts.wrong(std::string(path) + " holds " + significant(value));
  for (std::size_t n = 0; n < k; ++n) model.loads.push_back({names[n], units[n], peaks[n], durations[n]});
  if (parts.length(path_of_moments) > 0) {
    const std::vector<double> moments = parts.numbers(path_of_moments, {k});
    for (std::size_t n = 0; n < k; ++n) model.loads[n].moment = moments[n];
  }
  model.modes.load_name = names;
}

const char* const warnings_group = "/warnings";

void write_warnings(Hdf5Image& image, const NumberedWarnings& warnings) {
  std::vector<std::string> name, unit, what, cure;
  Eigen::MatrixXd number(warnings.size(), 3);
  const auto finite = [](double value) { return std::isfinite(value) ? value : 0.; };
  for (const NumberedWarning& warning : warnings) {
    const auto row = static_cast<Eigen::Index>(name.size());
    number.row(row) << finite(warning.value), finite(warning.limit), warning.voids ? 1. : 0.;
    name.push_back(warning.name);
    unit.push_back(warning.unit);
    what.push_back(warning.what);
    cure.push_back(warning.cure);
  }
  image.group(warnings_group);
  const std::string at = warnings_group + std::string("/");
  image.texts(at + "name", name);
  image.texts(at + "unit", unit);
  image.texts(at + "what", what);
  image.texts(at + "cure", cure);
  write_matrix(image, at + "number", number,
               {"", "by warning: the number that decided, the limit that it passes, 1 where no verdict may be drawn"});
}

NumberedWarnings read_warnings(ModelParts& parts) {
  const std::string at = warnings_group + std::string("/");
  const std::size_t n = parts.length(at + "number");
  if (n == 0) return {};
  const std::vector<std::string> name = parts.texts(at + "name", n), unit = parts.texts(at + "unit", n),
                                 what = parts.texts(at + "what", n), cure = parts.texts(at + "cure", n);
  const Eigen::MatrixXd number = parts.matrix(at + "number", n, 3);
  NumberedWarnings list;
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    list.push_back({name[i], number(row, 0), number(row, 1), unit[i], what[i], cure[i], number(row, 2) > 0.});
  }
  return list;
}

}  // namespace

void detail::write_model(Hdf5Image& image, const ReducedModelFile& model) {
  image.text("/case", model.case_text);
  write_attributes(image, "/case", fields_of_case, model);
  write_loads(image, model.loads);
  write_labels(image, "/readings", model.modes.reading_label);
  write_modes(image, "/modes", model.modes);
  image.group("/validity");
  write_attributes(image, "/validity", fields_of_validity, model);
  if (model.error_march) image.attribute("/validity", "error_march", *model.error_march);
  if (model.nested) write_nested(image, *model.nested);
  if (model.sliding) {
    image.group("/sliding");
    write_attributes(image, "/sliding", fields_of_sliding, *model.sliding);
  }
  if (model.still) {
    image.group(still_group);
    write_attributes(image, still_group, fields_of_still, *model.still);
  }
  if (model.base) write_base(image, *model.base);
  if (model.slip) write_slip(image, *model.slip);
  if (model.circles) write_circles(image, *model.circles);
  if (model.contact) write_contact(image, *model.contact);
  if (!model.warnings.empty()) write_warnings(image, model.warnings);
}

std::string model_file(const ReducedModelFile& model) {
  Hdf5Image image(model.title);
  image.attribute("/", "kind", std::string(reduced_model_kind.kind));
  image.attribute("/", "format_version", model.still ? two_levels_version : model_version);
  write_model(image, model);
  image.seal();
  return image.bytes();
}

ReducedModelFile detail::read_model(ModelParts& parts) {
  ReducedModelFile model;
  model.title = parts.text("/", "title");
  model.case_text = parts.texts("/case", 1).front();
  read_attributes(parts, "/case", fields_of_case, model);
  read_loads(parts, model);
  model.modes.reading_label = read_labels(parts, "/readings");
  read_modes(parts, "/modes", model.modes);
  model.nested = read_nested(parts, model.modes);
  read_attributes(parts, "/validity", fields_of_validity, model);
  model.error_march = parts.optional_number("/validity", "error_march");
  if (parts.has("/sliding", "friction")) read_attributes(parts, "/sliding", fields_of_sliding, model.sliding.emplace());
  model.base = read_base(parts);
  if (parts.has(still_group, "push")) read_attributes(parts, still_group, fields_of_still, model.still.emplace());
  add_still_water(model);
  model.slip = read_slip(parts);
  model.circles = read_circles(parts, model.modes.load_name);
  model.contact = read_contact(parts, model.modes.load_name);
  model.warnings = read_warnings(parts);
  return model;
}

ReducedModelFile read_model_file(const std::string& path) {
  ModelParts parts(path, {reduced_model_kind});
  ReducedModelFile model = read_model(parts);
  parts.require_checksum();
  parts.throw_if_any();
  return model;
}

}  // namespace upbead
