#include "column_case.h"

#include <cmath>

namespace upbead::test {

namespace {

std::shared_ptr<Mesh> mesh_of(const std::vector<double>& lines) {
  const double height = lines.back();
  return tensor_mesh(
      {0., 1.}, lines, [](const auto&) { return "soil"; },
      [height](const auto& at) -> std::string {
        if (at[1] == 0.) return "base";
        if (at[1] == height) return "top";
        return at[0] == 0. ? "left" : at[0] == 1. ? "right" : "";
      });
}

}  // namespace

std::vector<double> geometric_lines(double height, int cells, double grading) {
  if (grading == 1. || cells < 2) return even_lines(0., height, cells);
  const double growth = std::pow(grading, 1. / (cells - 1));
  return graded_lines(height, 0., height * (growth - 1.) / (std::pow(growth, cells) - 1.), growth, height);
}

ColumnRun::ColumnRun(Scene scene, const ColumnMesh& mesh, double end) : mesh_(mesh_of(mesh.lines)) {
  scene.mesh.degree = mesh.degree;
  compiled_ = std::make_shared<Compiled>(scene, *mesh_);
  response_ = run(*compiled_, end, mesh.step);
}

std::vector<double> ColumnRun::at(const std::string& reading, const std::vector<double>& times) const {
  return sampled(response_.ends.time, history(*compiled_, response_, reading), times);
}

void load_by(Scene& scene, const std::string& where) {
  if (where != "water") return;
  scene.loads["top"].kind = LoadKind::pressure;
  scene.loads["top"].direction = {1., 0.};
}

TimeFunction step_load(double value, double rise) {
  Pulse pulse;
  pulse.shape = PulseShape::step;
  pulse.peak = value;
  if (rise > 0.) pulse.rise = rise;
  return time_function(pulse);
}

}  // namespace upbead::test
