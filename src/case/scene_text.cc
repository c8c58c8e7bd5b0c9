#include "case/scene_text.h"

#include <map>
#include <sstream>

namespace upbead {

namespace {

bool is_of_scene(const std::string& table) {
  for (const char* name : {"fluid", "mesh", "regions", "boundaries"})
    if (table == name || table.rfind(std::string(name) + ".", 0) == 0) return true;
  return false;
}

/// The lines of each table of the scene, by its name.
std::map<std::string, std::string> tables_of(const std::string& case_text) {
  std::map<std::string, std::string> tables;
  std::istringstream lines(case_text);
  std::string line, table;
  while (std::getline(lines, line)) {
    if (line.rfind('[', 0) == 0 && line.back() == ']')
      table = line.substr(1, line.size() - 2);
    else if (is_of_scene(table) && !line.empty() && line.rfind("file = ", 0) != 0)
      tables[table] += line + "\n";
  }
  return tables;
}

}  // namespace

std::vector<std::string> tables_that_differ(const std::string& case_text, const std::string& other_text) {
  const auto a = tables_of(case_text), b = tables_of(other_text);
  std::vector<std::string> names;
  for (const auto& [name, text] : a)
    if (const auto same = b.find(name); same == b.end() || same->second != text) names.push_back(name);
  for (const auto& [name, text] : b)
    if (a.count(name) == 0) names.push_back(name);
  return names;
}

}  // namespace upbead
