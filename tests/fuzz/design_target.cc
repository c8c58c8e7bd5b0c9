// An accepted design has finite waves, and the effective design is read as the same design again.
#include <cmath>

#include "design/design.h"
#include "target.h"

namespace upbead::fuzz {

void try_design(std::string_view bytes) {
  const std::string path = memory_file("design.toml", bytes), folder = path.substr(0, path.rfind('/'));
  std::string effective;
  const bool read = read_or_refuse([&] {
    const Design design = read_design(path, {});
    for (const auto& [name, wave] : design.tables.waves) {
      const DesignWave w = design_wave(wave, design.tables.section, design.tables.water);
      require(std::isfinite(w.height) && std::isfinite(w.significant_height), "a wave has a finite height");
    }
    effective = effective_design(design, folder);
  });
  if (!read) return;
  const std::string again = memory_file("effective.toml", effective);
  std::string twice;
  require(read_or_refuse([&] { twice = effective_design(read_design(again, {}), folder); }),
          "the effective design is read");
  require(twice == effective, "the effective design is the same design");
}

}  // namespace upbead::fuzz
