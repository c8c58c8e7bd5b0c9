// The keys by which a person says how a CFD record becomes a load, and the load made of the record.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"
#include "upbead/model/gauges.h"

namespace upbead {

struct FlowRecord;

enum class FlowAxis { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };

/// What the numbers at points are.
enum class FlowQuantity {
  pressure,               ///< p (Pa), with the weight of the water
  pressure_less_weight,   ///< p_rgh (Pa) = p - rho g h
  kinematic,              ///< p/rho (m2/s2)
  kinematic_less_weight,  ///< p_rgh/rho
  hydrostatic,            ///< of a water level: rho g times the depth below it
};

/// What is done with a vertical force that is not small.
enum class FlowVertical { apply, leave_out };

/// The keys of a load `from` a CFD program; a key that is needed and not given is asked for.
struct FlowKeys {
  std::string from;  ///< folder or file, relative to the case; "" where the load is not from CFD
  std::string file;  ///< name of the file within the folders of times
  std::optional<FlowAxis> landward, up;
  std::optional<std::array<double, 2>> origin;  ///< where the origin of the record's axes is in the scene (m)
  std::optional<double> thickness;              ///< of the computed slice, to which the record's newtons belong (m)
  std::optional<FlowQuantity> quantity;
  std::optional<double> flow_density;               ///< of the record's water (kg/m3)
  std::optional<double> datum;                      ///< height along `up` at which p_rgh equals p (m)
  std::optional<std::array<double, 2>> still_time;  ///< interval of the record in which the water is still (s)
  std::optional<double> still_force;                ///< landward force of still water (N/m)
  std::optional<double> still_level;                ///< y of still water in the scene (m)
  std::optional<FlowVertical> vertical;
  bool blank_is_zero = false;    ///< cells without a pressure are dry
  std::optional<double> within;  ///< how far points may lie from their boundary (m)
  std::string against;           ///< record of forces on the same wall, to compare with; "" without
  double flow_start = 0.;        ///< time of the record that is t = 0 of the run (s)
};

/// A force per metre over time, and its moment about the foot to which the pieces of a load refer.
struct FlowHistory {
  std::vector<double> time;              ///< of the run (s), from 0 on
  std::vector<double> landward, up;      ///< excess over still water (N/m)
  std::vector<double> moment;            ///< about `centre`, overturning positive (N m/m); empty where not known
  std::array<double, 2> centre{0., 0.};  ///< in the scene (m)
};

/// The load made of a record: all that `explain`, the summary and the scene need.
struct FlowLoad {
  FlowKeys source;  ///< as written
  std::string layout;
  std::vector<std::string> files;
  std::vector<std::string> told;  ///< for people, a sentence each
  NumberedWarnings warnings;
  std::optional<FlowHistory> force;        ///< where the record holds forces or a level
  std::optional<Gauges> pressure;          ///< where it holds points: excess over still water
  double peak_force = 0., peak_time = 0.;  ///< landward per metre (N/m; s); from points: over the length they cover
  std::optional<double> peak_arm;          ///< above `centre` (m)
  double still_force = 0.;                 ///< of still water, that was subtracted (N/m)
  std::optional<double> difference;        ///< largest difference to `against`, over the largest force
  std::optional<double> top;               ///< y that a level of water reaches (m)
  std::vector<std::array<double, 2>> at;   ///< of the points, in the scene (m)
};

}  // namespace upbead
