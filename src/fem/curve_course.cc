#include "fem/curve_course.h"

#include <algorithm>
#include <map>
#include <set>

namespace upbead {

namespace {

using Neighbours = std::map<unsigned, std::set<unsigned>>;

Neighbours neighbours_on(const Mesh& mesh, const std::string& curve) {
  Neighbours next;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (mesh.curve_of(face) == curve) {
        next[face->vertex_index(0)].insert(face->vertex_index(1));
        next[face->vertex_index(1)].insert(face->vertex_index(0));
      }
  return next;
}

}  // namespace

std::vector<std::array<double, 2>> course_of(const Mesh& mesh, const std::string& curve) {
  const auto& vertices = mesh.triangulation.get_vertices();
  const Neighbours next = neighbours_on(mesh, curve);
  std::vector<unsigned> ends;
  for (const auto& [vertex, others] : next) {
    if (others.size() > 2) return {};
    if (others.size() == 1) ends.push_back(vertex);
  }
  if (ends.size() != 2) return {};
  const auto place = [&](unsigned v) { return std::array<double, 2>{vertices[v][0], vertices[v][1]}; };
  unsigned at = place(ends[0]) < place(ends[1]) ? ends[0] : ends[1];
  std::vector<std::array<double, 2>> course{place(at)};
  for (std::set<unsigned> seen{at}; seen.size() < next.size();) {
    const auto& others = next.at(at);
    const auto onward = std::find_if(others.begin(), others.end(), [&](unsigned v) { return !seen.count(v); });
    if (onward == others.end()) return {};  // the curve also has a closed line
    at = *onward;
    seen.insert(at);
    course.push_back(place(at));
  }
  return course;
}

void follow_curves(const Mesh& mesh, Scene& scene) {
  for (auto& [name, load] : scene.loads)
    if (load.along_curve) load.course = course_of(mesh, load.boundary);
}

}  // namespace upbead
