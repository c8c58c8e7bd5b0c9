// A case: the file that a person wrote, and the scene that it describes.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "upbead/input/document.h"
#include "upbead/model/scene.h"

namespace upbead {

struct CaseTables;
struct LoadSource;
struct MeshRequest;

struct Case {
  Scene scene;                               ///< checked as far as it can be without a mesh; paths as written
  Document document;                         ///< what was written, for places
  std::vector<Diagnostic> notes;             ///< remarks that are no mistakes: keys by older names
  std::string stem;                          ///< the file's name without folder and ending
  std::shared_ptr<const CaseTables> tables;  ///< as written
  std::map<std::string, std::shared_ptr<const LoadSource>> sources;  ///< of [loads.NAME], by NAME
  std::shared_ptr<const LoadSource> uplift;                          ///< of a prescribed uplift by a file; else null
  std::string why_end;  ///< where the file gives no end, and its mesh has settled it: why it is that long

  /// Where a dotted key such as "regions.sand.porosity" was written. For a key that was not written: the place of the
  /// nearest table that would hold it.
  Place place(const std::string& key) const { return document.place(key); }
  /// The same mistakes; those at keys of the scene get the key's place in the file.
  InputError placed(const InputError& error) const;
  /// A path of the case (relative to its file) as seen from the working folder.
  std::string resolve(const std::string& path) const;
};

/// Reads the case file with overrides KEY=VALUE and makes all checks that need no mesh. Throws one InputError with
/// every mistake.
Case read_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// Throws what read_case() throws if the case file itself has mistakes; reads no other file if it has none.
void check_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// The notes of the case as text, a line each.
std::string notes_on(const Case& problem);

/// Throws InputError where the case has no load. Call it only before a computation: without one, a case needs no load.
void require_loads(const Case& problem);

/// What the mesh layer needs: file, parameters and where each was asked for.
MeshRequest mesh_request(const Case& problem);

/// The case as TOML with every default spelled out, and with paths as seen from `output_folder`, where it can be run
/// unchanged.
std::string effective_case(const Case& problem, const std::string& output_folder);

/// Every key of the case file as Markdown.
std::string case_reference();

/// The same keys as JSON Schema (draft 4): editors complete and check a case file by it.
std::string case_json_schema();

/// The folder of shipped geometries: that of the environment variable UPBEAD_MESHES, else the one installed beside the
/// program, else the one of the source tree. Throws InputError where there is none.
std::string geometry_folder();

/// Names of the shipped geometries, sorted.
std::vector<std::string> geometries();

}  // namespace upbead
