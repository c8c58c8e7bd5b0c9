// Claim: on mound and bed a load by a wave presses, where that is asked for, as the user could write it, and no uplift
// counts twice.
#include <cmath>

#include "base/numbers.h"
#include "case/wave_load.h"
#include "good_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"
#include "wave_case.h"

namespace upbead::test {
namespace wave_on_mesh_test {

class WaveOnMesh : public InFolder {
 protected:
  WaveOnMesh() {
    static const PetscSession petsc;  // MPI starts once in a process
    unsetenv("UPBEAD_MESHES");
  }
  static Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    write("case.toml", text);
    return read_case("case.toml", overrides);
  }
  static std::string objections(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
      simulation_of(read(text, overrides));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

/// Mound and bed are pressed as the user could write it: by the pressure at the wall's foot, times cos(2 pi x/L).
TEST_F(WaveOnMesh, PressesOnMoundAndBedAsAtTheFoot) {
  const std::string wave =
      "{ height = 8.0, period = 12.0, course = \"church_roof\", mound = [\"mound_surface\", "
      "\"bed\"] }";
  std::string text = wave_case(wave);
  const std::vector<std::string> computed{"sliding.uplift={ kind = \"computed\" }"};
  const Case problem = read(text, computed);
  const Simulation simulation = simulation_of(problem);
  const WaveLoad& load = *sources_of_type<WaveLoad>(problem).front();
  const auto& loads = simulation.scene().loads;
  for (const char* curve : {"mound_surface", "bed"}) {
    const Load& one = loads.at(std::string("storm.") + curve);
    EXPECT_EQ(one.kind, LoadKind::pressure);
    for (const double t : {0.1, 0.9, 3., 5.5})
      EXPECT_NEAR(one.history(t), loads.at("storm").history(t) * load.pressure.p3 / load.pressure.force, 1e-9);
    EXPECT_NEAR(intensity(one, -9. - 1e-7, 6.), 1., 1e-9);
    EXPECT_EQ(intensity(one, -9. + 1e-7, 6.), 0.);
    for (const double x : {-9.7, -16., -28.})
      EXPECT_NEAR(intensity(one, x, 0.), std::cos(two_pi * (x + 9.) / load.wavelength), 4e-4);
  }
  // the pressure there is that on the wall's foot
  const Load& wall = loads.at("storm");
  double total = 0.;
  for (int i = 0; i < 16000; ++i) total += 1e-3 * intensity(wall, 6. + 1e-3 * (i + 0.5));
  EXPECT_NEAR(wall.history(3.) * intensity(wall, 6.) / total, loads.at("storm.bed").history(3.),
              1e-5 * wall.history(3.));
  EXPECT_NE(objections(text).find("so that a given uplift would count twice"), std::string::npos);
  EXPECT_NE(objections(text, {computed[0], "boundaries.bed.pressure=\"sealed\""}).find("no water passes through 'bed'"),
            std::string::npos);
  EXPECT_NE(objections(text, {computed[0], "regions.caisson.interface={ kind = \"friction\", gap = \"sea\" }"})
                .find("the sea in gaps would count it twice"),
            std::string::npos);
  text.replace(text.find(sliding_table), sliding_table.size(), "[sliding]\n");
  EXPECT_NE(objections(text).find("counts in no S of the caisson as a whole"), std::string::npos);
}

}  // namespace wave_on_mesh_test
}  // namespace upbead::test
