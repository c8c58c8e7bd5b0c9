// A case: the file that a person wrote, and the scene that it describes.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "upbead/input/document.h"
#include "upbead/input/report_head.h"
#include "upbead/model/gauges.h"
#include "upbead/model/scene.h"
#include "upbead/waves/goda.h"

namespace upbead {

struct TrainLoad;

struct RecordClock {
  double zero = 0.;          ///< s from the record's beginning; its mean over this time of rest is subtracted
  double record_start = 0.;  ///< the record's time at t = 0 of the run (s)
  std::optional<double> sampling_rate;  ///< Hz; none: the first column is the time
};

/// The keys of a load of kind "pressures", or of a prescribed uplift.
struct GaugeSource : RecordClock {
  std::string gauges;                   ///< file; "" where there are none
  std::map<std::string, double> place;  ///< of each transducer, by the name of its column (m)
  std::optional<std::array<double, 2>> ends;
  Beyond to_first = Beyond::constant, to_last = Beyond::constant;
  std::string gauge_unit;  ///< "": as the headers say
  std::string load_cell;   ///< name of a column; "" where there is none
};

/// A load by transducers; in the scene each transducer becomes a load.
struct GaugeLoad {
  Load load;           ///< what the transducers have in common, as written
  GaugeSource source;  ///< paths as written
  Gauges gauges;       ///< read
};

/// A table [measured.NAME] as written.
struct MeasuredSource : RecordClock {
  std::string file;     ///< as written
  std::string column;   ///< "": the second, or the first where there is no column of times
  std::string reading;  ///< history below /history of results.h5
  std::string unit;     ///< "": as the header says
};

struct MeshRequest;
struct WaveLoad;
struct FlowLoad;
struct RecordNotes;

/// A load `from` a CFD program.
struct FlowCase {
  Load load;           ///< as written, without what the record gives
  GaugeSource beyond;  ///< how the pressure continues beyond the record's points
  std::shared_ptr<const FlowLoad> flow;
};

/// Where a load's history comes from: exactly one of the two.
struct LoadSource {
  std::optional<Pulse> pulse;
  std::string history;       ///< CSV file, relative to the case; "" where there is a pulse
  double record_start = 0.;  ///< the history's time at t = 0 of the run (s)
};

struct Case {
  Scene scene;                                ///< checked as far as it can be without a mesh; paths as written
  Document document;                          ///< what was written, for places
  std::vector<Diagnostic> notes;              ///< remarks that are no mistakes: keys by older names
  std::string stem;                           ///< the file's name without folder and ending
  std::map<std::string, LoadSource> sources;  ///< of each load of one history, by its name
  /// How the files of loads and uplift were read, by the key that names them.
  std::map<std::string, std::shared_ptr<const RecordNotes>> records;
  std::map<std::string, GaugeLoad> gauges;  ///< loads by transducers; in the scene NAME.TRANSDUCER
  std::map<std::string, FlowCase> flows;    ///< loads by CFD; in the scene NAME, NAME.PIECE or NAME.POINT
  /// Loads by regular waves; in the scene NAME.cosine and NAME.sine.
  std::map<std::string, std::shared_ptr<const TrainLoad>> trains;
  std::optional<Section> section;                                ///< of loads by waves
  std::map<std::string, std::shared_ptr<const WaveLoad>> waves;  ///< loads by waves; their shapes follow with the mesh
  bool uplift_by_wave = false, sliding_by_wave = false;  ///< [sliding] uplift and wave are those of the load by a wave
  std::string uplift_history;              ///< CSV file of a prescribed uplift, relative to the case; "" without
  double uplift_start = 0.;                ///< that file's time at t = 0 of the run (s)
  std::optional<GaugeLoad> uplift_gauges;  ///< of an uplift by transducers
  std::map<std::string, MeasuredSource> measured;  ///< records that the run is compared with
  ReportHead report;

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
