// A case with every key of the case file, and the files that it names, in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace upbead::test {

inline const std::string good_case = R"(title = "prototype"
gravity = 9.8

[fluid]
density = 1025.0
bulk_modulus = inf

[mesh]
geometry = "composite"
parameters = { mound_height = 6, sand_depth = 15.0 }
refine = 1
degree = 3

[regions.rubble]
kind = "porous"
shear_modulus = 100e6
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650
hydraulic_conductivity = 0.1
flow = "inertial"
tortuosity = 1.2
biot = 0.9
grain_bulk_modulus = 3.6e10
damping = { ratio = 0.05, frequencies = [1.0, 8] }

[regions.block]
kind = "solid"
youngs_modulus = 30e9
poissons_ratio = 0.2
density = 2400

[regions.caisson]
kind = "rigid"
mass = 756e3
centre_of_gravity = [0.0, 16.0]
moment_of_inertia = 45e6

[boundaries.base]
displacement = "roller"
pressure = "open"

[boundaries.front]
pressure = "sealed"

[loads.impact]
boundary = "front"
kind = "force"
direction = [1.0, 0.5]
shape = [[6.0, 1.0], [26.0, 0.5]]

[loads.impact.pulse]
shape = "church_roof"
peak = 2e6
rise = 0.04
duration = 0.1
start = 0.01
plateau = 0.3
plateau_duration = 3

[loads.gauge]
region = "caisson"
at = [-9.0, 16.0]
history = "force.csv"

[time]
end = 2
step = 0.001
scheme = "sdirk4"
inertia = true
stop_at_energy = 1e-4

[accuracy]
tolerance = 0.01

[probes.A]
at = [0.0, -5.0]

[output]
fields = { every = 0.02 }

[sliding]
friction = 0.55
submerged_weight = 4.3e6
weight = 7.41e6
drag = 1e4
wave = { height = 8, depth = 15.0, period = 13.6, alpha_star = 0.5 }

[sliding.uplift]
kind = "prescribed"
peak = 5e5
shape = "held"
lag = 0.02
)";

/// Runs each test in a folder of its own that holds force.csv and the geometries column and composite.
class InFolder : public testing::Test {
 protected:
  InFolder() : before_(std::filesystem::current_path()) {
    folder_ = std::filesystem::temp_directory_path() / ("upbead-case-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_ / "meshes");
    std::filesystem::current_path(folder_);
    write("meshes/composite.geo", "");
    write("meshes/column.geo", "");
    write("force.csv", "time,force\n0,0\n0.2,1e6\n0.4,0\n");
    setenv("UPBEAD_MESHES", (folder_ / "meshes").c_str(), 1);
  }

  ~InFolder() override {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
    unsetenv("UPBEAD_MESHES");
  }

  static void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

  std::filesystem::path folder_;

 private:
  std::filesystem::path before_;
};

}  // namespace upbead::test
