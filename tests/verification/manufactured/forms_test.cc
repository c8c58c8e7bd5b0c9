// Claim: the tests use the data of the manufactured solutions as written: closed forms, constants of the equations,
// and sources split into functions of space times functions of time.
//
// Sources: tests/reference/ref8_mms.json and mms_inertial.json with their samples, which agree with a numerical
// differentiation of the exact fields.
//
// Limits: 1e-11 for the samples (ref8 has twelve digits), else round-off.

#include <gtest/gtest.h>

#include <cmath>

#include "meshes.h"
#include "record.h"
#include "sources.h"

namespace upbead::test {
namespace forms_test {

struct Solution {
  std::string file, kind;
  std::size_t set;
};

const std::vector<Solution> darcy{{"ref8_mms", "trig", 0},      {"ref8_mms", "trig", 1},      {"ref8_mms", "trig", 2},
                                  {"ref8_mms", "two-layer", 0}, {"ref8_mms", "time-only", 0}, {"ref8_mms", "patch", 0}};
const std::vector<Solution> inertial{{"mms_inertial", "inertial", 0}, {"mms_inertial", "inertial", 1}};

/// Largest difference between closed forms and samples, each over the largest sample of its kind.
double sample_error(const Manufactured& mms, std::size_t set) {
  std::map<std::string, std::vector<double>> computed, tabulated;
  for (const Json& sample : mms.entry.at("sets").at(set).at("samples")) {
    const dealii::Point<dim> at(sample.at("x"), sample.at("y"));
    const ClosedForms& form = *mms.layers.at(mms.surface_at(at));
    const double t = sample.at("t");
    for (const auto& [name, expression] : mms.entry.at("expressions").items()) {
      computed[name].push_back(name == "phi" ? form.phi(at, t) : form(name, at, t));
      tabulated[name].push_back(sample.at(name));
    }
  }
  double worst = 0.;
  for (const auto& [name, values] : tabulated) worst = worse(worst, largest_error(computed.at(name), values));
  return worst;
}

/// Largest relative difference between what the kernels multiply with and the constants of the table.
double constants_error(const Manufactured& mms, std::size_t set) {
  const Json& parameters = mms.entry.at("sets").at(set).at("parameters");
  std::size_t layer = 0;
  double worst = 0.;
  for (const auto& [surface, region] : mms.scene.regions) {  // "lower layer" comes first
    const Json& given = parameters.is_array() ? parameters.at(layer++) : parameters;
    const Material m = material(region, mms.scene.fluid, mms.scene.gravity);
    std::map<std::string, double> used{
        {"lam", m.lambda}, {"mu", m.G},         {"rho", m.rho},         {"rho_f", m.rho_f},         {"alpha", m.alpha},
        {"iM", m.storage}, {"kappa", 1. / m.b}, {"aM", m.mass_damping}, {"bK", m.stiffness_damping}};
    if (mms.kind == "inertial") used["m"] = m.a;
    for (const auto& [name, value] : used) {
      const double exact = given.at(name);
      worst = worse(worst, exact == 0. ? std::abs(value) : std::abs(value / exact - 1.));
    }
  }
  return worst;
}

/// |F(t) - sum of the loads| / |F(t)|, the largest over u, W and phi, at a time that was not used to split the
/// sources.
double split_error(const Manufactured& mms) {
  const auto mesh = quadrilaterals(mms, Quads::perturbed, 2.5);
  const Problem problem(mms, *mesh);
  const double t = 0.0777;
  const Vector exact = source(problem.compiled, mms, t);
  Vector sum = Vector::Zero(exact.size());
  for (const SystemLoad& load : problem.compiled.system.loads) sum += load.history(t) * load.vector;
  return largest_ratio(problem.compiled.system, sum - exact, {exact});
}

void check(const std::string& problem, const std::vector<Solution>& solutions) {
  Record record(problem);
  double samples = 0., constants = 0., split = 0.;
  for (const auto& [file, kind, set] : solutions) {
    const Manufactured mms = manufactured(file, kind, set, 2);
    samples = worse(samples, sample_error(mms, set));
    constants = worse(constants, constants_error(mms, set));
    split = worse(split, split_error(mms));
  }
  record.at_most("closed forms as evaluated here against the tabulated samples, over the largest", samples, 1e-11);
  record.at_most("constants of the compiled equations against those of the tables, relative", constants, 1e-12);
  record.at_most("sources split into functions of space and of time, at a further time, relative", split, 1e-12);
}

TEST(ManufacturedForms, Darcy) {
  check("manufactured_darcy", darcy);
}

TEST(ManufacturedForms, Inertial) {
  check("manufactured_inertial", inertial);
}

}  // namespace forms_test
}  // namespace upbead::test
