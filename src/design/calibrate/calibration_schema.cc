#include "design/design_tables.h"

namespace upbead {

namespace {

constexpr int most_values = 1000;

Diagnostics refuse(const Node& node, const KeyInfo& key, const std::string& what) {
  return {{node.place, key.name + ": " + what, "give the " + key.meaning()}};
}

/// Reads one of the three keys of a range.
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
  table.key("model", &ScaledModel::model, "", "path of a reduced model, made by 'upbead reduce'").required();
  table.key("soil", &ScaledModel::soil, "",
            "of a model of soils, made by 'upbead reduce --soils': its soil, by keys such as "
            "\"regions.seabed.shear_modulus\"; those left out have the case's value");
  table.key("soils", &ScaledModel::soils, "", "of a model of soils: so many at random from its box, all in one fit",
            from_to(2., 1000.));
  table.key("load", &ScaledModel::load, "", "name of its load that is the wave")
      .fallback("the only one, or that with the largest peak");
  table.key("step", &ScaledModel::step, "s", "step of the answers; auto: 1/80 of the shortest rise", from_to(1e-5, 1.))
      .or_word("auto");
  table.key("scale", &ScaledModel::scale, "",
            "length of its breakwater over that of [section]; section and waves are scaled to it by Froude's law",
            from_to(1e-3, 1e3));
  return table;
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
  table.key("relative_height", &CalibrationTable::relative_height, "", "heights of the waves over the depth, H/h",
            from_to(1e-3, 10.));
  table
      .key("period", &CalibrationTable::period, "s", "periods T of the waves at the size of [section]",
           from_to(0.01, 1e4))
      .required();
  table.key("relative_berm_depth", &CalibrationTable::relative_berm_depth, "",
            "depths of the berm over that of the sea, d/h; in place of section.berm_depth", from_to(1e-3, 1.));
  table.key("relative_berm_width", &CalibrationTable::relative_berm_width, "",
            "widths of the berm over the wavelength, B_M/L; in place of section.berm_width", from_to(0., 10.));
  table.key("ratios", &CalibrationTable::ratios, "", "ratios r = F_Smax/(mu W') at which tau_0 is taken",
            from_to(1.001, 100.));
  table.key("steepness", &CalibrationTable::steepness, "", "least and largest steepness H/L; other waves are left out",
            from_to(0., 1.));
  table.tables("models", &CalibrationTable::models, model_schema())
      .doc("Reduced models by name, each at its own size.");
  return table;
}

}  // namespace upbead
