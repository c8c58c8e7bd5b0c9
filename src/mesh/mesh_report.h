// Collects the mistakes of one mesh: reported at the place that asked for the mesh, with its name, or in its script.
#pragma once

#include <deal.II/base/point.h>

#include <string>
#include <vector>

#include "upbead/mesh/request.h"

namespace upbead {

class MeshReport {
 public:
  explicit MeshReport(const MeshRequest& request);
  void add(const std::string& what, const std::string& cure);
  /// Reported at the place of the parameter that `what` names, if that parameter was set.
  void add_about_parameters(const std::string& what, const std::string& cure);
  /// Reported at a place in a script.
  void add_in_script(const Place& place, const std::string& what, const std::string& cure);
  /// Adds the mistakes that another report of the same mesh has found.
  void add(const Diagnostics& mistakes);
  const Diagnostics& diagnostics() const { return mistakes_; }
  bool empty() const { return mistakes_.empty(); }
  void throw_if_any() const;

 private:
  void add_at(const Place& place, const std::string& what, const std::string& cure);

  const MeshRequest& request_;
  std::string name_;
  Diagnostics mistakes_;
};

/// Number of occurrences, and the place of the first.
struct Found {
  std::size_t count = 0;
  dealii::Point<2> where;
  void add(const dealii::Point<2>& point) {
    if (count++ == 0) where = point;
  }
  /// ", the first at (1.5, -2)"
  std::string first() const;
};

/// counted(3, "cell", " of sand") is "3 cells of sand"; 1 has no s.
std::string counted(std::size_t count, const std::string& thing, const std::string& rest = "");

/// "'name'", or "without a name".
std::string quoted(const std::string& name);

}  // namespace upbead
