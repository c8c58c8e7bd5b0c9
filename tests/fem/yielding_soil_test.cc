// Claims: the internal force of yielding soil is, with a law of half the stiffness, half of K x; it is zero below
// yield; a breakwater on soil that yields answers a small force as elastic soil does, and a large one with less F_T,
// a residual displacement and energy lost. Lanes give the numbers of single points, to the last bit with any number
// of threads.

#include "fem/yielding_soil.h"

#include <deal.II/base/quadrature_lib.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "dynamics/yielding.h"
#include "material/hysteretic_law.h"
#include "material/mohr_coulomb_law.h"
#include "scenes.h"
#include "upbead/dynamics/march.h"

namespace upbead::test {
namespace yielding_soil_test {

/// By active cell index; null for cells that stay elastic.
using CellLaws = std::vector<std::shared_ptr<const HystereticLaw>>;

PointsOfCells points_of(const CellLaws& laws) {
  std::vector<PointMaker> makers;
  for (const auto& law : laws) makers.push_back(law ? hysteretic_points(law) : [](unsigned) { return nullptr; });
  return [makers](unsigned cell, unsigned point) { return makers[cell](point); };
}

std::unique_ptr<YieldingSoil> yielding(const Compiled& compiled, const PointsOfCells& points,
                                       const SoilWork& work = {}) {
  return yielding_soil(compiled.space, compiled.unknowns, compiled.system.readings, points, work);
}

std::unique_ptr<YieldingSoil> yielding(const Compiled& compiled, const CellLaws& laws, const SoilWork& work = {}) {
  return yielding(compiled, points_of(laws), work);
}

constexpr double gamma_r = 5e-4;

/// A law for every cell that deforms and is no water.
CellLaws laws(const Space& space, double strain) {
  CellLaws found;
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    const ElasticLaw& law = space.material(cell);
    const bool yields = space.has_matrices(cell) && space.kind(cell) != CellKind::water;
    found.push_back(yields ? std::make_shared<HystereticLaw>(
                                 law, backbone(
                                          law.G, [=](double gamma) { return 1. / (1. + gamma / strain); },
                                          1e-2 * strain, 30. * strain, 10))
                           : nullptr);
  }
  return found;
}

Vector full(const std::vector<int>& rows, const Vector& p, int n) {
  Vector out = Vector::Zero(n);
  for (std::size_t i = 0; i < rows.size(); ++i) out[rows[i]] = p[static_cast<Eigen::Index>(i)];
  return out;
}

/// Elastic soil of half the stiffness D.
class HalfElastic : public SoilPoint {
 public:
  explicit HalfElastic(const ElasticLaw& D) : half_{0.5 * D.G, 0.5 * D.lambda} {}
  void correct(const PlaneStrain& e, PlaneStress& correction) const override { correction = half_.stress(e); }
  void commit(const PlaneStrain&, double&) override {}
  void stored_beside_elastic(const PlaneStrain& e, double& energy) const override {
    const PlaneStress s = half_.stress(e);
    energy = -0.5 * (s.xx * e.xx + s.yy * e.yy) - s.xy * e.xy;
  }
  double mobilised(int, const PlaneStress&) const override { return 0.; }

 private:
  ElasticLaw half_;
};

TEST(YieldingSoil, LawOfHalfTheStiffnessTakesHalfOfK) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1., 0.1)), *mesh);
  const System& system = compiled.system;
  const CellLaws all = laws(compiled.space, 1e6);
  const PointsOfCells halves = [&](unsigned cell, unsigned) {
    return all[cell] ? std::make_unique<HalfElastic>(all[cell]->elastic()) : nullptr;
  };
  const auto soil = yielding(compiled, halves);
  const Vector x = 1e-3 * Vector::Random(system.size());
  Vector p, again;
  soil->evaluate(x, p);
  const Vector Kx = system.K * x;
  EXPECT_LT((full(soil->rows(), p, system.size()) - 0.5 * Kx).norm(), 1e-12 * Kx.norm());
  EXPECT_EQ(soil->commit(x), 0.);
  soil->evaluate(x, again);
  EXPECT_LT((again - p).norm(), 1e-14 * p.norm());
  EXPECT_NEAR(soil->stored_beside_elastic(), -0.25 * x.dot(Kx), 1e-12 * x.dot(Kx));
}

TEST(YieldingSoil, WhatIsNotCommittedIsForgotten) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1., 0.1)), *mesh);
  const auto soil = yielding(compiled, laws(compiled.space, gamma_r));
  const Vector x = 1e-3 * Vector::Random(compiled.system.size()), rest = 0. * x;
  Vector first, second, p;
  soil->evaluate(1e-9 * x, p);
  EXPECT_EQ(p.norm(), 0.) << "below yield";
  soil->evaluate(x, first);
  soil->evaluate(3. * x, p);
  soil->evaluate(x, second);
  EXPECT_EQ(first, second);
  soil->evaluate(rest, p);
  EXPECT_EQ(p.norm(), 0.);
  EXPECT_GT(soil->commit(x), 0.);
  soil->evaluate(rest, p);
  EXPECT_GT(p.norm(), 0.) << "what yielded stays";
}

TEST(YieldingSoil, LanesAndThreadsGiveWhatPointsDo) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1., 0.1)), *mesh);
  const CellLaws of_cells = laws(compiled.space, gamma_r);
  SoilWork by_points, by_one, by_three;
  by_points.by_points = true;
  by_one.threads = 1;
  by_three.threads = 3;
  const auto points = yielding(compiled, of_cells, by_points), one = yielding(compiled, of_cells, by_one),
             three = yielding(compiled, of_cells, by_three);
  Vector p, q, r;
  for (int step = 0; step < 5; ++step) {
    const Vector x = 1e-3 * Vector::Random(compiled.system.size());
    points->evaluate(x, p);
    one->evaluate(x, q);
    three->evaluate(x, r);
    EXPECT_LT((q - p).norm(), 1e-12 * p.norm());
    EXPECT_EQ(q, r);
    const double lost = points->commit(x), lost_in_lanes = one->commit(x);
    EXPECT_NEAR(lost_in_lanes, lost, 1e-12 * lost);
    EXPECT_EQ(three->commit(x), lost_in_lanes);
    EXPECT_NEAR(one->exerted(), points->exerted(), 1e-12 * points->exerted());
    EXPECT_NEAR(one->stored_beside_elastic(), points->stored_beside_elastic(),
                1e-11 * std::abs(points->stored_beside_elastic()));
    EXPECT_LT((one->added_to_readings() - points->added_to_readings()).norm(),
              1e-12 * points->added_to_readings().norm());
    const auto borne_by_points = points->borne(), borne_in_lanes = one->borne();
    for (const unsigned cell : {0u, 20u, 50u}) {
      const std::vector<BorneStress>&a = borne_by_points[cell], &b = borne_in_lanes[cell];
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i].change.xy, b[i].change.xy, 1e-10 * std::abs(a[i].change.xy));
        EXPECT_NEAR(a[i].change.zz, b[i].change.zz, 1e-10 * std::abs(a[i].change.zz));
        EXPECT_NEAR(a[i].mobilised, b[i].mobilised, 1e-10);
        EXPECT_EQ(a[i].at.distance(b[i].at), 0.);
      }
    }
  }
}

/// Strains grow, change direction and shrink; about each step, displacements that differ a little are tried.
TEST(YieldingSoil, CellsThatCannotYieldAreLeftOutWithoutATrace) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1., 0.1)), *mesh);
  const CellLaws of_cells = laws(compiled.space, gamma_r);
  SoilWork whole;
  whole.skip = false;
  const auto left_out = yielding(compiled, of_cells), all = yielding(compiled, of_cells, whole);
  const Vector shape = Vector::Random(compiled.system.size());
  Vector p, q;
  for (int step = 0; step < 12; ++step) {
    const Vector x = 1e-4 * std::sin(step) * shape;
    for (const double more : {0., 1e-9, 1e-7, 1e-5, 1e-4}) {
      const Vector tried = x + more * Vector::Random(x.size());
      left_out->evaluate(tried, p);
      all->evaluate(tried, q);
      EXPECT_EQ(p, q) << step << " " << more;
    }
    EXPECT_EQ(left_out->commit(x), all->commit(x));
  }
  EXPECT_GT(left_out->share_skipped(), 0.01);
  EXPECT_LT(left_out->share_skipped(), 0.95);
  EXPECT_EQ(all->share_skipped(), 0.);
}

TEST(YieldingSoil, MohrCoulombCellsFarFromYieldAreLeftOutWithoutATrace) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(1., 0.1)), *mesh);
  const Space& space = compiled.space;
  std::vector<PointMaker> of_cells;
  for (const Cell& cell : space.dofs().active_cell_iterators()) {
    const double p = 1e3 * (1 + cell->active_cell_index() % 100);  // stress at rest from low to high
    of_cells.emplace_back([](unsigned) { return nullptr; });
    if (space.has_matrices(cell) && space.kind(cell) != CellKind::water)
      of_cells.back() = mohr_coulomb_points(
          std::make_shared<MohrCoulombLaw>(space.material(cell), MohrCoulombStrength{35., 5e3, 5., 0.}),
          {{-0.5 * p, -p, 0., -0.5 * p}});
  }
  const PointsOfCells points = [&](unsigned cell, unsigned point) { return of_cells[cell](point); };
  const auto make = [&](const SoilWork& work) {
    return yielding_soil(space, compiled.unknowns, compiled.system.readings, points, work);
  };
  SoilWork whole, by_points;
  whole.skip = false;
  by_points.by_points = true;
  const auto left_out = make({}), all = make(whole), reference = make(by_points);
  const Vector shape = Vector::Random(compiled.system.size());
  Vector p, q, r;
  for (int step = 0; step < 8; ++step) {
    const Vector x = 3e-4 * std::sin(step) * shape;
    for (const double more : {0., 1e-7, 1e-5, 1e-4}) {
      const Vector tried = x + more * Vector::Random(x.size());
      left_out->evaluate(tried, p);
      all->evaluate(tried, q);
      reference->evaluate(tried, r);
      EXPECT_LT((p - q).norm(), 1e-13 * q.norm() + 1e-300);
      EXPECT_LT((p - r).norm(), 1e-9 * r.norm() + 1e-6);  // by single points, round-off of the stresses at rest remains
    }
    const double lost = all->commit(x);
    EXPECT_NEAR(left_out->commit(x), lost, 1e-12 * lost);
    EXPECT_NEAR(reference->commit(x), lost, 1e-8 * lost);
  }
  EXPECT_GT(left_out->share_skipped(), 0.02);
}

TEST(YieldingSoil, GoesOnFromACheckpointToTheLastBit) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(3e6, 0.15)), *mesh);
  const System& system = compiled.system;
  const CellLaws of_cells = laws(compiled.space, gamma_r);
  for (const bool by_points : {false, true}) {
    SoilWork work;
    work.by_points = by_points;
    const auto marched = [&](const MarchOptions& options) {
      const auto soil = yielding(compiled, of_cells, work);
      const auto scheme = make_yielding_scheme(system, *soil);
      const Response response = march(system, *scheme, make_time_grid(kinks(system), 0.15, 0.015), options);
      return std::make_pair(response, soil->dissipated());
    };
    std::vector<MarchCheckpoint> all;
    MarchOptions keeps;
    keeps.checkpoints.due = [] { return true; };
    keeps.checkpoints.keep = [&](const MarchCheckpoint& checkpoint) { all.push_back(checkpoint); };
    const auto whole = marched(keeps);
    ASSERT_EQ(all.size(), 10u);
    for (const std::size_t i : {0u, 4u, 8u}) {
      MarchOptions resumes;
      resumes.checkpoints.resume_from = std::make_shared<const MarchCheckpoint>(all[i]);
      const auto again = marched(resumes);
      EXPECT_EQ(again.first.ends.reading, whole.first.ends.reading);
      EXPECT_EQ(again.first.final_state.a, whole.first.final_state.a);
      EXPECT_EQ(again.first.energy.back().plastic, whole.first.energy.back().plastic);
      EXPECT_EQ(again.first.energy.back().scheme, whole.first.energy.back().scheme);
      EXPECT_EQ(again.first.n_solves, whole.first.n_solves);
      EXPECT_EQ(again.second, whole.second);
    }
    EXPECT_GT(whole.first.energy.back().plastic, 0.);
  }
}

struct Answer {
  double shear = 0., displacement = 0.;  // largest F_T/P; mean after the pulse (m/N)
  double routes = 0.;                    // largest difference of the two routes to F_T, over the largest F_T
  EnergyAccount energy;
  YieldingReport report;
};

Answer answer(double force, double strain) {
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(breakwater(triangle(force, 0.15)), *mesh);
  const System& system = compiled.system;
  const auto soil = yielding(compiled, laws(compiled.space, strain));
  const auto scheme = make_yielding_scheme(system, *soil, {1e-9, false});
  const Response response = march(system, *scheme, make_time_grid(kinks(system), 1.5, 0.0075));
  const auto row = [&](const char* name) { return response.balanced.reading.row(system.reading(name)).eval(); };
  const auto shear = row("shear_force"), other = row("shear_force_by_inertia"), moved = row("caisson/displacement_x");
  Answer found;
  found.shear = shear.maxCoeff() / force;
  found.displacement = moved.tail(moved.size() / 2).mean() / force;
  found.routes = (shear - other).cwiseAbs().maxCoeff() / shear.maxCoeff();
  found.energy = response.energy.back();
  found.report = *scheme->yielding();
  return found;
}

TEST(YieldingSoil, BreakwaterIsElasticUnderLittleAndYieldsUnderMuch) {
  const Answer elastic = answer(1e6, 1e6), small = answer(1., gamma_r), large = answer(3e6, gamma_r);
  EXPECT_EQ(small.report.evaluations, small.report.stages);
  EXPECT_NEAR(small.shear, elastic.shear, 1e-6 * elastic.shear);
  EXPECT_LT(large.shear, 0.97 * elastic.shear);
  EXPECT_GT(large.displacement, 3. * std::abs(elastic.displacement)) << "residual";
  EXPECT_GT(large.energy.plastic, 0.05 * large.energy.largest_work);
  for (const Answer& a : {elastic, small, large}) {
    EXPECT_LT(a.routes, 1e-7) << "both routes to F_T: the ground's nodal forces and the caisson's inertia";
    EXPECT_LT(a.energy.mismatch(), 1e-8);
  }
  EXPECT_LT(std::abs(large.energy.scheme), 0.02 * large.energy.largest_work);
}

/// A probe at a quadrature point reads the stress of that point, and both are the stress of the law for the probe's
/// strains.
TEST(YieldingSoil, ProbesAndPointsTellTheStressOfTheLaw) {
  const auto mesh = breakwater_mesh(0.5);
  Scene scene = breakwater(triangle(3e6, 0.15));
  const Compiled before(scene, *mesh);
  const CellLaws all = laws(before.space, gamma_r);
  unsigned cell = 0;
  for (const Cell& c : before.space.dofs().active_cell_iterators())
    if (all[c->active_cell_index()] && c->point_inside({0.3, 4.7})) cell = c->active_cell_index();
  const PointsOfCells points = points_of(all);
  const dealii::Point<dim> at =
      yielding_soil(before.space, before.unknowns, before.system.readings, points)->borne()[cell].at(4).at;
  scene.regions["seabed"].law = scene.regions["mound"].law = SoilLaw::hysteretic;  // the probe then follows the law
  scene.probes["inside"].at = {at[0], at[1]};
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  SoilWork work;
  work.followed = followed_readings(compiled.space, compiled.resolved);
  const auto soil = yielding_soil(compiled.space, compiled.unknowns, system.readings, points, work);
  const auto scheme = make_yielding_scheme(system, *soil);
  const Response response = march(system, *scheme, make_time_grid(kinks(system), 0.5, 0.0075));
  const auto row = [&](const std::string& what) { return history(compiled, response, "probes/inside/" + what); };
  const auto xx = row("strain_xx"), yy = row("strain_yy"), xy = row("strain_xy");
  const auto alone = points(cell, 4);
  double largest = 0., mobilised = 0., lost = 0.;
  for (Eigen::Index i = 0; i < xx.size(); ++i) {
    const PlaneStrain strain{xx[i], yy[i], xy[i]};
    PlaneStress correction;
    alone->correct(strain, correction);
    alone->commit(strain, lost);
    const PlaneStress s = difference(all[cell]->elastic().stress(strain), correction);
    largest = std::max(largest, std::abs(s.xy));
    mobilised = all[cell]->mobilised(s);
    EXPECT_NEAR(row("effective_stress_xx")[i], s.xx, 1e-9 * largest + 1e-6);
    EXPECT_NEAR(row("effective_stress_xy")[i], s.xy, 1e-9 * largest + 1e-6);
    EXPECT_NEAR(row("effective_stress_zz")[i], s.zz, 1e-9 * largest + 1e-6);
  }
  const BorneStress found = soil->borne()[cell].at(4);
  EXPECT_NEAR(found.change.xx, row("effective_stress_xx").tail(1)[0], 1e-9 * largest);
  EXPECT_NEAR(found.change.xy, row("effective_stress_xy").tail(1)[0], 1e-9 * largest);
  EXPECT_NEAR(found.mobilised, mobilised, 1e-9);
  EXPECT_GT(soil->dissipated()[cell], 0.);
}

/// A biquadratic polynomial through nine values at points of the unit cell, at another point of it.
double through(const std::vector<dealii::Point<dim>>& points, const std::vector<double>& values,
               const dealii::Point<dim>& at) {
  const auto row = [](const dealii::Point<dim>& p) {
    Eigen::RowVectorXd monomials(9);
    for (int k = 0; k < 9; ++k) monomials[k] = std::pow(p[0], k % 3) * std::pow(p[1], k / 3);
    return monomials;
  };
  Eigen::MatrixXd V(9, 9);
  for (int q = 0; q < 9; ++q) V.row(q) = row(points[static_cast<std::size_t>(q)]);
  return row(at) * V.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(values.data(), 9));
}

/// A probe anywhere in a cell reads what the stresses of its nine points make there; of soil that stays elastic the
/// elastic stress, and not that of the nearest point.
TEST(YieldingSoil, AProbeBetweenThePointsReadsTheirPolynomial) {
  const auto mesh = breakwater_mesh(0.5);
  Scene scene = breakwater(triangle(3e6, 0.15));
  scene.regions["seabed"].law = scene.regions["mound"].law = SoilLaw::hysteretic;
  scene.probes["off"].at = {0.31, 4.73};
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  const std::vector<FollowedReading> read = followed_readings(compiled.space, compiled.resolved);
  const auto points_of_cell = dealii::QGauss<dim>(3).get_points();
  for (const double strain : {1e6, gamma_r}) {
    const CellLaws all = laws(compiled.space, strain);
    const PointsOfCells points = points_of(all);
    SoilWork work;
    work.followed = read;
    const auto soil = yielding_soil(compiled.space, compiled.unknowns, system.readings, points, work);
    const auto scheme = make_yielding_scheme(system, *soil);
    const Response response = march(system, *scheme, make_time_grid(kinks(system), 0.3, 0.0075));
    const auto last = [&](const std::string& what) {
      return history(compiled, response, "probes/off/" + what).tail(1)[0];
    };
    const std::vector<BorneStress> borne = soil->borne()[read.front().cell->active_cell_index()];
    std::vector<double> xx;
    for (const BorneStress& point : borne) xx.push_back(point.change.xx);
    const double told = last("effective_stress_xx"), scale = std::abs(told);
    EXPECT_NEAR(told, through(points_of_cell, xx, read.front().unit), 1e-8 * scale) << strain;
    if (strain < 1.) continue;
    const HystereticLaw& law = *all[read.front().cell->active_cell_index()];  // straight at so small a strain
    const double elastic = law.elastic().stress({last("strain_xx"), last("strain_yy"), last("strain_xy")}).xx;
    EXPECT_NEAR(told, elastic, 1e-6 * scale);
    double near = infinity, other = 0.;
    for (std::size_t q = 0; q < 9; ++q)
      if (const double d = points_of_cell[q].distance(read.front().unit); d < near) {
        near = d;
        other = xx[q];
      }
    EXPECT_GT(std::abs(other - elastic), 1e-3 * scale) << "so that it makes a difference";
  }
}

/// An independent computation of a column under pressure at its top: linear elements, lumped masses, explicit steps,
/// one strain. Under eps_yy alone the deviator is eps (-1/3, 2/3, -1/3): s_yy = 4/3 h (eps - eps_p), which slides at
/// 2/sqrt(3) y.
class ExplicitColumn {
 public:
  ExplicitColumn(const Material& soil, const HystereticLaw& law, double height, int n)
      : bulk_(soil.lambda + 2. / 3. * soil.G), size_(height / n), mass_(soil.rho * size_), parts_(law.elements()) {
    x_ = v_ = Vector::Zero(n);
    slid_.assign(static_cast<std::size_t>(n), std::vector<double>(parts_.size(), 0.));
  }
  /// Displacement of the top after that time.
  double top_after(double end, int n_steps, const TimeFunction& pressure) {
    const double h = end / n_steps;
    const auto n = x_.size();
    for (int step = 0; step < n_steps; ++step) {
      Vector force = Vector::Zero(n);
      force[n - 1] = -pressure(step * h, (step + 0.5) * h);
      for (Eigen::Index i = 0; i < n; ++i) {
        const double s = stress(static_cast<std::size_t>(i), (x_[i] - (i > 0 ? x_[i - 1] : 0.)) / size_);
        force[i] -= s;
        if (i > 0) force[i - 1] += s;
      }
      force[n - 1] *= 2.;  // the top has half a lumped mass
      v_ += (step == 0 ? 0.5 : 1.) * h / mass_ * force;
      x_ += h * v_;
    }
    return x_[n - 1];
  }

 private:
  double stress(std::size_t i, double strain) {
    double sum = bulk_ * strain;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const double stiffness = 4. / 3. * parts_[k].h, most = 2. / std::sqrt(3.) * parts_[k].y;
      const double trial = stiffness * (strain - slid_[i][k]), held = std::clamp(trial, -most, most);
      slid_[i][k] += (trial - held) / stiffness;
      sum += held;
    }
    return sum;
  }

  double bulk_, size_, mass_;
  std::vector<HystereticLaw::Element> parts_;
  Vector x_, v_;
  std::vector<std::vector<double>> slid_;
};

TEST(YieldingSoil, ColumnUnderAStrongWaveIsThatOfAProgramInOneDimension) {
  const double height = 20., end = 0.3;
  const TimeFunction pressure = triangle(200e3, 0.1);
  Region soil = sand();
  soil.flow = Flow::drained;
  soil.damping.reset();
  Scene scene = column(soil, pressure);
  scene.probes["top"].at = {0.5, height};
  const auto mesh = column_mesh(height, 40);
  const Compiled compiled(scene, *mesh);
  const System& system = compiled.system;
  const CellLaws all = laws(compiled.space, gamma_r);
  const Cell cell = compiled.space.dofs().begin_active();
  const Reading& top = system.readings[static_cast<std::size_t>(system.reading("probes/top/displacement_y"))];
  std::vector<double> error;
  const double exact =
      ExplicitColumn(compiled.space.material(cell), *all[0], height, 800).top_after(end, 24000, pressure);
  for (const int n : {150, 300, 600}) {
    const auto force = yielding(compiled, all);
    const auto scheme = make_yielding_scheme(system, *force);
    State state = at_rest(system);
    scheme->start(state);
    for (int i = 0; i < n; ++i) scheme->advance(state, end / n);
    error.push_back(std::abs(evaluate(top, state, scheme->end_load()) / exact - 1.));
    EXPECT_LT(scheme->energy().mismatch(), 1e-5);  // the solves' tolerance is 1e-6
    EXPECT_GT(scheme->energy().plastic, 0.1 * scheme->energy().largest_work);
  }
  EXPECT_LT(error.back(), 1e-4);
  EXPECT_LT(error.back(), 0.1 * error.front());
}

}  // namespace yielding_soil_test
}  // namespace upbead::test
