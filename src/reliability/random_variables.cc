#include "reliability/random_variables.h"

#include <openturns/OT.hxx>
#include <stdexcept>

#include "base/text.h"

namespace upbead {

namespace {

/// By moments, as OpenTURNS computes parameters from them.
OT::Distribution whole(const RandomVariable& v) {
  switch (v.kind) {
    case RandomKind::normal:
      return OT::Normal(*v.mean, *v.deviation);
    case RandomKind::lognormal:
      return OT::LogNormalMuSigma(*v.mean, *v.deviation, v.location.value_or(0.)).getDistribution();
    case RandomKind::gumbel:
      return OT::GumbelMuSigma(*v.mean, *v.deviation).getDistribution();
    case RandomKind::weibull:
      return OT::WeibullMinMuSigma(*v.mean, *v.deviation, v.location.value_or(0.)).getDistribution();
    case RandomKind::uniform:
      return OT::Uniform(*v.low, *v.high);
    case RandomKind::triangular:
      break;
  }
  return OT::Triangular(*v.low, *v.mode, *v.high);
}

OT::Distribution marginal(const RandomVariable& v) {
  const OT::Distribution all = whole(v);
  if (v.kind == RandomKind::uniform || v.kind == RandomKind::triangular || (!v.low && !v.high)) return all;
  if (v.low && v.high) return OT::TruncatedDistribution(all, *v.low, *v.high);
  return v.low ? OT::TruncatedDistribution(all, *v.low, OT::TruncatedDistribution::LOWER)
               : OT::TruncatedDistribution(all, *v.high, OT::TruncatedDistribution::UPPER);
}

std::size_t place_of(const std::string& name, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return i;
  throw std::invalid_argument("there is no variable " + name);
}

OT::Distribution joint(const RandomVariables& variables) {
  OT::Collection<OT::Distribution> marginals;
  for (const RandomVariable& v : variables.list) marginals.add(marginal(v));
  if (variables.correlations.empty()) return OT::ComposedDistribution(marginals);
  OT::CorrelationMatrix R(variables.list.size());
  for (const RandomCorrelation& c : variables.correlations)
    R(place_of(c.first, variables.names), place_of(c.second, variables.names)) = c.coefficient;
  if (!R.isPositiveDefinite())
    throw std::invalid_argument("the correlations cannot stand beside each other: their matrix is not positive");
  return OT::ComposedDistribution(marginals, OT::NormalCopula(R));
}

}  // namespace

struct StandardSpace::Transformation {
  OT::Function physical;
};

StandardSpace::StandardSpace(const RandomVariables& variables) : size_(variables.list.size()) {
  try {
    transformation_ =
        std::make_shared<Transformation>(Transformation{joint(variables).getInverseIsoProbabilisticTransformation()});
  } catch (const OT::Exception& error) {
    throw std::invalid_argument(error.what());
  }
}

std::vector<double> StandardSpace::physical(const std::vector<double>& u) const {
  OT::Point point(u.size());
  std::copy(u.begin(), u.end(), point.begin());
  const OT::Point x = transformation_->physical(point);
  return {x.begin(), x.end()};
}

namespace {

/// Whether 0 and less are values like others: of rises and levels, and of angles.
bool may_be_negative(const std::string& acts_on) {
  const std::string key = acts_on.substr(acts_on.rfind('.') + 1);
  const std::vector<std::string> keys{"water_level", "harbour_level", "angle", "direction", "facing"};
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

NumberedWarnings not_positive(const RandomVariables& variables) {
  constexpr double low = -4.;  // in standard space
  NumberedWarnings list;
  for (std::size_t i = 0; i < variables.list.size(); ++i) {
    if (may_be_negative(variables.list[i].acts_on)) continue;
    const double least = StandardSpace({{variables.names[i]}, {variables.list[i]}, {}}).physical({low})[0];
    if (least <= 0.)
      list.push_back({"variable_not_positive", least, 0., "1",
                      "the variable " + variables.names[i] + " falls to " + significant(least, 3) +
                          " within 4 standard deviations, and " + variables.list[i].acts_on + " is positive",
                      "cut it by low, or give it another distribution, such as lognormal"});
  }
  return list;
}

}  // namespace upbead
