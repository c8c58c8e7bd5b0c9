// Files of an unstructured grid for ParaView: VTU, with compressed arrays appended in binary.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace upbead {

/// A named array, already in the form in which the file holds it.
struct VtuArray {
  std::string name, type;  ///< type: its name in VTK
  int components = 1;
  std::string bytes;
};

/// Arrays of fields are made anew for every file: only runs of equal bytes are compressed, as more would take twice
/// as long for a fifth of the size. The arrays of the grid are made once for all files: as small as zlib makes them
/// by default.
enum class Packing { of_fields, of_grid };

/// An array compressed as VTK's vtkZLibDataCompressor reads it.
VtuArray vtu_array(const std::string& name, int components, const std::vector<float>& values, Packing packing);
VtuArray vtu_array(const std::string& name, int components, const std::vector<double>& values, Packing packing);
VtuArray vtu_array(const std::string& name, int components, const std::vector<int>& values, Packing packing);
VtuArray vtu_array(const std::string& name, int components, const std::vector<unsigned char>& values, Packing packing);

/// The arrays that all files of one mesh share.
struct VtuGrid {
  std::size_t n_points = 0, n_cells = 0;
  VtuArray points, connectivity, offsets, types;
  VtuArray regions{};                       ///< number of each cell's region; without a name: none
  std::vector<std::string> region_names{};  ///< by that number, as the field data `region_names` of the file
};

/// Writes a grid, the regions of its cells and arrays of numbers at its points.
void write_vtu(std::ostream& out, const VtuGrid& grid, const std::vector<VtuArray>& data);

}  // namespace upbead
