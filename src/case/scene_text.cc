#include "case/scene_text.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <sstream>

namespace upbead {

namespace {

bool is_in(const std::string& table, const std::string& name) {
  return table == name || table.rfind(name + ".", 0) == 0;
}

bool is_of_scene(const std::string& table, const std::string& line) {
  for (const char* name : {"fluid", "mesh", "regions", "boundaries"})
    if (is_in(table, name)) return line.rfind("file = ", 0) != 0;
  return false;
}

bool is_of_action(const std::string& table, const std::string& line) {
  const std::string key = line.substr(0, line.find(" = "));
  const auto is_one_of = [&key](std::initializer_list<const char*> keys) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  if (table.empty()) return key == "gravity";
  if (table == "sliding") return is_one_of({"friction", "submerged_weight", "drag"});
  if (table == "initial") return is_one_of({"water_level", "harbour_level"});
  return is_in(table, "loads") && is_one_of({"boundary", "region", "kind", "at", "direction", "shape", "over_x",
                                             "along_curve", "measured_on_wall"});
}

using IsOf = bool (*)(const std::string& table, const std::string& line);

/// The lines that are of it, of each table by its name.
std::map<std::string, std::string> tables_of(const std::string& case_text, IsOf is_of) {
  std::map<std::string, std::string> tables;
  std::istringstream lines(case_text);
  std::string line, table;
  while (std::getline(lines, line)) {
    if (line.rfind('[', 0) == 0 && line.back() == ']')
      table = line.substr(1, line.size() - 2);
    else if (!line.empty() && is_of(table, line))
      tables[table.empty() ? "gravity" : table] += line + "\n";
  }
  return tables;
}

}  // namespace

std::vector<std::string> tables_that_differ(const std::string& case_text, const std::string& other_text) {
  const auto a = tables_of(case_text, is_of_scene), b = tables_of(other_text, is_of_scene);
  std::vector<std::string> names;
  for (const auto& [name, text] : a)
    if (const auto same = b.find(name); same == b.end() || same->second != text) names.push_back(name);
  for (const auto& [name, text] : b)
    if (a.count(name) == 0) names.push_back(name);
  return names;
}

std::vector<std::string> actions_that_differ(const std::string& case_text, const std::string& other_text) {
  const auto a = tables_of(case_text, is_of_action), b = tables_of(other_text, is_of_action);
  std::vector<std::string> names;
  for (const auto& [name, text] : a)
    if (const auto same = b.find(name); same != b.end() && same->second != text) names.push_back(name);
  if (a.count("initial") != b.count("initial")) names.emplace_back("initial");
  return names;
}

}  // namespace upbead
