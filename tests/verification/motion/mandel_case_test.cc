// Claim: Mandel's specimen under a rigid smooth plate, written as a case file, has the exact consolidation. Source
// and limits: those of columns/consolidation_test.cc.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "record.h"
#include "reference.h"
#include "upbead/case/case.h"
#include "upbead/mesh/request.h"
#include "upbead/run/simulation.h"

namespace upbead::test {
namespace mandel_case_test {

const std::string specimen = R"(title = "Mandel's problem"
[mesh]
geometry = "column"
parameters = { height = 1, width = 5, cells = 1, cells_across = 60 }
degree = 3
[fluid]
density = 1000
bulk_modulus = 2.2e9
[regions.soil]
kind = "porous"
youngs_modulus = 100e6
poissons_ratio = 0.2
porosity = 0.4
grain_density = 2650
hydraulic_conductivity = 1e-5
[boundaries]
base = { displacement = "roller", pressure = "sealed" }
left = { displacement = "roller", pressure = "sealed" }
right = { pressure = "open" }
top = { displacement = "plate", pressure = "sealed" }
[loads.plate]
boundary = "top"
direction = [0.0, -1.0]
pulse = { shape = "step", peak = 1e5 }
[time]
end = 100
step = 0.1
inertia = false
[probes]
0 = { at = [0.0, 0.5] }
1 = { at = [1.25, 0.5] }
2 = { at = [2.5, 0.5] }
3 = { at = [3.75, 0.5] }
plate = { at = [4.0, 1.0] }
edge = { at = [5.0, 1.0] }
)";

TEST(MandelByACaseFile, Consolidates) {
  const std::string file = std::filesystem::temp_directory_path() / ("mandel" + std::to_string(getpid()) + ".toml");
  std::ofstream(file) << specimen;
  const Case problem = read_case(file);
  std::filesystem::remove(file);
  const std::shared_ptr<const Mesh> mesh = read_mesh(mesh_request(problem));
  const Simulation simulation(problem.scene, mesh);
  const auto run = simulation.run({});
  const Json entry = reference("ref1_consolidation").at("mandel").at(0);
  const System& system = simulation.system();
  std::vector<double> t;
  for (const double time : entry.at("t").get<std::vector<double>>())
    if (time >= 2. && time <= 100.) t.push_back(time);  // the first steps after the jump are not compared
  const std::size_t first = 1;
  const auto read = [&](const std::string& reading) {
    return sampled(run.response.ends.time, run.response.ends.reading.row(system.reading(reading)), t);
  };
  Record record("mandel");
  for (std::size_t x = 0; x < 4; ++x) {
    std::vector<double> exact;
    for (std::size_t i = 0; i < t.size(); ++i) exact.push_back(entry.at("p").at(first + i).at(x));
    record.at_most("by a case file: p at x = " + entry.at("x").at(x).dump() + " m over its initial value",
                   largest_error(read("probes/" + std::to_string(x) + "/pressure"), exact, entry.at("p_initial")),
                   1e-3);
  }
  const auto part = [&](const char* key) {
    const std::vector<double> all = entry.at(key);
    return std::vector<double>(all.begin() + first, all.begin() + first + static_cast<std::ptrdiff_t>(t.size()));
  };
  record.at_most("by a case file: u_x of the edge over its largest value",
                 largest_error(read("probes/edge/displacement_x"), part("ux_edge")), 1e-3);
  record.at_most("by a case file: u_y of the plate over its largest value",
                 largest_error(read("probes/plate/displacement_y"), part("uy_per_height")), 1e-3);
}

}  // namespace mandel_case_test
}  // namespace upbead::test
