// A case: the file that a person wrote, and the scene that it describes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "upbead/case/gauge_source.h"
#include "upbead/case/measured_source.h"
#include "upbead/input/document.h"
#include "upbead/model/scene.h"

namespace upbead {

struct MeshRequest;

/// Where a load's history comes from: exactly one of the two.
struct LoadSource {
  std::optional<Pulse> pulse;
  std::string history;  ///< CSV file, relative to the case; "" where there is a pulse
};

struct Case {
  Scene scene;                                ///< checked as far as it can be without a mesh; paths as written
  Document document;                          ///< what was written, for places
  std::string stem;                           ///< the file's name without folder and ending
  std::map<std::string, LoadSource> sources;  ///< of each load of one history, by its name
  std::map<std::string, GaugeLoad> gauges;    ///< loads by transducers; in the scene NAME.TRANSDUCER
  std::string uplift_history;                 ///< CSV file of a prescribed uplift, relative to the case; "" without
  std::optional<GaugeLoad> uplift_gauges;     ///< of an uplift by transducers
  std::map<std::string, MeasuredSource> measured;  ///< records to hold the run against

  /// Where a dotted key such as "regions.sand.porosity" was written; of the nearest table around it where it was not.
  Place place(const std::string& key) const { return document.place(key); }
  /// The same mistakes, those at keys of the scene at their places in the file.
  InputError placed(const InputError& error) const;
  /// A path of the case (relative to its file) as seen from the working folder.
  std::string resolve(const std::string& path) const;
};

/// Reads the case file with overrides KEY=VALUE and checks all that needs no mesh. Throws InputError with every
/// mistake.
Case read_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// Throws InputError where the case has no load; not an error as long as nothing is computed.
void require_loads(const Case& problem);

/// What the mesh layer needs: file, parameters and where each was asked for.
MeshRequest mesh_request(const Case& problem);

/// The case as TOML with every default spelled out, and with paths as seen from `output_folder`: it runs as it is
/// there.
std::string effective_case(const Case& problem, const std::string& output_folder);

/// Every key of the case file as Markdown.
std::string case_reference();

/// The folder of shipped geometries: the environment's UPBEAD_MESHES, else that installed beside the program, else that
/// of the source tree. Throws InputError where there is none.
std::string geometry_folder();

/// Names of the shipped geometries, sorted.
std::vector<std::string> geometries();

}  // namespace upbead
