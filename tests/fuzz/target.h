// Shared by all fuzz targets. A target takes bytes as an input file of the program. It must either read them or throw
// an InputError that says what is wrong; any other exception is a finding.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "upbead/base/error.h"

namespace upbead::fuzz {

using Target = void (*)(std::string_view bytes);

void try_case(std::string_view bytes);         ///< a case (TOML)
void try_design(std::string_view bytes);       ///< a design (TOML)
void try_checkpoint(std::string_view bytes);   ///< .h5 of a checkpoint: valid HDF5 whose objects are changed
void try_flow(std::string_view bytes);         ///< output of a CFD program, by the name that its first byte chooses
void try_forces(std::string_view bytes);       ///< forces.dat of OpenFOAM with cut rows and heads at will
void try_history(std::string_view bytes);      ///< CSV: the history of a load, of an uplift, waves of a reduced model
void try_script(std::string_view bytes);       ///< a .geo: its parameters, as our own scanner reads them
void try_mesh(std::string_view bytes);         ///< a .msh, byte by byte, through gmsh
void try_groups(std::string_view bytes);       ///< a .msh that gmsh can read: nodes, cells, groups, names at will
void try_model(std::string_view bytes);        ///< .h5 of a reduced model: valid HDF5 whose objects are changed
void try_model_bytes(std::string_view bytes);  ///< .h5 of a reduced model, byte by byte
void try_soil_model(std::string_view bytes);   ///< .h5 of a model of soils: valid HDF5 whose objects are changed
void try_wave_file(std::string_view bytes);    ///< .h5 of waves: valid HDF5 whose objects are changed

/// Throws std::logic_error if a promise of a target does not hold.
inline void require(bool holds, const std::string& promise) {
  if (!holds) throw std::logic_error("broken promise: " + promise);
}

/// Runs `read`; if it refuses the input, each mistake must say what is wrong. Returns whether the input was accepted.
template <class Read>
bool read_or_refuse(Read read) {
  try {
    read();
    return true;
  } catch (const InputError& error) {
    require(!error.diagnostics().empty(), "an InputError has a mistake");
    for (const Diagnostic& mistake : error.diagnostics())
      require(!mistake.what.empty(), "a mistake says what is wrong");
    return false;
  }
}

/// Writes a file of that name in a folder of this process, in memory if there is /dev/shm; returns its path.
std::string memory_file(const std::string& name, std::string_view bytes);

}  // namespace upbead::fuzz
