// The section of a random scene: which regions and curves its mesh has, and how they lie.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "draw.h"

namespace upbead::test {

/// An outer curve and the regions behind it.
struct LayoutCurve {
  std::string name;
  std::vector<std::string> behind;
  bool is_level = false;    ///< of free water
  bool is_surface = false;  ///< of the ground, where loads act
  bool is_base = false;
  bool under_sea = false;  ///< somewhere
};

struct Layout {
  std::string mesh;                                  ///< the lines of [mesh] that name geometry and parameters
  std::vector<std::string> ground;                   ///< regions of soil or rock, from below
  std::vector<std::string> seas;                     ///< regions of water
  bool caisson = false;                              ///< with a region caisson, on `under_caisson`
  std::string under_caisson;                         ///< the region of the ground below it
  std::vector<std::array<std::string, 2>> touching;  ///< regions of the ground, and the caisson, that touch
  std::vector<LayoutCurve> curves;                   ///< outer ones
  std::vector<std::array<double, 2>> probes;         ///< points in the ground (m)
  std::array<double, 2> middle{0., 0.};              ///< of the caisson (m)
  double caisson_area = 0.;                          ///< m2
  double depth = 0.;                                 ///< of the sea (m), or the value used instead
  double aspect = 1.;                                ///< of the longest cell
};

/// A section of blocks (section.geo at that path), with a few hundred unknowns at most.
Layout draw_section(Draw& draw, const std::string& section_geo);

/// One of the shipped geometries with few cells: a column, or a composite breakwater.
Layout draw_shipped(Draw& draw);

}  // namespace upbead::test
