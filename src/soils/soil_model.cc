#include "soils/soil_model.h"

#include <algorithm>

#include "base/text.h"
#include "case/case_run.h"
#include "dynamics/basis.h"
#include "fem/system_scene.h"
#include "model/equal.h"
#include "model/exclusions.h"
#include "response/reduction.h"
#include "run/derived.h"
#include "run/sliding/slip_ahead.h"
#include "run/soil_member.h"

namespace upbead {

namespace {

/// Largest difference that a sum of parts may have from an assembled System, over rows' sizes: round-off is 1e-14.
constexpr double tolerable_distance = 1e-10;

using OfRegions = std::map<std::string, Coefficients>;

/// Whether its mass and what stands beside its walls are no coefficients of a sum: all soils share the first one's
/// body.
bool is_body(const std::string& name, const Region& region) {
  return name == caisson_name || region.kind == RegionKind::rigid || region.deformation == Deformation::rigid;
}

/// What a region decides by its numbers.
bool same_choices(const Region& a, const Region& b) {
  return a.kind == b.kind && a.conductivity_ratio == b.conductivity_ratio && a.flow == b.flow &&
         a.deformation == b.deformation && a.compressibility == b.compressibility;
}

void add_varied(const OfRegions& one, const OfRegions& other, std::map<std::string, Varied>& varied) {
  for (const auto& [region, values] : one)
    for (std::size_t q = 0; q < values.size(); ++q)
      if (values[q] != other.at(region)[q]) varied[region][q] = true;
}

std::vector<Scene> resolved(const Simulation& first, const std::vector<Scene>& soils) {
  std::vector<Scene> list;
  for (const Scene& given : soils) {
    list.push_back(resolved_on(with_all_cells(given), first.mesh()).scene);
    const std::string why = why_not_of_family(first.scene(), list.back());
    if (!why.empty()) throw InputError(Place(), why, "keep soils apart that are so different, or solve each by itself");
  }
  return list;
}

AffineScene affine_of(const Simulation& first, const std::vector<Scene>& soils, bool with_interface) {
  std::map<std::string, Varied> varied;
  const OfRegions own = coefficients_of(first.scene());
  for (const Scene& soil : soils) add_varied(own, coefficients_of(soil), varied);
  return affine_scene(first.scene(), *first.mesh(), first.absent(), varied, with_interface);
}

/// Throws NumericsError where the sum of a soil is not what is assembled for it.
void require_sum(const AffineScene& affine, const Scene& soil, const Simulation& first, bool slips) {
  const AssembledScene assembled = assemble_scene(soil, *first.mesh(), first.absent(), {}, slips);
  const System summed = affine.at(affine.factors(coefficients_of(soil))).system;
  const double far = distance(slips ? slip_system(*assembled.compiled).system : assembled.compiled->system, summed);
  if (!(far <= tolerable_distance))
    throw NumericsError("the equations of these soils are no sum of parts: they differ by " + significant(far, 2));
}

bool wants_slip(const Simulation& first) {
  return first.given().sliding && why_no_slip(first).empty();
}

}  // namespace

std::map<std::string, Coefficients> coefficients_of(const Scene& resolved) {
  return coefficients(resolved.regions, resolved.fluid, resolved.gravity);
}

double error_of_soils(const Simulation& member) {
  return member.member()->error;
}

Scene with_all_cells(Scene given) {
  given.mesh.full_domain = true;
  return given;
}

Simulation simulation_with_all_cells(const Case& input, const std::shared_ptr<const Mesh>& mesh) {
  return simulation_by(input, mesh, [](Scene scene, const std::shared_ptr<const Mesh>& on) {
    return Simulation(with_all_cells(std::move(scene)), on);
  });
}

std::vector<Diagnostic> why_no_soils(const Simulation& simulation) {
  std::vector<Diagnostic> list;
  for (const Exclusion& reason : excluded(simulation.scene(), Treatment::soil_model))
    list.push_back({at_key(reason.key), reason.why, reason.cure});
  if (!simulation.compiled()->caisson) list.push_back({at_key("mesh"), "there is no caisson, and so no F_T", ""});
  return list;
}

std::string why_not_of_family(const Scene& one, const Scene& other) {
  for (const auto& [name, region] : one.regions) {
    const auto found = other.regions.find(name);
    if (found == other.regions.end()) return "it has no region '" + name + "'";
    if (is_body(name, region) && !(region == found->second)) return "the body '" + name + "' is another";
    if (!same_choices(region, found->second))
      return "numbers of '" + name + "' decide otherwise about its flow, its direction, deformation or compressibility";
  }
  SystemScene a = system_scene(one), b = system_scene(other);
  b.regions = a.regions;
  b.fluid.bulk_modulus = a.fluid.bulk_modulus;
  return a == b ? "" : "it differs in more than the constants of its regions";
}

SoilsMade make_soils(const Simulation& first, const std::vector<Scene>& soils, const SoilModelOptions& options) {
  const std::vector<Scene> scenes = resolved(first, soils);
  const bool slips = wants_slip(first);
  AffineScene affine = affine_of(first, scenes, slips);
  if (slips) affine = with_slip(affine);
  require_sum(affine, scenes.back(), first, slips);
  SoilFamilyOptions making;
  making.candidates.push_back(affine.factors(coefficients_of(first.scene())));
  for (const Scene& soil : scenes) making.candidates.push_back(affine.factors(coefficients_of(soil)));
  making.tolerance = options.tolerance;
  making.of_estimates = options.of_estimates;
  making.most_points = options.most_points;
  making.progress = options.progress;
  SoilFamilyMade made = make_soil_family(first.scene(), affine, *first.compiled(), making);
  SoilsMade out;
  out.points = std::move(made.points);
  out.family.terms = affine.terms;
  out.family.reduced = std::move(made.family.reduced);
  for (const Reading& reading : affine.fixed.system.readings) out.family.names.push_back(reading.name);
  out.family.training = sampled_loads(first.scene(), first.system());
  out.family.phi = std::move(made.family.phi);
  out.family.tolerance = share_of_member * options.tolerance;
  out.family.factors.resize(static_cast<Eigen::Index>(out.points.size()),
                            static_cast<Eigen::Index>(affine.terms.size()));
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    const Factors& factors = making.candidates[static_cast<std::size_t>(out.points[i])];
    out.family.factors.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(factors.data(), static_cast<Eigen::Index>(factors.size()));
  }
  out.family.estimates = std::move(made.estimates);
  return out;
}

SoilModel::SoilModel(const Simulation& first, SoilFamilyFile family) : first_(first), terms_(std::move(family.terms)) {
  const System &own = first.system(), bonded = bonded_names(family);
  const auto same_load = [](const SystemLoad& a, const SystemLoad& b) { return a.name == b.name; };
  const auto same_reading = [](const Reading& a, const Reading& b) { return a.name.text() == b.name.text(); };
  if (!std::equal(own.loads.begin(), own.loads.end(), bonded.loads.begin(), bonded.loads.end(), same_load) ||
      !std::equal(own.readings.begin(), own.readings.end(), bonded.readings.begin(), bonded.readings.end(),
                  same_reading))
    throw InputError(Place(), "the family of soils has other loads or readings than the scene", "make it again");
  family_.like = *first.compiled();
  family_.like.system = without_matrices(family_.like.system);
  if (family.reduced.slips()) family_.slipping = slipping_names(family);
  family_.reduced = std::move(family.reduced);
  phi_ = std::make_shared<const FieldBasis>(of_bonded_members(std::move(family.phi), family_.reduced));
}

Simulation SoilModel::member(const Scene& given) const {
  Simulation::Parts parts = resolved_on(with_all_cells(given), first_.given_mesh());
  for (const Exclusion& reason : excluded(parts.scene, Treatment::soil_model))
    throw InputError(at_key(reason.key), reason.why, "solve it by itself");
  if (const std::string why = why_not_of_family(first_.scene(), parts.scene); !why.empty())
    throw InputError(Place(), why, "solve it by itself");
  parts.space = std::make_shared<const Space>(first_.space()->with(parts.scene));
  parts.unknowns = first_.unknowns();
  parts.compiled = std::make_shared<const CompiledScene>(with_courses(*first_.compiled(), parts.scene));
  const Factors factors = AffineScene{{}, terms_, {}}.factors(coefficients_of(parts.scene));
  SoilMember member{with_courses(family_.at(factors), parts.scene), 0., phi_, {}, std::make_shared<BasisRoom>()};
  member.error = family_error(family_, parts.scene, factors, member.compiled, *member.room);
  if (family_.slipping && parts.scene.sliding) {
    member.slip = family_.slips_at(factors);
    for (std::size_t k = 0; k < member.compiled.system.loads.size(); ++k)
      member.slip->system.loads[k].history = member.compiled.system.loads[k].history;
  }
  parts.member = std::make_shared<const SoilMember>(std::move(member));
  return Simulation(std::move(parts));
}

}  // namespace upbead
