#include "closed_forms.h"

#include <deal.II/base/quadrature_lib.h>

#include <stdexcept>

namespace upbead::test {

namespace {

/// An expression in Python's notation as the parser takes it: powers are ^. A quotient such as 13/10 is an integer
/// division in neither.
std::string for_parser(std::string expression) {
  for (auto at = expression.find("**"); at != std::string::npos; at = expression.find("**", at))
    expression.replace(at, 2, "^");
  return expression;
}

}  // namespace

ClosedForms::ClosedForms(const Json& expressions, const Json& parameters) {
  const auto constants = parameters.get<std::map<std::string, double>>();
  for (const auto& [name, expression] : expressions.items()) {
    auto& form = forms_[name] = std::make_unique<dealii::FunctionParser<dim>>(1);
    form->initialize("x,y,t", for_parser(expression.get<std::string>()), constants, true);
  }
}

double ClosedForms::operator()(const std::string& name, const dealii::Point<dim>& at, double t) const {
  const auto found = forms_.find(name);
  if (found == forms_.end()) throw std::out_of_range("no closed form " + name);
  found->second->set_time(t);
  return found->second->value(at);
}

double ClosedForms::phi(const dealii::Point<dim>& at, double t) const {
  static const dealii::QGauss<1> rule(12);
  double sum = 0.;
  for (unsigned q = 0; q < rule.size(); ++q) sum += t * rule.weight(q) * (*this)("p", at, t * rule.point(q)[0]);
  return sum;
}

}  // namespace upbead::test
