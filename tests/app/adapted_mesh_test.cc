// Claims: mesh.refine = "auto" makes a mesh whose estimate meets the tolerance, of degree 3 where no degree is given; a
// march says what its steps cost; the far sides of a narrow section are felt more than those of a wide one; a symmetric
// scene gets a symmetric mesh; what cannot be measured is refused at its key.

#include <cmath>

#include "good_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/app/pipeline.h"
#include "upbead/base/error.h"

namespace upbead::test {
namespace {

const std::string breakwater_toml = R"(
[mesh]
geometry = "composite"
refine = "auto"
[regions.seabed]
kind = "porous"
shear_modulus = 30e6
poissons_ratio = 0.33
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 1e-4
flow = "drained"
[regions.mound]
kind = "porous"
shear_modulus = 50e6
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 0.15
flow = "drained"
[regions.caisson]
kind = "rigid"
density = 2100.0
[boundaries]
base = { displacement = "fixed" }
left = { displacement = "roller" }
right = { displacement = "roller" }
bed = {}
mound_surface = {}
front = {}
back = {}
top = {}
[loads.impulse]
boundary = "front"
kind = "force"
pulse = { shape = "triangle", peak = 1e6, duration = 0.15 }
[time]
end = 0.4
[accuracy]
tolerance = 0.01
)";

class AdaptedMesh : public InFolder {
 protected:
  AdaptedMesh() { unsetenv("UPBEAD_MESHES"); }
  static Case with(const std::vector<std::string>& overrides) {
    static const PetscSession petsc;  // MPI starts once in a process
    write("case.toml", breakwater_toml);
    return read_case("case.toml", overrides);
  }
  static upbead::Run solve(const std::vector<std::string>& overrides) {
    const Case input = with(overrides);
    CompiledCase scene = compile_case(input);
    return run_case(input, scene, {});
  }
};

TEST_F(AdaptedMesh, MeetsTheTolerance) {
  double unknowns = 0.;
  for (const double tolerance : {0.02, 0.005}) {
    const Summary summary = solve({"accuracy.tolerance=" + std::to_string(tolerance)}).summary;
    ASSERT_TRUE(summary.error.has_value());
    EXPECT_GT(summary.error->mesh, 0.);
    EXPECT_LE(summary.error->total(), tolerance);
    EXPECT_EQ(summary.discretisation.degree, 3);
    EXPECT_GT(summary.discretisation.unknowns, unknowns);
    unknowns = summary.discretisation.unknowns;
  }
}

TEST_F(AdaptedMesh, AMarchTellsWhatItsStepsCost) {
  const double fine = solve({"time.scheme=sdirk4", "time.step=0.005"}).summary.error->time,
               wide = solve({"time.scheme=sdirk4", "time.step=0.02"}).summary.error->time;
  EXPECT_GT(fine, 0.);
  EXPECT_GT(wide, 3. * fine);  // steps four times as long
  EXPECT_EQ(solve({"time.scheme=reduced"}).summary.error->time, 0.);
}

TEST_F(AdaptedMesh, NarrowSectionsFeelTheirFarSides) {
  const std::vector<std::string> narrow{"mesh.parameters.seabed_front=12", "mesh.parameters.seabed_back=12"};
  const double of_narrow = solve(narrow).summary.error->far_boundary, of_wide = solve({}).summary.error->far_boundary;
  EXPECT_GT(of_narrow, 2e-3);
  EXPECT_LT(of_wide, 1e-3);
}

TEST_F(AdaptedMesh, IsSymmetricWhereTheSceneIs) {
  const CompiledCase scene = compile_case(with({}));
  const auto& cells = scene.mesh->triangulation;
  int n_alone = 0, n_levels = 0;
  for (const auto& cell : cells.active_cell_iterators()) {
    bool found = false;
    for (const auto& other : cells.active_cell_iterators())
      found =
          found || std::hypot(cell->center()[0] + other->center()[0], cell->center()[1] - other->center()[1]) < 1e-6;
    n_alone += found ? 0 : 1;
    n_levels = std::max(n_levels, cell->level());
  }
  EXPECT_EQ(n_alone, 0);
  EXPECT_GE(n_levels, 1);
}

TEST_F(AdaptedMesh, RefusesWhatCannotBeMeasured) {
  const auto message = [&](const std::vector<std::string>& overrides) -> std::string {
    try {
      compile_case(with(overrides));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message({"time.inertia=false"}).find("refine = \"auto\": time.inertia = false leaves nothing dynamic"),
            std::string::npos);
}

}  // namespace
}  // namespace upbead::test
