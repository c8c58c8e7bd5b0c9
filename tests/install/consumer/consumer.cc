// The share of a force triangle that reaches the caisson's bottom: MODEL PEAK DURATION.
#include <cstdlib>
#include <iostream>

#include "upbead/case/case.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/output/model_file.h"

int main(int, char** argv) {
  const upbead::ModalModel model = upbead::read_model_file(argv[1]).modes;
  const double peak = std::atof(argv[2]), duration = std::atof(argv[3]);
  std::vector<double> time;
  for (int n = 0; n <= 4000; ++n) time.push_back(1e-3 * duration * n);
  const upbead::TimeFunction none, wave = upbead::piecewise_linear({0., duration / 2., duration}, {0., peak, 0.});
  std::vector<upbead::TimeFunction> loads(model.n_loads(), none);
  loads[0] = wave;
  const upbead::Series answer = upbead::respond(model, upbead::sample(loads, time));
  std::cout << answer.reading.row(model.index("shear_force")).maxCoeff() / peak << '\n';
  setenv("UPBEAD_MESHES", MESHES, 1);
  std::cout << upbead::geometries().size() << '\n';
}
