#include "soils/soil_answers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/numbers.h"
#include "base/text.h"
#include "fem/caisson/reading_names.h"
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

ReduceOptions options_of(const SoilFamilyFile& family, const ReducedSystem& member, int measured) {
  ReduceOptions options;
  options.shift = member.shift;
  for (int i = member.n_prescribed; i < family.reduced.n_kept_bonded(); ++i)
    options.exact.push_back(unknown_of(member, i));
  options.training = family.training;
  options.measured = {measured};
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

/// A member with one of its readings.
struct OneReadingOf {
  OneReadingOf(ReducedSystem of, const System& like, int i) : member(std::move(of)) {
    for (Eigen::MatrixXd* rows : {&member.position, &member.velocity, &member.acceleration, &member.feedthrough})
      *rows = rows->row(i).eval();
    member.reading_label = {member.reading_label[static_cast<std::size_t>(i)]};
    names.loads = like.loads;
    names.readings = {like.readings[static_cast<std::size_t>(i)]};
  }
  System system() const { return as_system(member, names); }

  ReducedSystem member;
  System names;
};

ModalModel row_of(const ModalModel& model, int i) {
  ModalModel one = model;
  one.reading = model.reading.row(i);
  one.feedthrough = model.feedthrough.row(i);
  one.impulse = model.impulse.row(i);
  one.reading_label = {model.reading_label[static_cast<std::size_t>(i)]};
  return one;
}

void require_reduced(const Reduction& reduction, const std::string& soil) {
  if (reduction.converged) return;
  throw NumericsError("the model of the soil " + soil + " has not converged after " +
                      std::to_string(reduction.n_vectors) + " vectors: F_T of nested models differs by " +
                      significant(reduction.error.history) + " of its peak");
}

/// Errors of a member by nested members, under the training histories.
struct MemberError {
  MemberError(const NestedModels& nested, const SampledLoads& training) {
    const Eigen::RowVectorXd all = respond(nested.reference, training).reading.row(0),
                             fewer = respond(nested.middle, training).reading.row(0);
    const double largest = all.cwiseAbs().maxCoeff();
    if (largest == 0.) return;
    history = nested.safety * (all - fewer).cwiseAbs().maxCoeff() / largest;
    const double up = std::abs(all.maxCoeff() - fewer.maxCoeff()), down = std::abs(all.minCoeff() - fewer.minCoeff());
    peak = nested.safety * std::max(up, down) / largest;
  }
  double history = 0., peak = 0.;
};

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
  for (const auto& [key, value] : given) {
    const auto axis = std::find_if(file_.box.begin(), file_.box.end(),
                                   [k = &key](const SoilAxis& one) { return is_same_key(one.key, *k); });
    if (axis == file_.box.end())
      mistakes.add(Place(), in_quotes(key) + " is no key that the model varies", box);
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

ReducedModelFile SoilAnswers::at(const Soil& whole) const {
  const SoilFamilyFile& family = file_.family;
  const std::vector<double> of_soil = factors(whole);
  const ReducedSystem member = family.reduced.bonded(of_soil);
  const int shear = index_of(member.reading_label, reading::shear_force);
  Reduction reduction = reduce(as_system(member, like_), options_of(family, member, shear));
  require_reduced(reduction, soil_in_words(whole));
  const OneReadingOf fewer(family.reduced.bonded(of_soil, nested_share), like_, shear);
  const Reduction middle = reduce(fewer.system(), options_of(family, fewer.member, 0));
  NestedModels nested{middle.model, row_of(reduction.model, shear), reduction.n_solves + middle.n_solves, 2,
                      family.reduced.safety};
  const MemberError error(nested, family.training);
  const double agreed =
      agreed_frequency(nested.middle, nested.reference, {0}, transfer_tolerance * file_.frame.tolerance,
                       1. / family.training.time.back(), 100. * member.shift);
  ReducedModelFile model = file_.frame;
  model.modes = std::move(reduction.model);
  model.highest_frequency = std::min(reduction.omega, agreed) / two_pi;
  model.error = reduction.error.history + error.history;
  model.error_peak = reduction.error.peak + error.peak;
  model.solves = nested.solves;
  model.factorisations = nested.factorisations;
  for (ModalModel* modes : {&model.modes, &nested.middle, &nested.reference}) join_pore_pressures(*modes);
  model.nested = std::move(nested);
  model.slip.reset();
  model.circles.reset();
  model.error_march.reset();
  return model;
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

Soil soil_of_options(const std::vector<std::string>& options) {
  Diagnostics mistakes;
  Soil soil;
  for (const std::string& option : options) {
    const std::size_t equals = option.find('=');
    const std::string key = option.substr(0, equals);
    const std::optional<double> value =
        equals == std::string::npos ? std::nullopt : number_in(option.substr(equals + 1));
    if (!value || key.empty())
      mistakes.add({"--soil " + excerpt(option, 300)}, "no KEY=NUMBER",
                   "write such as --soil regions.seabed.shear_modulus=25e6");
    else if (!soil.emplace(key, *value).second)
      mistakes.add({"--soil " + excerpt(option, 300)}, "the key is given twice", "give it once");
  }
  mistakes.throw_if_any();
  return soil;
}

}  // namespace upbead
