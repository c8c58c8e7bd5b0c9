// An accepted case is sound: no number in it is nan, its loads are finite at all times, and the effective case that
// `run` writes with its results is read as the same case again.
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "target.h"
#include "upbead/case/case.h"

namespace upbead::fuzz {

namespace {

namespace fs = std::filesystem;

/// Writes two geometries and a history that cases may name; returns the folder of the case.
std::string folder_of_cases() {
  const fs::path folder = fs::path(memory_file("force.csv", "time,force\n0,0\n0.2,1e6\n0.4,0\n")).parent_path();
  fs::create_directories(folder / "meshes");
  memory_file("meshes/composite.geo", "");
  memory_file("meshes/column.geo", "");
  setenv("UPBEAD_MESHES", (folder / "meshes").c_str(), 1);
  return folder.string();
}

void check_loads(const Scene& scene) {
  for (const auto& [name, load] : scene.loads) {
    for (const double t : {0., 0.5 * scene.time.end, scene.time.end})
      require(std::isfinite(load.history(t)), "a load is finite at all times");
    for (const double kink : load.history.kinks()) require(std::isfinite(kink), "a kink is at a finite time");
    require(!load.duration || *load.duration >= 0., "a duration is a number, not below zero");
  }
  require(!std::isnan(shortest_duration(scene)), "the shortest duration is a number");
  require(!std::isnan(bandwidth(scene)), "the bandwidth is a number");
}

}  // namespace

void try_case(std::string_view bytes) {
  static const std::string folder = folder_of_cases();
  const std::string path = memory_file("case.toml", bytes);
  std::string effective;
  const bool read = read_or_refuse([&] {
    const Case problem = read_case(path);
    check_loads(problem.scene);
    effective = effective_case(problem, folder);
  });
  if (!read) return;
  const std::string again = memory_file("effective.toml", effective);
  std::string twice;
  require(read_or_refuse([&] { twice = effective_case(read_case(again), folder); }), "the effective case is read");
  require(twice == effective, "the effective case is the same case");
}

}  // namespace upbead::fuzz
