// What a table [loads.NAME] may hold, and the ways in which it gives its load: a new source of loads is a file of its
// own, its keys and its row here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/cfd/flow_source.h"
#include "case/load_source.h"
#include "case/records/record_keys.h"
#include "case/wave_load.h"
#include "case/wave_train.h"

namespace upbead {

/// [loads.NAME.pulse].
struct PulseTable : Pulse {
  int number = 1;                ///< of equal pulses in a row
  std::optional<double> period;  ///< from one to the next (s)
};

/// A table [loads.NAME] as written, of which its source makes loads (load_source.h).
struct LoadTable : Load, HistoryKeys, GaugeKeys, FlowKeys {
  std::optional<PulseTable> pulse;
  std::optional<WaveLoadTable> wave;
  std::optional<WaveTrain> train;
};

/// Whether a load's direction is a key; that of a record of CFD is landward.
inline bool has_own_direction(const LoadTable& load) {
  return load.from.empty() && (load.kind == LoadKind::force || load.kind == LoadKind::traction ||
                               load.kind == LoadKind::body_force || is_motion(load.kind));
}

LoadWay by_pulse();    ///< pulse_load.cc
LoadWay by_history();  ///< records/history_load.cc
LoadWay by_wave();     ///< wave_load.cc
LoadWay by_train();    ///< wave_train.cc
LoadWay by_gauges();   ///< records/gauge_load.cc
LoadWay by_flow();     ///< cfd/flow_scene.cc

/// All rows, in the order of their keys in the file.
inline const std::vector<LoadWay>& load_ways() {
  static const std::vector<LoadWay> ways{by_pulse(), by_history(), by_wave(), by_train(), by_gauges(), by_flow()};
  return ways;
}

}  // namespace upbead
