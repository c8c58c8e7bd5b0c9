// How well the error that `respond` states bounds the true error, for random records on different scenes.
//
// usage: bench_wave_errors SCENE CELLS STEPS LENGTH WAVES SEED
//
// Records on a grid of STEPS steps per duration of the scene's load, up to LENGTH times the scene's end long, with
// shapes and durations at random; the truth is the kernel of SDIRK on that grid. Prints JSON.

#include <iostream>
#include <nlohmann/json.hpp>

#include "../response/wave_errors.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead::test {
namespace {

using Json = nlohmann::ordered_json;

Json measure(const ErrorScene& scene, double steps, double length, int waves, unsigned seed) {
  WaveErrors errors(scene, steps, length, seed);
  Json json{{"scene", scene.name}, {"unknowns", errors.unknowns()}, {"steps", steps}};
  json["told"] = errors.reduction().error.history;
  json["checked"] = errors.reduction().omega / 6.283185307179586;
  json["vectors"] = errors.reduction().n_vectors;
  json["modes"] = {errors.reduction().model.n_modes(), errors.nested().middle.n_modes(),
                   errors.nested().reference.n_modes()};
  json["seconds"] = {errors.reduce_seconds, errors.nested_seconds};
  for (int w = 0; w < waves; ++w) {
    const WaveError e = errors.next();
    json["waves"].push_back({{"kind", e.kind},
                             {"length", e.length},
                             {"duration", e.duration},
                             {"truth_error", e.truth_error},
                             {"error", e.error},
                             {"peak_error", e.peak_error},
                             {"of_model", e.of_model},
                             {"of_middle", e.of_middle},
                             {"estimate", e.estimate}});
  }
  return json;
}

}  // namespace
}  // namespace upbead::test

int main(int argc, char** argv) {
  if (argc != 7) {
    std::cerr << "usage: bench_wave_errors SCENE CELLS STEPS LENGTH WAVES SEED\n";
    return 1;
  }
  try {
    const upbead::PetscSession session;
    std::cout << upbead::test::measure(upbead::test::error_scene(argv[1], std::stod(argv[2])), std::stod(argv[3]),
                                       std::stod(argv[4]), std::stoi(argv[5]),
                                       static_cast<unsigned>(std::stoi(argv[6])))
                     .dump(1)
              << "\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
