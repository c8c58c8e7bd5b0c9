// Columns of soil under a load at the top, as the reference tables describe them.
#pragma once

#include "record.h"
#include "reference.h"
#include "scenes.h"
#include "tensor_mesh.h"

namespace upbead::test {

/// Mesh and steps for a column.
struct ColumnMesh {
  std::vector<double> lines;  ///< heights of the cells' edges (m), base first
  int degree = 3;             ///< of u
  double step = 1e-3;         ///< s
};

/// Edges of cells that grow geometrically from the top down; `grading`: size of the lowest over that of the highest.
std::vector<double> geometric_lines(double height, int cells, double grading);

/// Histories of a column's probes.
class ColumnRun {
 public:
  /// `scene`: made by column(); its probes are read. Marches to `end` (s).
  ColumnRun(Scene scene, const ColumnMesh& mesh, double end);
  /// A reading, such as "probes/top/displacement_y", at given times.
  std::vector<double> at(const std::string& reading, const std::vector<double>& times) const;
  const std::vector<double>& times() const { return response_.ends.time; }
  const Response& response() const { return response_; }
  const Compiled& compiled() const { return *compiled_; }

 private:
  std::shared_ptr<Mesh> mesh_;
  std::shared_ptr<Compiled> compiled_;
  Response response_;
};

/// A load at the top that the tables call `where`: "skeleton" (a traction) or "water" (pressure on a pervious surface).
void load_by(Scene& scene, const std::string& where);

/// The tables' names: `full` is our inertial flow, `upB` our darcy flow.
inline Flow flow_of(const std::string& model) {
  return model == "full" ? Flow::inertial : Flow::darcy;
}

/// f(t) = value from t = 0 on, after a linear rise over `rise` (s; 0: a jump).
TimeFunction step_load(double value, double rise = 0.);

}  // namespace upbead::test
