// Files of an unstructured grid for ParaView: VTU, with compressed arrays appended as they are.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace upbead {

/// A named array of a file, already in the form in which the file holds it.
struct VtuArray {
  std::string name, type;  ///< type: as VTK calls it
  int components = 1;
  std::string bytes;
};

/// Of fields, made anew for every file: runs of equal bytes alone are looked for, as looking for more takes twice as
/// long for a fifth of the size. Of a grid, made once for all of them: as small as zlib usually makes it.
enum class Packing { of_fields, of_grid };

/// Numbers as VTK's compressor vtkZLibDataCompressor reads them.
VtuArray vtu_array(const std::string& name, int components, const std::vector<float>& values, Packing packing);
VtuArray vtu_array(const std::string& name, int components, const std::vector<int>& values, Packing packing);
VtuArray vtu_array(const std::string& name, int components, const std::vector<unsigned char>& values, Packing packing);

/// What files of one mesh have alike.
struct VtuGrid {
  std::size_t n_points = 0, n_cells = 0;
  VtuArray points, connectivity, offsets, types;
};

/// A grid and arrays of numbers at its points.
void write_vtu(std::ostream& out, const VtuGrid& grid, const std::vector<VtuArray>& data);

}  // namespace upbead
