#include "skip_case.h"

#include <cmath>

namespace upbead::test {

Scene section_scene(bool sea, double duration) {
  Scene scene = breakwater(triangle(1.6e6, duration));
  scene.time.end = std::max(0.5, 1.5 * duration);
  if (sea) add_sea(scene);
  return scene;
}

Solved solve(const Scene& scene, const Mesh& mesh, double duration) {
  const ResolvedScene resolved = resolve(scene, mesh);
  const Compiled compiled(resolved, mesh);
  const Response response = run(compiled, scene.time.end, duration / 12.);
  return {shear_of(compiled, response), compiled.system.n_free(), resolved.decisions};
}

std::string decided(const Solved& solved, const std::string& region, const std::string& key) {
  for (const Decision& decision : solved.decisions)
    if (decision.region == region && decision.key == key) return decision.value;
  return "";
}

void compare(Record& record, const std::string& what, const Solved& without, const Solved& with) {
  record.at_most(what + ": change of peak F_T, relative",
                 std::abs(without.shear.peak_shear / with.shear.peak_shear - 1.), 1e-3);
  record.measured(what + ": unknowns without what is left out", without.unknowns);
  record.measured(what + ": unknowns with it", with.unknowns);
}

}  // namespace upbead::test
