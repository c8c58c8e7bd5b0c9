// Meshes made of lines x = const and y = const, for problems whose exact solution lives on layers and half-planes.
#pragma once

#include <deal.II/base/point.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "upbead/mesh/mesh.h"

namespace upbead::test {

/// The name of the cell or face at a point; "" for none.
using Naming = std::function<std::string(const dealii::Point<dim>&)>;

/// Cells between the lines, ascending; `surface` names each cell by its centre ("": a hole), `curve` each face by its
/// centre ("": on no curve). Every outer face needs a name.
std::unique_ptr<Mesh> tensor_mesh(const std::vector<double>& x, const std::vector<double>& y, const Naming& surface,
                                  const Naming& curve);

/// Lines from `from` to `to`, both included, ascending whichever way that is: cells start with the size `first` at
/// `from`, grow by the factor `growth` up to the size `largest`, and are all shrunk by one factor to fit.
std::vector<double> graded_lines(double from, double to, double first, double growth, double largest);

/// n equal cells from `from` to `to`.
std::vector<double> even_lines(double from, double to, int n);

/// Both sets of lines in one, ascending; lines closer than 1e-9 of the extent are one.
std::vector<double> joined(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace upbead::test
