#include "calibration_tables.h"

namespace upbead {

namespace {

TableSchema<ScaledModel> model_schema() {
  TableSchema<ScaledModel> table;
  table.key("model", &ScaledModel::model).required().doc("path of a reduced model, made by 'upbead reduce'");
  table.key("load", &ScaledModel::load)
      .fallback("the only one, or that with the largest peak")
      .doc("name of its load that is the wave");
  table.key("step", &ScaledModel::step)
      .unit("s")
      .range(from_to(1e-5, 1.))
      .or_word("auto")
      .doc("step of the answers; auto: 1/80 of the shortest rise");
  table.key("scale", &ScaledModel::scale)
      .range(from_to(1e-3, 1e3))
      .doc("length of its breakwater over that of [section]; section and waves are scaled to it by Froude's law");
  return table;
}

}  // namespace

TableSchema<CalibrationTable> calibration_schema() {
  TableSchema<CalibrationTable> table;
  table.key("relative_height", &CalibrationTable::relative_height)
      .range(from_to(1e-3, 10.))
      .doc("heights of the waves over the depth, H/h");
  table.key("period", &CalibrationTable::period)
      .unit("s")
      .range(from_to(0.01, 1e4))
      .required()
      .doc("periods T of the waves at the size of [section]");
  table.key("relative_berm_depth", &CalibrationTable::relative_berm_depth)
      .range(from_to(1e-3, 1.))
      .doc("depths of the berm over that of the sea, d/h; in place of section.berm_depth");
  table.key("relative_berm_width", &CalibrationTable::relative_berm_width)
      .range(from_to(0., 10.))
      .doc("widths of the berm over the wavelength, B_M/L; in place of section.berm_width");
  table.key("ratios", &CalibrationTable::ratios)
      .range(from_to(1.001, 100.))
      .doc("ratios r = F_Smax/(mu W') at which tau_0 is taken");
  table.key("steepness", &CalibrationTable::steepness)
      .range(from_to(0., 1.))
      .doc("least and largest steepness H/L; other waves are left out");
  table.tables("models", &CalibrationTable::models, model_schema())
      .doc("Reduced models by name, each at its own size.");
  return table;
}

}  // namespace upbead
