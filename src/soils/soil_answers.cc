#include "soils/soil_answers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <set>

#include "base/numbers.h"
#include "base/text.h"
#include "fem/caisson/reading_names.h"
#include "response/held_readings.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/expected/distribution.h"

namespace upbead {

namespace {

const char* const again = "make it again with 'upbead reduce --soils'";

/// |H| of nested members may differ by this multiple of the tolerance, as in reduce().
constexpr double transfer_tolerance = 4.;

std::vector<std::string> joined_names(const std::vector<std::string>& loads) {
  ModalModel model;
  model.load_name = loads;
  const auto n = static_cast<Eigen::Index>(loads.size());
  model.load.setZero(0, n);
  model.reading.setZero(0, 0);
  model.feedthrough.setZero(0, n);
  model.impulse.setZero(0, n);
  join_pore_pressures(model);
  return model.load_name;
}

ReduceOptions options_of(const SoilFamilyFile& family, const ReducedSystem& member, std::vector<int> measured) {
  ReduceOptions options;
  options.shift = member.shift;
  for (int i = member.n_prescribed; i < family.reduced.n_kept_bonded(); ++i)
    options.exact.push_back(unknown_of(member, i));
  options.training = family.training;
  options.measured = std::move(measured);
  options.tolerance = family.tolerance;
  options.tolerance_of_others = infinity;
  options.first_vectors = first_of_member;
  options.max_vectors = most_of_member;
  return options;
}

/// The finite number that a whole text is.
std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Indices of F_T and of other readings, each once.
std::vector<int> indices_of(const std::vector<ReadingLabel>& labels, const std::vector<std::string>& names) {
  std::vector<int> list{index_of(labels, reading::shear_force)};
  for (const std::string& name : names) {
    const int i = index_of(labels, name);
    if (std::find(list.begin(), list.end(), i) == list.end()) list.push_back(i);
  }
  return list;
}

/// A member's readings, and behind them, where the forces on the base are told, what a family holds.
ReducedSystem with_held(ReducedSystem member, const std::optional<ModelBase>& base) {
  if (!base) return member;
  const HeldReadings held = held_readings(member.reading_label, base->width);
  std::vector<ReadingLabel> labels = member.reading_label;
  labels.insert(labels.end(), held.labels.begin(), held.labels.end());
  const Eigen::Index n = member.position.rows(), more = held.sums.rows();
  Eigen::MatrixXd sums = Eigen::MatrixXd::Identity(n + more, n);
  sums.bottomRows(more) = held.sums;
  return with_readings(std::move(member), sums, std::move(labels));
}

/// A member with some of its readings.
ReducedSystem with_some(ReducedSystem member, const std::vector<int>& readings) {
  const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(member.position.rows(), member.position.rows());
  std::vector<ReadingLabel> labels;
  for (const int i : readings) labels.push_back(member.reading_label[static_cast<std::size_t>(i)]);
  return with_readings(std::move(member), all(readings, Eigen::all), std::move(labels));
}

/// first, first + 1, ... end - 1.
std::vector<int> counted(std::size_t first, std::size_t end) {
  std::vector<int> list(end - first);
  std::iota(list.begin(), list.end(), static_cast<int>(first));
  return list;
}

/// How far nested models of a reduction lie apart in a reading; 0 where the first was exact.
double own_error(const Reduction& reduction, int reading) {
  return reduction.error.of_reading.size() > 0 ? reduction.error.of_reading[reading] : 0.;
}

void require_reduced(const Reduction& reduction, const std::string& soil) {
  if (reduction.converged) return;
  const int worst = *std::max_element(reduction.measured.begin(), reduction.measured.end(),
                                      [&](int a, int b) { return own_error(reduction, a) < own_error(reduction, b); });
  throw NumericsError("the model of the soil " + soil + " has not converged after " +
                      std::to_string(reduction.n_solves) +
                      " solves: " + reduction.model.reading_label[static_cast<std::size_t>(worst)].name +
                      " is uncertain by " + percent(own_error(reduction, worst)) + " of its peak");
}

/// Largest difference of nested models over the largest value, of each reading, under the training histories.
Eigen::VectorXd differences(const ModalModel& all, const ModalModel& fewer, const SampledLoads& training) {
  const Eigen::MatrixXd y = respond(all, training).reading, of_fewer = respond(fewer, training).reading;
  const Eigen::VectorXd largest = y.cwiseAbs().rowwise().maxCoeff(),
                        far = (y - of_fewer).cwiseAbs().rowwise().maxCoeff();
  return (largest.array() > 0.).select(far.cwiseQuotient(largest), 0.);
}

/// The same of the largest and least values of one reading.
double difference_of_peaks(const ModalModel& all, const ModalModel& fewer, const SampledLoads& training) {
  const Eigen::RowVectorXd y = respond(all, training).reading.row(0),
                           of_fewer = respond(fewer, training).reading.row(0);
  const double largest = y.cwiseAbs().maxCoeff();
  if (largest == 0.) return 0.;
  return std::max(std::abs(y.maxCoeff() - of_fewer.maxCoeff()), std::abs(y.minCoeff() - of_fewer.minCoeff())) / largest;
}

/// A soil in all directions of the family and in half of them.
struct SoilReductions {
  Reduction all, fewer;       ///< `fewer` has the measured readings of `all` alone
  std::vector<int> measured;  ///< readings of `all`: F_T, those that were asked for, those that the family holds
  std::vector<int> held;      ///< of the measured ones, F_T and those that the family holds
};

SoilReductions reductions_of(const SoilModelFile& file, const System& like, const std::vector<double>& factors,
                             const std::vector<std::string>& readings) {
  const SoilFamilyFile& family = file.family;
  const ReducedSystem member = with_held(family.reduced.bonded(factors), file.frame.base);
  SoilReductions out;
  out.measured = indices_of(member.reading_label, readings);
  out.held = {0};
  for (const int i : counted(like.readings.size(), member.reading_label.size())) {
    out.held.push_back(static_cast<int>(out.measured.size()));
    out.measured.push_back(i);
  }
  out.all = reduce(as_system(member, names_of(member, like.loads)), options_of(family, member, out.measured));
  const ReducedSystem fewer =
      with_some(with_held(family.reduced.bonded(factors, nested_share), file.frame.base), out.measured);
  out.fewer =
      reduce(as_system(fewer, names_of(fewer, like.loads)), options_of(family, fewer, counted(0, out.measured.size())));
  return out;
}

/// Of F_T and of what the family holds; other readings that were asked for have estimates of their own.
double error_of(const SoilReductions& soil, const SoilFamilyFile& family) {
  double own = 0.;
  std::vector<int> rows;
  for (const int i : soil.held) {
    rows.push_back(soil.measured[static_cast<std::size_t>(i)]);
    own = std::max(own, own_error(soil.all, rows.back()));
  }
  const Eigen::VectorXd far =
      differences(soil.all.model.with_readings(rows), soil.fewer.model.with_readings(soil.held), family.training);
  return own + family.reduced.safety * far.maxCoeff();
}

}  // namespace

SoilAnswers::SoilAnswers(SoilModelFile file, std::string path)
    : file_(std::move(file)),
      path_(std::move(path)),
      text_(file_.regions_text, path_),
      like_(bonded_names(file_.family)) {
  Diagnostics mistakes;
  for (const SoilAxis& axis : file_.box)
    if (!text_.number(axis.key)) mistakes.add({path_}, "/regions has no number " + in_quotes(axis.key), again);
  for (const AffineTerm& term : file_.family.terms)
    if (!text_.has_region(term.region))
      mistakes.add({path_}, "/regions has no region " + in_quotes(term.region), again);
  std::vector<std::string> loads;
  for (const SystemLoad& load : like_.loads) loads.push_back(load.name);
  if (joined_names(loads) != file_.frame.modes.load_name)
    mistakes.add({path_}, "/family has other loads than the model", again);
  mistakes.throw_if_any();
}

Soil SoilAnswers::whole(const Soil& given) const {
  Diagnostics mistakes;
  Soil whole;
  for (const SoilAxis& axis : file_.box) whole[axis.key] = *text_.number(axis.key);
  const std::string box = "the model is good for " + box_text();
  std::set<std::string> set;
  for (const auto& [key, value] : given) {
    const auto axis = std::find_if(file_.box.begin(), file_.box.end(),
                                   [k = &key](const SoilAxis& one) { return is_same_key(one.key, *k); });
    if (axis == file_.box.end())
      mistakes.add(Place(), in_quotes(key) + " is no key that the model varies", box);
    else if (!set.insert(axis->key).second)
      mistakes.add(Place(), axis->key + " is given twice", "give it once");
    else
      whole[axis->key] = value;
  }
  for (const SoilAxis& axis : file_.box) {
    const double value = whole[axis.key], room = 1e-12 * std::max(std::abs(axis.low), std::abs(axis.high));
    if (!(value >= axis.low - room && value <= axis.high + room))
      mistakes.add(Place(), axis.key + " = " + number_text(value) + " lies outside the box of the model", box);
  }
  mistakes.throw_if_any();
  return whole;
}

std::vector<double> SoilAnswers::factors(const Soil& whole) const {
  const std::map<std::string, Coefficients> of_region = text_.coefficients(whole);
  std::vector<double> list;
  for (const AffineTerm& term : file_.family.terms)
    list.push_back(of_region.at(term.region)[static_cast<std::size_t>(term.coefficient)]);
  if (!std::all_of(list.begin(), list.end(), [](double factor) { return std::isfinite(factor); }))
    throw InputError({path_}, "a soil's coefficients are not finite numbers", again);
  return list;
}

std::vector<ReadingLabel> SoilAnswers::readings() const {
  const ReducedFamily& family = file_.family.reduced;
  const std::vector<ReadingLabel>& all = family.fixed.reading_label;
  return {all.begin(), all.end() - family.slip_readings};
}

AnsweredSoil SoilAnswers::member(const Soil& whole, const std::vector<std::string>& readings) const {
  const SoilFamilyFile& family = file_.family;
  SoilReductions soil = reductions_of(file_, like_, factors(whole), readings);
  require_reduced(soil.all, soil_in_words(whole));
  const Reduction& all = soil.all;
  NestedModels nested{soil.fewer.model.with_reading(0), all.model.with_reading(soil.measured.front()),
                      all.n_solves + soil.fewer.n_solves, 2, family.reduced.safety};
  const double agreed =
      agreed_frequency(nested.middle, nested.reference, {0}, transfer_tolerance * file_.frame.tolerance,
                       1. / family.training.time.back(), 100. * all.system.shift);
  ReducedModelFile model = file_.frame;
  model.modes = all.model.with_readings(counted(0, like_.readings.size()));
  // a space that is exhausted at once is exact, and has no smaller one to be compared with
  const double own = all.history.empty() ? agreed : all.omega;
  model.highest_frequency = std::min(own, agreed) / two_pi;
  model.error = error_of(soil, family);
  model.error_peak =
      all.error.peak + nested.safety * difference_of_peaks(nested.reference, nested.middle, family.training);
  model.solves = nested.solves;
  model.factorisations = nested.factorisations;
  for (ModalModel* modes : {&model.modes, &nested.middle, &nested.reference, &soil.fewer.model})
    join_pore_pressures(*modes);
  model.nested = std::move(nested);
  model.slip.reset();
  model.circles.reset();
  model.error_march.reset();
  return {std::move(model), std::move(soil.fewer.model)};
}

std::string SoilAnswers::box_text() const {
  std::vector<std::string> list;
  for (const SoilAxis& axis : file_.box)
    list.push_back(axis.key + " from " + number_text(axis.low) + " to " + number_text(axis.high));
  return join(list, ", ");
}

Soil drawn_soil(const std::vector<SoilAxis>& box, int draw) {
  constexpr std::uint64_t seed = 1;
  Soil soil;
  for (std::size_t a = 0; a < box.size(); ++a) {
    const SoilAxis& axis = box[a];
    const double share = Stream(seed).uniform({static_cast<std::uint32_t>(draw), static_cast<std::uint32_t>(a), 0, 0});
    soil[axis.key] =
        axis.logarithmic ? axis.low * std::pow(axis.high / axis.low, share) : axis.low + share * (axis.high - axis.low);
  }
  return soil;
}

std::string soil_in_words(const Soil& soil) {
  std::vector<std::string> list;
  for (const auto& [key, value] : soil) list.push_back(key + " = " + number_text(value));
  return join(list, ", ");
}

Soil soil_of_options(const std::vector<std::string>& options, const std::string& before) {
  Diagnostics mistakes;
  Soil soil;
  for (const std::string& option : options) {
    const std::size_t equals = option.find('=');
    const std::string key = option.substr(0, equals);
    const std::optional<double> value =
        equals == std::string::npos ? std::nullopt : number_in(option.substr(equals + 1));
    if (!value || key.empty())
      mistakes.add({before + excerpt(option, 300)}, "no KEY=NUMBER",
                   "write such as " + before + "regions.seabed.shear_modulus=25e6");
    else if (!soil.emplace(key, *value).second)
      mistakes.add({before + excerpt(option, 300)}, "the key is given twice", "give it once");
  }
  mistakes.throw_if_any();
  return soil;
}

}  // namespace upbead
