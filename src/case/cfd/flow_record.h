// Output of CFD programs as it lies: what a file or a folder says, joined over restarts, in its own axes and newtons,
// before anybody has said what of it is a load.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "case/cfd/flow_rows.h"
#include "upbead/base/error.h"

namespace upbead {

using Triple = std::array<double, 3>;

/// The force on a patch over time.
struct FlowForces {
  std::vector<double> time;      ///< s
  std::vector<Triple> force;     ///< N, of the thickness that was computed
  std::vector<Triple> moment;    ///< N m about `centre`; empty where none is given
  std::optional<Triple> centre;  ///< CofR
};

/// A field at points over time.
struct FlowPoints {
  std::string field;  ///< as the file calls it: "p", "p_rgh"
  std::string unit;   ///< as the file tells it; "" where it does not
  std::vector<std::string> name;
  std::vector<Triple> at;     ///< m
  FlowRows rows;              ///< a column a point
  bool are_faces = false;     ///< centres of faces of a patch, each value that of its face
  bool are_vertices = false;  ///< corners of faces of a patch
};

/// A surface of water at a place over time.
struct FlowLevel {
  std::vector<double> time;   ///< s
  std::vector<double> level;  ///< above the datum (m)
  std::vector<double> depth;  ///< from the surface to the bed (m)
  double still = 0.;          ///< level of still water above the datum (m)
};

/// Exactly one of the three.
struct FlowRecord {
  std::string path;
  std::string layout;              ///< for people: "OpenFOAM forces (force.dat)"
  std::vector<std::string> files;  ///< that were read
  std::optional<FlowForces> forces;
  std::optional<FlowPoints> points;
  std::optional<FlowLevel> level;
  FlowNotes notes;  ///< what was joined, left out, or may be wrong

  const std::vector<double>& time() const;
};

/// Reads whatever it is. `file`: the name of the file within the folders of a folder; "" where there is but one.
/// `place`: the key that names the path. Throws InputError: what cannot be read, a layout that is not known, whatever
/// contradicts itself, at the file's line.
FlowRecord read_flow(const std::string& path, const std::string& file, const Place& place);

/// What each of them is called, its unit and its numbers: a time, and what belongs to it.
struct FlowColumn {
  std::string name, unit;
  std::vector<double> value;
};
std::vector<FlowColumn> columns_of(const FlowRecord& record);

/// For people: layout, times, what there is, and where.
std::string describe(const FlowRecord& record);

}  // namespace upbead
