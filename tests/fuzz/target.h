// What every fuzz target shares. A target takes bytes as a file that somebody gives to the program; the only right
// answers are to read it, or an InputError that says where and what. Everything else that leaves a target is a finding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace upbead::fuzz {

using Target = void (*)(std::string_view bytes);

void try_case(std::string_view bytes);         ///< a case file (TOML)
void try_history(std::string_view bytes);      ///< CSV: the history of a load, of an uplift
void try_waves(std::string_view bytes);        ///< CSV: waves for a reduced model
void try_design(std::string_view bytes);       ///< a design file (TOML), also one for the expected distance
void try_script(std::string_view bytes);       ///< the parameters of a .geo, as the mesh layer reads them from its text
void try_mesh(std::string_view bytes);         ///< a .msh, byte by byte
void try_groups(std::string_view bytes);       ///< a .msh that gmsh can read: nodes, cells, groups and names at will
void try_model(std::string_view bytes);        ///< an .h5 model: valid HDF5, its objects changed at will
void try_model_bytes(std::string_view bytes);  ///< an .h5 model, byte by byte
void try_wave_file(std::string_view bytes);    ///< an .h5 of waves: valid HDF5, its objects changed at will

/// Throws std::logic_error where what a target promises does not hold.
inline void require(bool holds, const std::string& promise) {
  if (!holds) throw std::logic_error(promise);
}

/// Runs `read` and requires of an InputError that each of its mistakes says what is wrong.
template <class Read>
void read_or_refuse(Read read);

/// A file in memory, of this process and of that name, that is written anew for each input.
std::string memory_file(const std::string& name, std::string_view bytes);
/// The folder of memory files.
const std::string& memory_folder();

}  // namespace upbead::fuzz

#include "target.templates.h"
