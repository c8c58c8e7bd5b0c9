#include "family_parts.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "fem/caisson/reading_names.h"

namespace upbead::detail {

namespace {

/// By Coefficient.
constexpr std::array<const char*, n_coefficients> coefficient_words{"G",
                                                                    "lambda",
                                                                    "rho",
                                                                    "a",
                                                                    "b",
                                                                    "mobility",
                                                                    "alpha",
                                                                    "storage",
                                                                    "mass_damping_rho",
                                                                    "stiffness_damping_G",
                                                                    "stiffness_damping_lambda",
                                                                    "sealed_normal",
                                                                    "sealed_tangential",
                                                                    "open_normal",
                                                                    "open_tangential",
                                                                    "open_coupling",
                                                                    "open_mobility"};

const auto fields_of_family = [](auto& family, const auto& visit) {
  visit("n_prescribed", family.reduced.fixed.n_prescribed);
  visit("n_kept", family.reduced.n_kept);
  visit("slip_loads", family.reduced.slip_loads);
  visit("slip_readings", family.reduced.slip_readings);
  visit("safety", family.reduced.safety, positive);
  visit("shift", family.reduced.fixed.shift, positive);
  visit("tolerance", family.tolerance, positive);
};

const std::string equations = "of M q'' + C q' + K q = sum_k load_k f_k, fixed + sum_q coefficient_q part_q";

void write_indices(Hdf5Image& image, const std::string& path, const std::vector<double>& values,
                   const std::string& meaning) {
  image.numbers(path, {values.size()}, values.data(), {"1", meaning});
}

/// Rows of readings, where there are any.
void write_rows_of(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& rows) {
  if (rows.size() == 0 || rows.isZero(0.)) return;
  write_packed(image, path, rows, {"", "of y = position q + velocity q' + acceleration q'' + feedthrough f"});
}

void write_part(Hdf5Image& image, const std::string& path, const ReducedSystem& part, const std::vector<bool>& is_phi) {
  image.group(path);
  write_blocks(image, path + "/M", part.M, is_phi);
  write_blocks(image, path + "/C", part.C, is_phi);
  write_blocks(image, path + "/K", part.K, is_phi);
  write_rows_of(image, path + "/position", part.position);
  write_rows_of(image, path + "/velocity", part.velocity);
  write_rows_of(image, path + "/acceleration", part.acceleration);
}

std::string path_of_part(const std::string& group, std::size_t q) {
  return group + "/part" + std::to_string(q);
}

void write_terms(Hdf5Image& image, const std::string& group, const std::vector<AffineTerm>& terms) {
  std::vector<std::string> region, coefficient;
  for (const AffineTerm& term : terms) {
    region.push_back(term.region);
    coefficient.emplace_back(coefficient_words[static_cast<std::size_t>(term.coefficient)]);
  }
  image.texts(group + "/term_region", region);
  image.texts(group + "/term_coefficient", coefficient);
}

void write_names(Hdf5Image& image, const std::string& group, const std::vector<ReadingName>& names) {
  std::vector<std::string> of_group, probe, quantity;
  std::vector<double> node;
  for (const ReadingName& name : names) {
    of_group.push_back(name.group);
    probe.push_back(name.probe);
    quantity.push_back(name.quantity);
    node.push_back(name.node);
  }
  image.texts(group + "/readings/group", of_group);
  image.texts(group + "/readings/probe", probe);
  image.texts(group + "/readings/quantity", quantity);
  write_indices(image, group + "/readings/node", node, "number of a node; -1: none");
}

void write_phi(Hdf5Image& image, const std::string& group, const FieldBasis& phi) {
  image.group(group);
  write_indices(image, group + "/unknown", {phi.unknown.begin(), phi.unknown.end()}, "row of phi among the unknowns");
  write_indices(image, group + "/coordinate", {phi.coordinate.begin(), phi.coordinate.end()},
                "of the family, by column");
  image.numbers(group + "/unit", {phi.unknown.size()}, phi.unit.data(), {"Pa s", "by row"});
  write_matrix(image, group + "/vectors", phi.columns(), {"1", "phi = unit vectors q"});
}

void write_training(Hdf5Image& image, const std::string& group, const SampledLoads& training) {
  image.numbers(group + "/time", {training.time.size()}, training.time.data(),
                {"s", "of the histories under which a member is reduced"});
  write_packed(image, group + "/begin", training.begin, {"", "f_k at each time but the last, from the right"});
  write_packed(image, group + "/end", training.end, {"", "f_k at each time but the first, from the left"});
}

void write_made(Hdf5Image& image, const std::string& group, const SoilFamilyFile& family) {
  write_matrix(image, group + "/factors", family.factors, {"", "coefficients of the soils that were solved, by part"});
  image.numbers(
      group + "/estimates", {family.estimates.size()}, family.estimates.data(),
      {"1", "largest estimate of F_T's error over its peak among the candidates, after each round of points"});
}

/// Whether the symmetric matrix has no negative eigenvalue, but for round-off as in the file of a slip.
bool is_not_negative(const Eigen::MatrixXd& A) {
  constexpr double round_off = 1e-8;
  const double scale = A.size() == 0 ? 0. : A.cwiseAbs().maxCoeff();
  if (scale == 0.) return true;
  Eigen::MatrixXd lifted = A / scale;
  lifted.diagonal().array() += round_off * static_cast<double>(A.rows());
  return Eigen::LLT<Eigen::MatrixXd>(lifted).info() == Eigen::Success;
}

/// The blocks on the diagonal without prescribed coordinates, those of phi multiplied by -1. What couples both kinds
/// takes no part in the energy of C, and is zero in M and K.
bool has_energy(const Eigen::MatrixXd& A, const ReducedSystem& of) {
  if (A.size() == 0) return true;
  for (const bool phi : {false, true}) {
    std::vector<int> list;
    for (int i = of.n_prescribed; i < of.size(); ++i)
      if (of.is_phi[static_cast<std::size_t>(i)] == phi) list.push_back(i);
    if (!is_not_negative((phi ? -1. : 1.) * A(list, list))) return false;
  }
  return true;
}

void require_energies(ModelParts& parts, const std::string& what, const ReducedSystem& system) {
  if (!has_energy(system.M, system)) parts.wrong(what + " has a negative kinetic energy (M)");
  if (!has_energy(system.C, system)) parts.wrong(what + " brings energy in (C)");
  if (!has_energy(system.K, system)) parts.wrong(what + " has a negative strain energy (K)");
}

/// What M and K couple must be zero.
void require_uncoupled(ModelParts& parts, const std::string& path) {
  for (const char* name : {"/M_up", "/K_up"})
    if (parts.has_dataset(path + name)) parts.wrong(path + name + " is there, but couples nothing in any soil");
}

Eigen::MatrixXd read_rows_of(ModelParts& parts, const std::string& path, std::size_t rows, std::size_t columns) {
  if (!parts.has_dataset(path)) return {};
  return parts.matrix(path, rows, columns);
}

void read_part(ModelParts& parts, const std::string& path, ReducedSystem& part) {
  require_uncoupled(parts, path);
  part.M = read_blocks(parts, path + "/M", part.is_phi);
  part.C = read_blocks(parts, path + "/C", part.is_phi);
  part.K = read_blocks(parts, path + "/K", part.is_phi);
  const std::size_t i = part.reading_label.size(), r = part.is_phi.size();
  part.position = read_rows_of(parts, path + "/position", i, r);
  part.velocity = read_rows_of(parts, path + "/velocity", i, r);
  part.acceleration = read_rows_of(parts, path + "/acceleration", i, r);
}

std::vector<AffineTerm> read_terms(ModelParts& parts, const std::string& group) {
  std::vector<AffineTerm> terms;
  const std::vector<std::string> regions = parts.texts(group + "/term_region");
  const std::vector<std::string> words = parts.texts(group + "/term_coefficient", regions.size());
  for (std::size_t q = 0; q < regions.size(); ++q) {
    const auto* found = std::find(coefficient_words.begin(), coefficient_words.end(), words[q]);
    if (found == coefficient_words.end()) {
      if (!words[q].empty()) parts.wrong(group + "/term_coefficient holds " + in_quotes(words[q]));
      found = coefficient_words.begin();
    }
    const AffineTerm term{regions[q], static_cast<Coefficient>(found - coefficient_words.begin())};
    const auto same = [&term](const AffineTerm& other) {
      return other.region == term.region && other.coefficient == term.coefficient;
    };
    if (std::any_of(terms.begin(), terms.end(), same))
      parts.wrong(group + "/term_region names a term twice: " + in_quotes(*found) + " of " + in_quotes(term.region));
    terms.push_back(term);
  }
  return terms;
}

std::vector<ReadingName> read_names(ModelParts& parts, const std::string& group,
                                    const std::vector<ReadingLabel>& labels) {
  const std::size_t n = labels.size();
  const std::vector<std::string> of_group = parts.texts(group + "/readings/group", n),
                                 probe = parts.texts(group + "/readings/probe", n),
                                 quantity = parts.texts(group + "/readings/quantity", n);
  constexpr int most = 1000000;
  const std::vector<int> node = read_indices(parts, group + "/readings/node", n, -1, most);
  std::vector<ReadingName> names;
  for (std::size_t i = 0; i < n; ++i) {
    ReadingName name(of_group[i], node[i], quantity[i]);
    name.probe = probe[i];
    if (name.text() != labels[i].name)
      parts.wrong(group + "/readings/name holds " + in_quotes(labels[i].name) + ", where its parts make " +
                  in_quotes(name.text()));
    names.push_back(name);
  }
  return names;
}

std::size_t n_bonded_loads(const ReducedFamily& family) {
  const std::size_t all = family.fixed.load_name.size();
  return all - std::min(all, static_cast<std::size_t>(family.slip_loads));
}

SampledLoads read_training(ModelParts& parts, const std::string& group, std::size_t n_loads) {
  const std::size_t n = parts.length(group + "/time");
  SampledLoads training{parts.numbers(group + "/time", {n}), {}, {}};
  if (n < 2) parts.wrong(group + "/time has fewer than two times");
  const std::size_t steps = n < 2 ? 0 : n - 1;
  training.begin = parts.matrix(group + "/begin", n_loads, steps);
  training.end = parts.matrix(group + "/end", n_loads, steps);
  if (n > 0 && training.time.front() != 0.) parts.wrong(group + "/time does not begin with 0");
  for (std::size_t i = 1; i < n; ++i)
    if (!(training.time[i] > training.time[i - 1])) {
      parts.wrong(group + "/time does not ascend");
      break;
    }
  if (training.begin.isZero(0.) && training.end.isZero(0.)) parts.wrong(group + "/begin and /end hold no load");
  return training;
}

FieldBasis read_phi(ModelParts& parts, const std::string& group, const ReducedSystem& of) {
  constexpr int most_unknowns = 100000000;
  const std::size_t rows = parts.length(group + "/unknown"), columns = parts.length(group + "/coordinate");
  FieldBasis phi;
  phi.unknown = read_indices(parts, group + "/unknown", rows, 0, most_unknowns);
  phi.coordinate = read_indices(parts, group + "/coordinate", columns, 0, of.size());
  const std::vector<double> unit = parts.numbers(group + "/unit", {rows});
  phi.unit = Eigen::Map<const Vector>(unit.data(), static_cast<Eigen::Index>(unit.size()));
  phi.vectors = parts.matrix(group + "/vectors", rows, columns);
  for (const int coordinate : phi.coordinate)
    if (parts.is_sound() && !of.is_phi[static_cast<std::size_t>(coordinate)])
      parts.wrong(group + "/coordinate holds " + std::to_string(coordinate) + ", which is none of phi");
  return phi;
}

void read_made(ModelParts& parts, const std::string& group, SoilFamilyFile& family) {
  const std::size_t n = parts.length(group + "/factors"), rounds = parts.length(group + "/estimates");
  if (n == 0) parts.wrong(group + "/factors holds no soil");
  family.factors = parts.matrix(group + "/factors", n, family.terms.size());
  family.estimates = parts.numbers(group + "/estimates", {rounds});
  for (const double estimate : family.estimates)
    if (estimate < 0.) parts.wrong(group + "/estimates holds " + significant(estimate));
}

constexpr int most_coordinates = 4000;  ///< a family has some hundreds

/// Whether a bonded member is left where the loads, the readings and the coordinate of a slip are left out.
bool slip_fits(const ReducedFamily& f) {
  const auto fewer = [](int of_slip, std::size_t all) {
    return of_slip == 0 || static_cast<std::size_t>(of_slip) < all;
  };
  return fewer(f.slip_loads, f.fixed.load_name.size()) && fewer(f.slip_readings, f.fixed.reading_label.size()) &&
         (!f.slips() || f.n_kept > f.fixed.n_prescribed);
}

/// Notes where coordinates, loads or readings leave nothing to be solved; returns whether they do not.
bool require_coordinates(ModelParts& parts, const std::string& group, const ReducedFamily& f) {
  const int kept = f.n_kept, prescribed = f.fixed.n_prescribed, all = f.fixed.size();
  const bool fits = prescribed <= kept && kept <= all, slips = slip_fits(f);
  if (!fits || prescribed == all)
    parts.wrong(group + " keeps " + std::to_string(kept) + " coordinates, of which " + std::to_string(prescribed) +
                " are prescribed, of " + std::to_string(all));
  if (!slips)
    parts.wrong(group + " has " + std::to_string(f.slip_loads) + " loads and " + std::to_string(f.slip_readings) +
                " readings of a slip, of " + std::to_string(f.fixed.load_name.size()) + " and " +
                std::to_string(f.fixed.reading_label.size()));
  return fits && slips;
}

/// Reads what all members have in common; whether their parts can be read by it.
bool read_common(ModelParts& parts, const std::string& group, SoilFamilyFile& family) {
  ReducedSystem& fixed = family.reduced.fixed;
  const std::size_t size = parts.length(group + "/is_phi");
  for (const int phi : read_indices(parts, group + "/is_phi", size, 0, 2)) fixed.is_phi.push_back(phi == 1);
  fixed.load_name = parts.texts(group + "/load_name");
  fixed.load = parts.matrix(group + "/load", size, fixed.load_name.size());
  fixed.prescribed = read_indices(parts, group + "/prescribed", fixed.load_name.size(), -1, fixed.size());
  fixed.reading_label = read_labels(parts, group + "/readings");
  family.names = read_names(parts, group, fixed.reading_label);
  fixed.feedthrough = parts.matrix(group + "/feedthrough", fixed.reading_label.size(), fixed.load_name.size());
  require_prescribed(parts, group, fixed);
  const bool fits = require_coordinates(parts, group, family.reduced);
  const auto is_shear = [](const ReadingLabel& label) { return label.name == reading::shear_force; };
  if (std::none_of(fixed.reading_label.begin(), fixed.reading_label.end(), is_shear))
    parts.wrong(group + "/readings/name does not name '" + reading::shear_force + "'");
  if (fixed.size() > most_coordinates)
    parts.wrong(group + "/is_phi has " + std::to_string(fixed.size()) + " coordinates, more than " +
                std::to_string(most_coordinates));
  return fits && parts.is_sound();
}

/// What a part has of a member: no loads of its own.
ReducedSystem empty_part(const ReducedSystem& fixed) {
  ReducedSystem part = fixed;
  part.load.setZero();
  part.feedthrough.setZero();
  return part;
}

void fill(Eigen::MatrixXd& matrix, Eigen::Index rows, Eigen::Index columns) {
  if (matrix.size() == 0) matrix.setZero(rows, columns);
}

void read_parts(ModelParts& parts, const std::string& group, SoilFamilyFile& family) {
  ReducedFamily& reduced = family.reduced;
  for (std::size_t q = 0; q < family.terms.size(); ++q) reduced.parts.push_back(empty_part(reduced.fixed));
  read_part(parts, group + "/fixed", reduced.fixed);
  const Eigen::Index r = reduced.fixed.size(), i = static_cast<Eigen::Index>(reduced.fixed.reading_label.size());
  for (Eigen::MatrixXd* A : {&reduced.fixed.M, &reduced.fixed.C, &reduced.fixed.K}) fill(*A, r, r);
  for (Eigen::MatrixXd* rows : {&reduced.fixed.position, &reduced.fixed.velocity, &reduced.fixed.acceleration})
    fill(*rows, i, r);
  for (std::size_t q = 0; q < family.terms.size(); ++q) {
    read_part(parts, path_of_part(group, q), reduced.parts[q]);
    require_energies(parts, path_of_part(group, q), reduced.parts[q]);
  }
  for (Eigen::Index p = 0; p < family.factors.rows() && parts.is_sound(); ++p) {
    const Eigen::RowVectorXd row = family.factors.row(p);
    require_energies(parts, group + ": the soil of point " + std::to_string(p), reduced.at({row.begin(), row.end()}));
  }
}

}  // namespace

void write_family(Hdf5Image& image, const std::string& group, const SoilFamilyFile& family) {
  const ReducedSystem& fixed = family.reduced.fixed;
  image.group(group);
  write_attributes(image, group, fields_of_family, family);
  write_terms(image, group, family.terms);
  write_indices(image, group + "/is_phi", {fixed.is_phi.begin(), fixed.is_phi.end()},
                "1: a coordinate of the integrated pore pressure, row of the equation multiplied by -1; 0: of "
                "displacements");
  write_indices(image, group + "/prescribed", {fixed.prescribed.begin(), fixed.prescribed.end()},
                "coordinate whose velocity the load prescribes; -1: none");
  image.texts(group + "/load_name", fixed.load_name);
  write_packed(image, group + "/load", fixed.load, {"", equations});
  write_labels(image, group + "/readings", fixed.reading_label);
  write_names(image, group, family.names);
  write_packed(image, group + "/feedthrough", fixed.feedthrough,
               {"unit of the reading / unit of the load", "feedthrough_ik of the readings"});
  write_training(image, group, family.training);
  write_made(image, group, family);
  if (family.phi.n() > 0) write_phi(image, group + "/phi", family.phi);
  write_part(image, group + "/fixed", fixed, fixed.is_phi);
  for (std::size_t q = 0; q < family.reduced.parts.size(); ++q)
    write_part(image, path_of_part(group, q), family.reduced.parts[q], fixed.is_phi);
}

SoilFamilyFile read_family(ModelParts& parts, const std::string& group) {
  SoilFamilyFile family;
  if (!parts.has(group, "n_kept")) {
    parts.wrong(group + " is missing");
    return family;
  }
  read_attributes(parts, group, fields_of_family, family);
  family.terms = read_terms(parts, group);
  const bool readable = read_common(parts, group, family);
  if (readable) family.training = read_training(parts, group, n_bonded_loads(family.reduced));
  read_made(parts, group, family);
  if (parts.has_dataset(group + "/phi/vectors")) family.phi = read_phi(parts, group + "/phi", family.reduced.fixed);
  if (readable) read_parts(parts, group, family);
  return family;
}

}  // namespace upbead::detail
