#include "sources.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "fem/unknowns.h"

namespace upbead::test {

using namespace dealii;

namespace {

using Cell = DoFHandler<dim>::active_cell_iterator;
using Point2 = dealii::Point<dim>;
using Tensor1 = Tensor<1, dim>;

const ClosedForms& forms_on(const Compiled& compiled, const Manufactured& mms, const Cell& cell) {
  return *mms.layers.at(compiled.space.mesh().surface_of(cell));
}

/// Factors of du, dW and dphi at a point.
struct Parts {
  Tensor1 v, w;
  double s = 0.;
};

/// Adds the integral of du.v + dW.w + dphi s over a cell or a face to `rhs`.
template <class Values, class Integrand>
void integrate(const Compiled& compiled, const Cell& cell, const Values& fe, const Integrand& integrand, Vector& rhs) {
  std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
  cell->get_dof_indices(dofs);
  for (unsigned q = 0; q < fe.n_quadrature_points; ++q) {
    const Parts parts = integrand(q);
    for (unsigned i = 0; i < fe.dofs_per_cell; ++i) {
      const double part =
          parts.v * fe[u_part].value(i, q) + parts.w * fe[W_part].value(i, q) + parts.s * fe[phi_part].value(i, q);
      for (const auto& [row, weight] : compiled.unknowns.expansion(static_cast<unsigned>(dofs[i])))
        rhs[row] += weight * part * fe.JxW(q);
    }
  }
}

/// Total stress times the normal, and the outward flux.
Parts natural(const ClosedForms& form, const Point2& at, const Tensor1& n, double t) {
  const double sxy = form("sxy", at, t);
  Parts parts;
  parts.v[0] = form("sxx_total", at, t) * n[0] + sxy * n[1];
  parts.v[1] = sxy * n[0] + form("syy_total", at, t) * n[1];
  parts.s = form("qx", at, t) * n[0] + form("qy", at, t) * n[1];
  return parts;
}

}  // namespace

Vector source(const Compiled& compiled, const Manufactured& mms, double t) {
  const unsigned points = static_cast<unsigned>(compiled.space.degree()) + 2;
  const auto& elements = compiled.space.dofs().get_fe_collection();
  hp::FEValues<dim> cells(elements, hp::QCollection<dim>(QGauss<dim>(points)),
                          update_values | update_quadrature_points | update_JxW_values);
  hp::FEFaceValues<dim> faces(elements, hp::QCollection<dim - 1>(QGauss<dim - 1>(points)),
                              update_values | update_quadrature_points | update_normal_vectors | update_JxW_values);
  const bool inertial = mms.kind == "inertial";
  Vector rhs = Vector::Zero(compiled.unknowns.size());
  for (const auto& cell : compiled.space.dofs().active_cell_iterators()) {
    const ClosedForms& form = forms_on(compiled, mms, cell);
    cells.reinit(cell);
    const auto& fe = cells.get_present_fe_values();
    const auto volume = [&](unsigned q) {
      const Point2& at = fe.quadrature_point(q);
      Parts parts;
      parts.v = Point2(form("fx", at, t), form("fy", at, t));
      if (inertial) parts.w = Point2(form("hx", at, t), form("hy", at, t));
      parts.s = -form("g", at, t);
      return parts;
    };
    integrate(compiled, cell, fe, volume, rhs);
    for (const unsigned f : cell->face_indices()) {
      if (!cell->at_boundary(f)) continue;
      faces.reinit(cell, f);
      const auto& side = faces.get_present_fe_values();
      const auto surface = [&](unsigned q) {
        return natural(form, side.quadrature_point(q), side.normal_vector(q), t);
      };
      integrate(compiled, cell, side, surface, rhs);
    }
  }
  return rhs;
}

std::vector<SystemLoad> source_loads(const Compiled& compiled, const Manufactured& mms) {
  constexpr double wave = 0.25;  // s: about 2 pi / w, so that the functions are well distinguished
  const auto n = static_cast<Eigen::Index>(mms.time_functions.size());
  Eigen::MatrixXd values(compiled.unknowns.size(), n), functions(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = wave * static_cast<double>(i) / static_cast<double>(n - 1);
    values.col(i) = source(compiled, mms, t);
    for (Eigen::Index j = 0; j < n; ++j) functions(j, i) = mms.time_functions[static_cast<std::size_t>(j)](t);
  }
  const Eigen::MatrixXd parts = values * functions.inverse();
  std::vector<SystemLoad> loads;
  for (Eigen::Index j = 0; j < n; ++j)
    loads.push_back({"source", parts.col(j), TimeFunction({}, {mms.time_functions[static_cast<std::size_t>(j)]})});
  return loads;
}

State exact_state(const Compiled& compiled, const Manufactured& mms, double t) {
  static const char* const names[][3] = {
      {"ux", "ux_t", "ux_tt"}, {"uy", "uy_t", "uy_tt"}, {"Wx", "Wx_t", "Wx_tt"}, {"Wy", "Wy_t", "Wy_tt"}};
  State state = at_rest(compiled.system);
  state.time = t;
  std::vector<types::global_dof_index> dofs;
  for (const auto& cell : compiled.space.dofs().active_cell_iterators()) {
    const auto& fe = cell->get_fe();
    const ClosedForms& form = forms_on(compiled, mms, cell);
    dofs.resize(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    for (unsigned i = 0; i < dofs.size(); ++i) {
      const auto [component, node] = fe.system_to_component_index(i);
      const Point2 unit = fe.base_element(component / dim).unit_support_point(node);
      const Point2 at = compiled.space.mapping().transform_unit_to_real_cell(cell, unit);
      const int k = compiled.unknowns.expansion(static_cast<unsigned>(dofs[i])).front().first;
      const bool phi = component == phi_component;
      state.x[k] = phi ? form.phi(at, t) : form(names[component][0], at, t);
      state.v[k] = form(phi ? "p" : names[component][1], at, t);
      state.a[k] = form(phi ? "p_t" : names[component][2], at, t);
    }
  }
  return state;
}

Problem::Problem(const Manufactured& solution, const Mesh& mesh) : mms(solution), compiled(solution.scene, mesh) {
  compiled.system.loads = source_loads(compiled, mms);
}

State marched(const Problem& problem, double end, int steps, SchemeKind kind) {
  SchemeOptions options;
  options.kind = kind;
  options.account_energy = false;
  const auto scheme = make_scheme(problem.compiled.system, options);
  State state = exact_state(problem.compiled, problem.mms, 0.);
  scheme->start(state);
  for (int i = 0; i < steps; ++i) {
    state.time = end * i / steps;
    scheme->advance(state, end / steps);
  }
  return state;
}

double worse(double a, double b) {
  return std::isnan(a) || a >= b ? a : b;
}

double largest_ratio(const System& system, const Vector& part, const std::vector<Vector>& wholes) {
  double worst = 0.;
  for (const Field field : {Field::displacement, Field::relative_fluid, Field::pressure_impulse}) {
    const auto norm = [&](const Vector& all) {
      double sum = 0.;
      for (int i = 0; i < system.size(); ++i)
        if (system.field[static_cast<std::size_t>(i)] == field) sum += all[i] * all[i];
      return std::sqrt(sum);
    };
    double largest = 0.;
    for (const Vector& whole : wholes) largest = std::max(largest, norm(whole));
    if (largest > 0.) worst = worse(worst, norm(part) / largest);
  }
  return worst;
}

}  // namespace upbead::test
