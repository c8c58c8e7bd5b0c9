// Output of CFD programs as it lies on disk: the contents of a file or folder, joined over restarts, in its own axes
// and in newtons, before the keys say which part is a load.
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
  std::vector<Triple> force;     ///< N, on the thickness that was computed
  std::vector<Triple> moment;    ///< N m about `centre`; empty where none is given
  std::optional<Triple> centre;  ///< CofR
};

/// A field at points over time.
struct FlowPoints {
  std::string field;  ///< as the file calls it: "p", "p_rgh"
  std::string unit;   ///< as the file gives it; "" where it gives none
  std::vector<std::string> name;
  std::vector<Triple> at;     ///< m
  FlowRows rows;              ///< one column for each point
  bool are_faces = false;     ///< centres of faces of a patch; a value holds for the whole face
  bool are_vertices = false;  ///< corners of faces of a patch
};

/// A surface of water at a place over time.
struct FlowLevel {
  std::vector<double> time;   ///< s
  std::vector<double> level;  ///< above the datum (m)
  std::vector<double> depth;  ///< from the surface to the bed (m)
  double still = 0.;          ///< level of still water above the datum (m)
};

/// A record holds exactly one of forces, points and level.
struct FlowRecord {
  std::string path;
  std::string layout;              ///< for people: "OpenFOAM forces (force.dat)"
  std::vector<std::string> files;  ///< the files that were read
  std::optional<FlowForces> forces;
  std::optional<FlowPoints> points;
  std::optional<FlowLevel> level;
  FlowNotes notes;  ///< what was joined, left out, or may be wrong

  const std::vector<double>& time() const;
};

/// Reads a record of any known layout. `file`: the name of the file within the folders of a folder; "" where there is
/// only one. `place`: the key that names the path. Throws InputError, at the file's line, where something cannot be
/// read, contradicts itself, or has an unknown layout.
FlowRecord read_flow(const std::string& path, const std::string& file, const Place& place);

/// A column of the record as a table: its name, unit and numbers; the time comes first.
struct FlowColumn {
  std::string name, unit;
  std::vector<double> value;
};
std::vector<FlowColumn> columns_of(const FlowRecord& record);

/// Text for people: layout, times, quantities and their places.
std::string text_of(const FlowRecord& record);

}  // namespace upbead
