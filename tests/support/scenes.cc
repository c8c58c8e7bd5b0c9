#include "scenes.h"

#include <cmath>

#include "fem/compile.h"
#include "fem/scene_check.h"
#include "response/shear_response.h"

namespace upbead::test {

namespace {

std::unique_ptr<Mesh> shipped_mesh(const std::string& name, const std::map<std::string, double>& parameters) {
  MeshRequest request;
  request.file = std::string(UPBEAD_MESH_DIR) + "/" + name + ".geo";
  request.parameters = parameters;
  return read_mesh(request);
}

Region soil(double G, double nu, double k) {
  Region region;
  region.kind = RegionKind::porous;
  region.shear_modulus = G;
  region.poissons_ratio = nu;
  region.porosity = 0.4;
  region.grain_density = 2650.;
  region.hydraulic_conductivity = k;
  region.damping = Rayleigh{0.05, {1., 10.}};
  return region;
}

}  // namespace

TimeFunction triangle(double peak, double duration, double rise) {
  return piecewise_linear({0., rise > 0. ? rise : 0.5 * duration, duration}, {0., peak, 0.});
}

Region sand() {
  return soil(32.647e6, 0.33, 1e-4);
}
Region rubble() {
  return soil(54.411e6, 0.30, 0.15);
}

Scene column(const Region& soil, const TimeFunction& top_pressure) {
  Scene scene;
  scene.regions["soil"] = soil;
  scene.boundaries["base"] = {DisplacementCondition::fixed, PressureCondition::sealed};
  scene.boundaries["left"] = {DisplacementCondition::roller, PressureCondition::sealed};
  scene.boundaries["right"] = {DisplacementCondition::roller, PressureCondition::sealed};
  scene.boundaries["top"] = {DisplacementCondition::free, PressureCondition::open};
  Load load;
  load.boundary = "top";
  load.kind = LoadKind::traction;
  load.direction = {0., -1.};
  load.history = top_pressure;
  scene.loads["top"] = load;
  return scene;
}

std::unique_ptr<Mesh> column_mesh(double height, int cells, double grading) {
  return shipped_mesh("column", {{"height", height}, {"width", 1.}, {"cells", cells}, {"grading", grading}});
}

Scene breakwater(const TimeFunction& force) {
  Scene scene;
  scene.regions["seabed"] = sand();
  scene.regions["mound"] = rubble();
  Region caisson;
  caisson.kind = RegionKind::rigid;
  caisson.density = 2100.;
  scene.regions["caisson"] = caisson;
  scene.boundaries["base"] = {DisplacementCondition::fixed, PressureCondition::sealed};
  for (const char* side : {"left", "right"})
    scene.boundaries[side] = {DisplacementCondition::roller, PressureCondition::sealed};
  for (const char* side : {"bed", "mound_surface"})
    scene.boundaries[side] = {DisplacementCondition::free, PressureCondition::open};
  for (const char* side : {"front", "back", "top"}) scene.boundaries[side] = {};
  Load load;
  load.boundary = "front";
  load.history = force;
  scene.loads["impulse"] = load;
  return scene;
}

void add_sea(Scene& breakwater) {
  for (const char* region : {"sea_front", "sea_back"}) breakwater.regions[region].kind = RegionKind::water;
  breakwater.boundaries["sea_surface"].pressure = PressureCondition::open;
  for (const char* side : {"sea_left", "sea_right"}) breakwater.boundaries[side].pressure = PressureCondition::sealed;
}

std::unique_ptr<Mesh> breakwater_mesh(double cells, std::map<std::string, double> parameters) {
  parameters["cells"] = cells;
  return shipped_mesh("composite", parameters);
}

std::map<std::string, double> with_sea() {
  return {{"sea_front", 3.}, {"sea_back", 3.}};
}

/// The scene on the full domain, as tests march to other ends than the scene's, or not at all.
static Scene whole(Scene scene) {
  scene.mesh.full_domain = true;
  return scene;
}

struct Compiled::Parts {
  explicit Parts(AssembledScene made)
      : space(std::move(made.space)), unknowns(std::move(made.unknowns)), scene(*made.compiled) {}
  std::shared_ptr<const Space> space;
  std::shared_ptr<const Unknowns> unknowns;
  CompiledScene scene;
};

Compiled::Compiled(const Scene& input, const Mesh& mesh, bool interface)
    : Compiled(resolve(whole(input), mesh), mesh, interface) {}

Compiled::Compiled(const ResolvedScene& input, const Mesh& mesh, bool interface)
    : resolved(input.scene),
      parts(std::make_shared<Parts>(assemble_scene(resolved, mesh, input.absent, input.soil, interface))),
      space(*parts->space),
      unknowns(*parts->unknowns),
      scene(parts->scene),
      system(scene.system),
      loads_on_caisson(scene.loads_on_caisson) {}

Response run(const Compiled& compiled, double end, double step, SchemeKind kind) {
  SchemeOptions options;
  options.kind = kind;
  const auto scheme = make_scheme(compiled.system, options);
  return march(compiled.system, *scheme, make_time_grid(kinks(compiled.system), end, step));
}

ShearResponse shear_of(const Compiled& compiled, const Response& response) {
  return read_shear_response(compiled.scene, response, compiled.resolved.time.inertia);
}

std::vector<Diagnostic> mistakes(const Scene& scene, const Mesh& mesh) {
  return check_scene(scene, mesh).list();
}

Eigen::RowVectorXd history(const Compiled& compiled, const Response& response, const std::string& reading) {
  return response.ends.reading.row(compiled.system.reading(reading));
}

}  // namespace upbead::test
