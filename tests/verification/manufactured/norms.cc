#include "norms.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>
#include <deal.II/lac/vector.h>

#include <cmath>

#include "fem/unknowns.h"
#include "record.h"

namespace upbead::test {

using namespace dealii;

namespace {

using Point2 = dealii::Point<dim>;

dealii::Vector<double> nodal(const Problem& problem, const upbead::Vector& x) {
  const upbead::Vector all = problem.compiled.unknowns.expand(x);
  return {all.begin(), all.end()};
}

/// Sums of squares of a difference and of the exact field.
struct Squares {
  double difference = 0., exact = 0.;
  void add(double computed, double value, double weight) {
    difference += (computed - value) * (computed - value) * weight;
    exact += value * value * weight;
  }
};

/// Computed values at the quadrature points of one cell.
struct PointValues {
  explicit PointValues(unsigned n) : u(n), W(n), gradient(n), phi(n), p(n) {}
  std::vector<Tensor<1, dim>> u, W;
  std::vector<Tensor<2, dim>> gradient;
  std::vector<double> phi, p;
};

}  // namespace

std::map<std::string, double> errors(const Problem& problem, const State& state) {
  const Compiled& compiled = problem.compiled;
  const bool inertial = problem.mms.kind == "inertial";
  const dealii::Vector<double> x = nodal(problem, state.x), v = nodal(problem, state.v);
  const QGauss<dim> rule(static_cast<unsigned>(compiled.space.degree()) + 2);
  hp::FEValues<dim> cells(compiled.space.dofs().get_fe_collection(), hp::QCollection<dim>(rule),
                          update_values | update_gradients | update_quadrature_points | update_JxW_values);
  PointValues values(rule.size());
  std::map<std::string, Squares> sums;
  const double t = state.time;
  for (const auto& cell : compiled.space.dofs().active_cell_iterators()) {
    const ClosedForms& form = *problem.mms.layers.at(compiled.space.mesh().surface_of(cell));
    cells.reinit(cell);
    const auto& fe = cells.get_present_fe_values();
    fe[u_part].get_function_values(x, values.u);
    fe[u_part].get_function_gradients(x, values.gradient);
    fe[phi_part].get_function_values(x, values.phi);
    fe[phi_part].get_function_values(v, values.p);
    if (inertial) fe[W_part].get_function_values(x, values.W);
    for (unsigned q = 0; q < rule.size(); ++q) {
      const Point2& at = fe.quadrature_point(q);
      const double weight = fe.JxW(q);
      for (unsigned i = 0; i < dim; ++i) {
        const std::string u = i == 0 ? "ux" : "uy";
        sums["u in L2"].add(values.u[q][i], form(u, at, t), weight);
        sums["u in H1"].add(values.gradient[q][i][0], form(u + "_x", at, t), weight);
        sums["u in H1"].add(values.gradient[q][i][1], form(u + "_y", at, t), weight);
        if (inertial) sums["W in L2"].add(values.W[q][i], form(i == 0 ? "Wx" : "Wy", at, t), weight);
      }
      sums["phi in L2"].add(values.phi[q], form.phi(at, t), weight);
      sums["p in L2"].add(values.p[q], form("p", at, t), weight);
    }
  }
  std::map<std::string, double> out;
  for (const auto& [norm, squares] : sums) out[norm] = std::sqrt(squares.difference / squares.exact);
  return out;
}

double Refinement::order_of(const std::string& norm) const {
  const auto& e = error.at(norm);
  return order({h.end() - 3, h.end()}, {e.end() - 3, e.end()});
}

Refinement refinement(const Manufactured& mms, Quads quads, const std::vector<double>& h, double end, int steps) {
  Refinement out;
  out.h = h;
  for (const double side : h) {
    const auto mesh = quadrilaterals(mms, quads, side);
    const Problem problem(mms, *mesh);
    for (const auto& [norm, error] : errors(problem, marched(problem, end, steps))) out.error[norm].push_back(error);
  }
  return out;
}

}  // namespace upbead::test
