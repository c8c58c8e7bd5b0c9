// The keys of a load `from` a CFD program, declared once for cases and for `upbead read`.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "case/cfd/flow_source.h"
#include "input/schema.h"
#include "upbead/input/document.h"

namespace upbead {

extern const std::vector<std::pair<std::string, FlowAxis>> flow_axis_words;
extern const std::vector<std::pair<std::string, FlowQuantity>> flow_quantity_words;
extern const std::vector<std::pair<std::string, FlowVertical>> flow_vertical_words;

/// Declares the keys of axes and extents; they belong where `belongs` holds (see Entry::when).
template <class T>
void add_flow_frame_keys(TableSchema<T>& table, const std::function<bool(const T&)>& belongs) {
  const auto in = [&](const Entry<T>& entry) { return entry.when("from", belongs, "with from"); };
  in(table.key("file", &T::file))
      .fallback("the only one that there is")
      .doc("name of the file within the folders of the times; such as \"p\", \"p_front.raw\"");
  in(table.choice("landward", &T::landward, flow_axis_words))
      .fallback("asked for")
      .doc("axis of the record that points landward, with its sign");
  in(table.choice("up", &T::up, flow_axis_words))
      .fallback("asked for where moments or places are read")
      .doc("axis of the record that points up");
  in(table.key("origin", &T::origin))
      .unit("m")
      .fallback("asked for where moments or places are read")
      .doc("where the origin of the record's axes is in the scene, (x, y)");
  in(table.key("thickness", &T::thickness))
      .unit("m")
      .range(above(0.))
      .fallback("asked for with forces in N")
      .doc("thickness across that the record's newtons are of");
}

/// Declares all keys of a CFD record except `from`, which is declared before.
template <class T>
void add_flow_keys(TableSchema<T>& table, const std::function<bool(const T&)>& belongs) {
  add_flow_frame_keys(table, belongs);
  const auto in = [&](const Entry<T>& entry) { return entry.when("from", belongs, "with from"); };
  in(table.choice("quantity", &T::quantity, flow_quantity_words))
      .fallback("that of the record where it has a unit, else asked for")
      .doc(
          "what the numbers are; p: Pa with the weight of the water; p_rgh: Pa without; p/rho and p_rgh/rho: of "
          "incompressible solvers (m2/s2); hydrostatic: of a water level");
  in(table.key("flow_density", &T::flow_density))
      .unit("kg/m3")
      .range(above(0.))
      .fallback("asked for with p_rgh, p/rho and hydrostatic")
      .doc("density of the water of the CFD run");
  in(table.key("datum", &T::datum))
      .unit("m")
      .fallback("asked for with p_rgh")
      .doc("height along up, in the record's axes, where p_rgh is p; hRef of OpenFOAM");
  in(table.key("still_time", &T::still_time))
      .unit("s")
      .doc("times of the record between which the water is still; the mean there is taken off");
  in(table.key("still_force", &T::still_force))
      .unit("N/m")
      .doc("landward force of still water, taken off; 0: the record is the excess already");
  in(table.key("still_level", &T::still_level))
      .unit("m")
      .doc("y of still water; rho g times the depth below it is taken off pressures");
  in(table.choice("vertical", &T::vertical, flow_vertical_words))
      .fallback("asked for where it is above 1 % of the landward force")
      .doc("what is done with the vertical force; apply: on a rigid region; leave_out: it is not applied");
  in(table.key("blank_is_zero", &T::blank_is_zero)).doc("true: a blank cell of a pressure is dry, so zero");
  in(table.key("within", &T::within))
      .unit("m")
      .range(at_least(0.))
      .fallback("a hundredth of the boundary's length")
      .doc("how far from the boundary the record's points may lie");
  in(table.key("against", &T::against))
      .fallback("none")
      .doc("forces on the same wall, a folder or a file, that the pressures' sum is compared with; not applied");
  in(table.key("flow_start", &T::flow_start)).unit("s").doc("time of the record that is t = 0 of the run");
}

/// Where a record's keys stand, and what of their load understand() needs to know. Keys that are missing or
/// contradict each other are found there, once it is known what the record holds.
struct FlowContext {
  std::string path;  ///< of the table of keys, "loads.wall"
  const Document* document;
  double gravity = 9.81;                                             ///< m/s2
  bool on_region = false;                                            ///< whether the load acts on a rigid region
  std::array<Beyond, 2> beyond{Beyond::constant, Beyond::constant};  ///< beyond the ends of points, not faces ...
  std::array<bool, 2> beyond_given{false, false};                    ///< ... and whether the case gives it
  std::string base = {};                                             ///< folder that paths are relative to; "" for none
};

/// Makes a load of the record. Throws InputError at the keys, with all that is missing or wrong at once.
FlowLoad understand(const FlowRecord& record, const FlowKeys& source, const FlowContext& context);

/// For people: what was understood, "6.3 kN over a thickness of 0.01 m along y: 630 kN/m".
std::string text_of(const std::string& name, const FlowLoad& load);

}  // namespace upbead
