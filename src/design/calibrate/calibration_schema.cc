// The keys of [calibration], and checks across them.
#include "base/text.h"
#include "design/calibrate/family.h"
#include "design/design.h"

namespace upbead {

namespace {

constexpr int most_values = 1000;

Diagnostics refuse(const Node& node, const KeyInfo& key, const std::string& what) {
  return {{node.place, key.name + ": " + what, "give the " + key.meaning()}};
}

/// One of the three keys of a range.
template <class V>
void read_end(const Node& node, const KeyInfo& key, const std::string& name, V& value, Diagnostics& wrong) {
  KeyInfo inner = key;
  inner.name = key.name + "." + name;
  const Node* found = node.find(name);
  if (found)
    wrong.add(read_value(*found, inner, value));
  else
    wrong.add(refuse(node, key, "the range has no '" + name + "'"));
}

Diagnostics read_range(const Node& node, const KeyInfo& key, std::vector<double>& values) {
  double from = 0., to = 0.;
  int n = 0;
  Diagnostics wrong;
  KeyInfo count = key;
  count.unit = "";
  count.range = from_to(2., most_values);
  count.doc = "number of values";
  read_end(node, key, "from", from, wrong);
  read_end(node, key, "to", to, wrong);
  read_end(node, count, "n", n, wrong);
  for (const auto& [name, entry] : *node.table())
    if (name != "from" && name != "to" && name != "n")
      wrong.add(entry.place, "unknown key '" + name + "' in the range " + key.name,
                suggestion(name, {"from", "to", "n"}, "keys"));
  if (wrong.empty() && from >= to) wrong.add(refuse(node, key, "'from' is not below 'to'"));
  if (!wrong.empty()) return wrong;
  for (int i = 0; i < n; ++i) values.push_back(from + (to - from) * i / (n - 1));
  return {};
}

Diagnostics read_list(const Node& node, const KeyInfo& key, std::vector<double>& values) {
  if (node.array()->empty()) return refuse(node, key, "the list is empty");
  if (node.array()->size() > most_values)
    return refuse(node, key, "the list has more than " + std::to_string(most_values) + " values");
  Diagnostics wrong;
  for (const Node& item : *node.array()) wrong.add(read_value(item, key, values.emplace_back()));
  for (std::size_t i = 1; wrong.empty() && i < values.size(); ++i)
    if (values[i] <= values[i - 1]) return refuse((*node.array())[i], key, "the values do not ascend");
  return wrong;
}

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

constexpr double most_waves = 1e6;  // of the grid: minutes

double n_grid(const CalibrationTable& grid) {
  double n = 1.;
  for (const NumberList* list :
       {&grid.relative_height, &grid.period, &grid.relative_berm_depth, &grid.relative_berm_width})
    n *= static_cast<double>(list->values.size());
  return n;
}

void check_models(const DesignTables& tables, const Document& document, Diagnostics& report) {
  const auto& models = tables.calibration->models;
  if (models.empty() && report.sound("calibration.models"))
    report.add(
        document.place("calibration"), "[calibration] has no reduced model",
        "add a table [calibration.models.NAME] with model = the path of a reduced model, made by 'upbead reduce'");
  if (!report.sound("section") || !report.sound("gravity") || !report.sound("fluid")) return;
  for (const auto& [name, model] : models) {
    const std::string path = dotted("calibration.models", name);
    if (report.sound(path))
      check_model(path, model, scaled(tables.section, model.scale), tables.water, document, report);
  }
}

void check_grid(const DesignTables& tables, const Document& document, Diagnostics& report) {
  const CalibrationTable& grid = *tables.calibration;
  if (grid.steepness[0] >= grid.steepness[1])
    report.add(document.place("calibration.steepness"), "no steepness lies between the two limits",
               "give the least steepness H/L first, then a larger one");
  else if (n_grid(grid) > most_waves)
    report.add(document.place("calibration"),
               "the grid has " + significant(n_grid(grid)) + " waves, more than " + significant(most_waves),
               "give fewer heights, periods or berms");
  else if (report.sound("section") && report.sound("gravity") && report.sound("fluid") &&
           make_family(tables).waves.empty())
    report.add(document.place("calibration"), "every wave of the grid is beyond the limits of the formulas",
               "give H/h up to 0.8, periods with H below 0.142 L tanh(kh) and H/L within steepness, and d up to h'");
}

}  // namespace

Diagnostics read_value(const Node& node, const KeyInfo& key, NumberList& value) {
  value.values.clear();
  if (node.array()) return read_list(node, key, value.values);
  if (node.table()) return read_range(node, key, value.values);
  return refuse(node, key, "expected " + type_text(key, &value) + ", found " + found(node));
}

std::string type_text(const KeyInfo& key, const NumberList*) {
  return "a list of numbers or { from, to, n }" + (key.unit.empty() ? "" : " (" + key.unit + ")");
}

std::string print_value(const KeyInfo&, const NumberList& value) {
  std::vector<std::string> items;
  for (const double number : value.values) items.push_back(to_toml(number));
  return "[" + join(items) + "]";
}

void visit_value(const KeyInfo& key, const std::string& path, NumberList& value, const NumberVisitor& visitor) {
  for (double& number : value.values) visitor(key, path, number);
}

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

void check_calibration(const DesignTables& tables, const Document& document, Diagnostics& report) {
  check_impact(tables, document, report);
  if (!tables.calibration) {
    if (report.sound("calibration"))
      report.add(document.place("calibration"), "the table [calibration] is missing, which 'calibrate' needs",
                 "add [calibration] with period = [T, ...] (s), and [calibration.models.NAME]");
    return;
  }
  const bool sound = report.sound("calibration");
  check_models(tables, document, report);
  if (sound) check_grid(tables, document, report);
}

}  // namespace upbead
