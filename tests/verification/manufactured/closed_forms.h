// The closed forms of a manufactured solution, as written in tests/reference, evaluated at points.
#pragma once

#include <deal.II/base/function_parser.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "reference.h"
#include "upbead/mesh/mesh.h"

namespace upbead::test {

/// Expressions in x, y, t, by name: fields ("ux", "p"), derivatives ("ux_x", "p_t"), sources ("fx", "g"), total stress
/// ("sxx_total"), flux ("qx").
class ClosedForms {
 public:
  /// `expressions`: name -> expression in Python's notation; `parameters`: name -> value.
  ClosedForms(const Json& expressions, const Json& parameters);

  double operator()(const std::string& name, const dealii::Point<dim>& at, double t) const;
  /// phi: the time integral of p from 0 to t, by Gauss's rule of 12 points, which is accurate to round-off over half
  /// a wave of p.
  double phi(const dealii::Point<dim>& at, double t) const;

 private:
  std::map<std::string, std::unique_ptr<dealii::FunctionParser<dim>>> forms_;
};

}  // namespace upbead::test
