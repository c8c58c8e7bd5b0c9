#include "stress_column.h"

namespace upbead::test {

Json stress_case(char letter) {
  const Json all = reference("ref9_stress");
  for (const Json& test : all.at("tests"))
    if (test.at("id").get<std::string>().front() == letter) return test;
  throw std::runtime_error("no such stress test");
}

Scene stress_column(const Json& test, double k, const std::string& model, const TimeFunction& load) {
  Json constants = test.at("mat");
  constants["k"] = k;
  Scene scene = column(soil(constants, flow_of(model)), scaled(load, test.at("q")));
  scene.fluid = fluid(constants);
  scene.probes["top"].at = {0.5, test.at("L")};
  scene.probes["base"].at = {0.5, 0.};
  return scene;
}

}  // namespace upbead::test
