// Contact node by node in the file of a reduced model: the group /contact.
#include <algorithm>

#include "dynamics/ground_model.h"
#include "model_parts.h"

namespace upbead::detail {

namespace {

const std::string contact_group = "/contact";

const auto fields_of_contact = [](auto& contact, const auto& visit) {
  visit("friction", contact.interface.friction, positive);
  visit("shift", contact.shift, positive);
  visit("margin", contact.margin);
  visit("tolerance", contact.tolerance, positive);
  visit("step", contact.step);
};

/// Shows a visitor each matrix of a level with its numbers of rows and columns, for r free coordinates, m motions of
/// the interface, along k directions, and as many loads.
template <class Level, class Visit>
void matrices_of(Level& level, std::size_t r, std::size_t m, std::size_t k, std::size_t loads, const Visit& visit) {
  const char *free = "of r free coordinates", *coupled = "A of the coupling A U' with the interface",
             *reads = "of F_T, x_G, the rotation and the force of the water";
  const std::size_t n = GroundModel::readings.size();
  visit("M", level.M, r, r, free);
  visit("C", level.C, r, r, free);
  visit("K", level.K, r, std::size_t{1}, "the diagonal of K of the free coordinates");
  visit("U", level.U, m, k, "directions of the interface that couple with the ground");
  visit("M_f", level.M_f, r, k, coupled);
  visit("C_f", level.C_f, r, k, coupled);
  visit("K_f", level.K_f, r, k, coupled);
  visit("load", level.load, r + m, loads, "of M q'' + C q' + K q = sum_k load_k f_k");
  visit("position", level.position, n, r + m, reads);
  visit("velocity", level.velocity, n, r + m, reads);
  visit("acceleration", level.acceleration, n, r + m, reads);
  visit("feedthrough", level.feedthrough, n, loads, reads);
}

void write_level(Hdf5Image& image, const std::string& at, const GroundLevel& level, std::size_t n_loads) {
  image.group(at);
  image.attribute(at, "solves", level.solves);
  const std::vector<double> is_phi(level.is_phi.begin(), level.is_phi.end());
  image.numbers(at + "/is_phi", {is_phi.size()}, is_phi.data(),
                {"1", "1: a coordinate of the integrated pore pressure; 0: of displacements"});
  const auto write = [&](const char* name, const Eigen::MatrixXd& values, std::size_t, std::size_t, const char* what) {
    write_matrix(image, at + "/" + name, values, {"", what});
  };
  const auto size = [](Eigen::Index n) { return static_cast<std::size_t>(n); };
  matrices_of(level, size(level.n_free()), size(level.U.rows()), size(level.U.cols()), n_loads, write);
}

GroundLevel read_level(ModelParts& parts, const std::string& at, std::size_t m, std::size_t n_loads) {
  GroundLevel level;
  level.solves = parts.count(at, "solves");
  const std::size_t r = parts.length(at + "/K"), k = parts.width(at + "/U");
  for (const int phi : read_indices(parts, at + "/is_phi", r, 0, 2)) level.is_phi.push_back(phi == 1);
  matrices_of(level, r, m, k, n_loads,
              [&](const char* name, Eigen::MatrixXd& to, std::size_t rows, std::size_t columns, const char*) {
                to = parts.matrix(at + "/" + name, rows, columns);
              });
  return level;
}

std::string level_group(std::size_t number) {
  return contact_group + "/level_" + std::to_string(number);
}

}  // namespace

void write_contact(Hdf5Image& image, const GroundModel& model) {
  image.group(contact_group);
  write_attributes(image, contact_group, fields_of_contact, model);
  image.attribute(contact_group, "levels", static_cast<int>(model.levels.size()));
  const auto list = [&](const char* name, const auto& values, const Label& label) {
    image.numbers(contact_group + "/" + name, {static_cast<hsize_t>(values.size())}, values.data(), label);
  };
  list("position", model.interface.position, {"m", "of each node along the contact"});
  list("length", model.interface.length, {"m", "of the contact at each node"});
  list("normal_force", model.interface.normal_force, {"N/m", "N of each node at rest"});
  const Label of_interface{"", "of slip of all nodes, then of their opening"};
  write_matrix(image, contact_group + "/M", model.of_interface.M, of_interface);
  write_matrix(image, contact_group + "/C", model.of_interface.C, of_interface);
  write_matrix(image, contact_group + "/K", model.of_interface.K, of_interface);
  write_matrix(image, contact_group + "/uplift", model.uplift,
               {"1", "force of each node per N/m of a prescribed uplift, under landward and under seaward waves"});
  write_matrix(image, contact_group + "/on_caisson", model.on_caisson,
               {"", "by load: force per unit, and its height above the centre of gravity (m)"});
  image.group(contact_group + "/demand");
  write_modes(image, contact_group + "/demand", model.demand);
  for (std::size_t i = 0; i < model.levels.size(); ++i)
    write_level(image, level_group(i), model.levels[i], model.demand.load_name.size());
}

std::shared_ptr<const GroundModel> read_contact(ModelParts& parts, const std::vector<std::string>& loads) {
  if (!parts.has(contact_group, "friction")) return nullptr;
  auto model = std::make_shared<GroundModel>();
  read_attributes(parts, contact_group, fields_of_contact, *model);
  Interface& interface = model->interface;
  const std::size_t n = parts.length(contact_group + "/position"), m = 2 * n;
  if (n == 0) parts.wrong(contact_group + "/position names no node");
  interface.position = parts.numbers(contact_group + "/position", {n});
  interface.length = parts.numbers(contact_group + "/length", {n});
  const std::vector<double> at_rest = parts.numbers(contact_group + "/normal_force", {n});
  interface.normal_force = Eigen::Map<const Vector>(at_rest.data(), static_cast<Eigen::Index>(n));
  if (n > 0 && !(interface.normal_force.minCoeff() > 0.))
    parts.wrong(contact_group + "/normal_force holds a force that is not above 0");
  model->of_interface = {parts.matrix(contact_group + "/M", m, m), parts.matrix(contact_group + "/C", m, m),
                         parts.matrix(contact_group + "/K", m, m)};
  model->uplift = parts.matrix(contact_group + "/uplift", n, 2);
  model->on_caisson = parts.matrix(contact_group + "/on_caisson", loads.size(), 2);
  model->demand.load_name = loads;
  model->demand.reading_label.resize(m);
  read_modes(parts, contact_group + "/demand", model->demand);
  constexpr int most_levels = 10;
  const int levels = parts.count(contact_group, "levels");
  if (levels < 2 || levels > most_levels) parts.wrong(contact_group + " has " + std::to_string(levels) + " levels");
  for (int i = 0; i < std::min(levels, most_levels); ++i)
    model->levels.push_back(read_level(parts, level_group(static_cast<std::size_t>(i)), m, loads.size()));
  return model;
}

}  // namespace upbead::detail
