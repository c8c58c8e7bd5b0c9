// A .geo or .msh, through gmsh, as plain numbers.

#include <gmsh.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/confined_work.h"
#include "base/parcel.h"
#include "base/text.h"
#include "mesh/geo_script.h"
#include "mesh/gmsh_session.h"
#include "mesh/raw_mesh.h"

namespace upbead {

namespace {

/// Whether all indices are valid.
bool fits(const RawMesh& mesh) {
  const auto vertices_fit = [n = mesh.vertices.size()](const auto& part) {
    return std::all_of(part.vertices.begin(), part.vertices.end(), [n](unsigned int v) { return v < n; });
  };
  const auto is_index = [](int i, int least, std::size_t n) { return i >= least && i < static_cast<int>(n); };
  return std::all_of(mesh.cells.begin(), mesh.cells.end(),
                     [&](const RawMesh::Cell& cell) {
                       return vertices_fit(cell) && is_index(cell.surface, -1, mesh.surfaces.size());
                     }) &&
         std::all_of(mesh.edges.begin(), mesh.edges.end(), [&](const RawMesh::Edge& edge) {
           return vertices_fit(edge) && is_index(edge.curve, 0, mesh.curves.size());
         });
}

/// Packs a mesh, to leave the confined process that read it.
void put(Parcel& parcel, const RawMesh& mesh) {
  std::vector<double> coordinates;
  coordinates.reserve(2 * mesh.vertices.size());
  for (const dealii::Point<2>& point : mesh.vertices) coordinates.insert(coordinates.end(), {point[0], point[1]});
  parcel.put(coordinates);
  parcel.put(mesh.cells);
  parcel.put(mesh.edges);
  parcel.put(mesh.surfaces);
  parcel.put(mesh.curves);
  parcel.put(std::vector<int>{mesh.n_divided, mesh.n_high_order});
  parcel.put(std::vector<double>{mesh.most_bent});
}

/// None where the numbers are inconsistent, as a malicious file may control the process.
std::optional<RawMesh> take_mesh(OpenParcel& parcel) {
  RawMesh mesh;
  const std::vector<double> coordinates = parcel.list<double>();
  for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2)
    mesh.vertices.emplace_back(coordinates[i], coordinates[i + 1]);
  mesh.cells = parcel.list<RawMesh::Cell>();
  mesh.edges = parcel.list<RawMesh::Edge>();
  mesh.surfaces = parcel.texts();
  mesh.curves = parcel.texts();
  const std::vector<int> numbers = parcel.list<int>();
  const std::vector<double> bent = parcel.list<double>();
  if (numbers.size() != 2 || bent.size() != 1) return std::nullopt;
  mesh.n_divided = numbers[0];
  mesh.n_high_order = numbers[1];
  mesh.most_bent = bent[0];
  if (!fits(mesh)) return std::nullopt;
  return mesh;
}

constexpr unsigned int unused = std::numeric_limits<unsigned int>::max();

/// Elements of one entity and one type. Each lists its corners first, then order - 1 nodes a side, then others (gmsh's
/// manual: Node ordering).
struct Elements {
  int entity;
  std::size_t nodes_each = 1;
  std::size_t corners = 0;
  std::size_t order = 1;
  std::vector<std::size_t> nodes;

  /// Whether all are lines (2 corners), triangles or quadrilaterals.
  bool are(std::size_t n_corners) const {
    return corners == n_corners && nodes_each >= (n_corners == 2 ? order + 1 : n_corners * order);
  }
};

Elements elements_with(int entity, int type, std::vector<std::size_t> nodes) {
  std::string kind;
  int dimension = 0, order = 0, nodes_each = 0, corners = 0;
  std::vector<double> unused_coordinates;
  gmsh::model::mesh::getElementProperties(type, kind, dimension, order, nodes_each, unused_coordinates, corners);
  const auto number = [](int n) { return static_cast<std::size_t>(std::max(n, 1)); };
  return {entity, number(nodes_each), number(corners), number(order), std::move(nodes)};
}

std::vector<Elements> elements_of(int dimension) {
  std::vector<Elements> result;
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dimension);
  std::sort(entities.begin(), entities.end());
  for (const auto& entity : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> tags, nodes;
    gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity.second);
    for (std::size_t i = 0; i < types.size(); ++i)
      result.push_back(elements_with(entity.second, types[i], std::move(nodes[i])));
  }
  return result;
}

/// The physical groups of one dimension, in the order of their numbers.
class Groups {
 public:
  Groups(int dimension, const std::string& kind, MeshReport& report) : dimension_(dimension) {
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups, dimension);
    std::sort(groups.begin(), groups.end());
    for (const auto& group : groups) {
      std::string name;
      gmsh::model::getPhysicalName(dimension, group.second, name);
      // gmsh drops a name that another group of the dimension has already.
      if (name.empty()) {
        const std::string number = std::to_string(group.second);
        report.add("physical " + kind + " " + number + " has no name of its own",
                   "give it one that no other " + kind + " has: Physical " + (dimension == 1 ? "Curve" : "Surface") +
                       "(\"name\", " + number + ") = {...};");
      }
      names.push_back(name);
      tags_.push_back(group.second);
    }
  }

  /// Indices into `names` of the groups that an entity belongs to.
  std::vector<int> of_entity(int entity) const {
    std::vector<int> tags, result;
    gmsh::model::getPhysicalGroupsForEntity(dimension_, entity, tags);
    for (const int tag : tags)
      result.push_back(static_cast<int>(std::lower_bound(tags_.begin(), tags_.end(), std::abs(tag)) - tags_.begin()));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  std::vector<std::string> names;

 private:
  int dimension_;
  std::vector<int> tags_;
};

/// All nodes of gmsh, by their tags.
class Nodes {
 public:
  Nodes() {
    std::vector<std::size_t> tags;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters, -1, -1, false, false);
    std::vector<std::size_t> order(tags.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return tags[a] < tags[b]; });
    for (const std::size_t i : order) {
      tags_.push_back(tags[i]);
      points.emplace_back(coordinates[3 * i], coordinates[3 * i + 1]);
      height.push_back(coordinates[3 * i + 2]);
    }
  }

  unsigned int index(std::size_t tag) const {
    return static_cast<unsigned int>(std::lower_bound(tags_.begin(), tags_.end(), tag) - tags_.begin());
  }

  std::vector<dealii::Point<2>> points;
  std::vector<double> height;  ///< z

 private:
  std::vector<std::size_t> tags_;
};

/// Reports cells that lie in no plane of a constant z.
void check_plane(const Nodes& nodes, const RawMesh& mesh, const std::vector<RawTriangle>& triangles,
                 MeshReport& report) {
  std::array<double, 3> least, most;
  least.fill(std::numeric_limits<double>::infinity());
  most.fill(-least[0]);
  const auto add = [&](const auto& cells) {
    for (const auto& cell : cells)
      for (const unsigned int v : cell.vertices)
        for (unsigned int d = 0; d < 3; ++d) {
          const double at = d < 2 ? nodes.points[v][d] : nodes.height[v];
          least[d] = std::min(least[d], at);
          most[d] = std::max(most[d], at);
        }
  };
  add(mesh.cells);
  add(triangles);
  double size = 0.;
  for (unsigned int d = 0; d < 3; ++d) size = std::max({size, std::abs(least[d]), std::abs(most[d])});
  const auto is_constant = [&](unsigned int d) { return !(most[d] - least[d] > 1e-9 * size); };
  if (is_constant(2)) return;
  const bool over_z = is_constant(0) || is_constant(1);
  report.add(
      over_z ? std::string("it lies in the plane of ") + (is_constant(0) ? "y" : "x") +
                   " and z: " + (is_constant(0) ? "x" : "y") + " is the same throughout"
             : "it leaves the plane z = " + significant(least[2], 6) + ": z reaches up to " + significant(most[2], 6),
      over_z ? "turn it, so that x is landward and y up; in a script, of x and z: Rotate {{1, 0, 0}, {0, 0, 0}, "
               "-Pi/2} {Surface{:};}"
             : "draw the section in x (landward) and y (up)");
}

/// Corners of elements that have n of them; of those of higher order, how far the other nodes of their sides are from
/// the chords.
template <class Cell>
void append_cells(const Elements& elements, int surface, const Nodes& nodes, std::vector<Cell>& cells, RawMesh& mesh) {
  constexpr std::size_t n = std::tuple_size<decltype(Cell::vertices)>::value;
  for (std::size_t i = 0; i + elements.nodes_each <= elements.nodes.size(); i += elements.nodes_each) {
    Cell cell{{}, surface};
    for (std::size_t v = 0; v < n; ++v) cell.vertices[v] = nodes.index(elements.nodes[i + v]);
    cells.push_back(cell);
    if (elements.order == 1) continue;
    ++mesh.n_high_order;
    for (std::size_t k = 0; k < n * (elements.order - 1); ++k) {
      const std::size_t side = k / (elements.order - 1);
      const auto &from = nodes.points[cell.vertices[side]], &to = nodes.points[cell.vertices[(side + 1) % n]];
      const auto& between = nodes.points[nodes.index(elements.nodes[i + n + k])];
      const double chord = (to - from).norm_square();
      if (chord > 0.) mesh.most_bent = std::max(mesh.most_bent, std::abs(cross(to - from, between - from)) / chord);
    }
  }
}

std::vector<RawTriangle> read_cells(const Nodes& nodes, RawMesh& mesh, MeshReport& report) {
  const Groups groups(2, "surface", report);
  mesh.surfaces = groups.names;
  std::vector<bool> has_cells(groups.names.size(), false);
  std::vector<RawTriangle> triangles;
  for (const Elements& elements : elements_of(2)) {
    const std::vector<int> surfaces = groups.of_entity(elements.entity);
    const int surface = surfaces.empty() ? -1 : surfaces.front();
    const std::string name =
        surface < 0 ? std::to_string(elements.entity) + " (on no physical surface)" : quoted(groups.names[surface]);
    if (surfaces.size() > 1)
      report.add("some cells are on two physical surfaces, " + name + " and " + quoted(groups.names[surfaces[1]]),
                 "keep every surface in one group only");
    for (const int each : surfaces) has_cells[each] = true;
    if (elements.are(4))
      append_cells(elements, surface, nodes, mesh.cells, mesh);
    else if (elements.are(3))
      append_cells(elements, surface, nodes, triangles, mesh);
    else
      report.add("surface " + name + " has " +
                     counted(elements.nodes.size() / elements.nodes_each, "cell", " of a strange kind"),
                 "make quadrilaterals: transfinite blocks with Recombine Surface, or Mesh.SubdivisionAlgorithm = 1");
  }
  for (std::size_t s = 0; s < has_cells.size(); ++s)
    if (!has_cells[s]) report.add("surface " + quoted(groups.names[s]) + " has no cells", "mesh it, or drop its name");
  return triangles;
}

void read_edges(const Nodes& nodes, RawMesh& mesh, MeshReport& report) {
  const Groups groups(1, "curve", report);
  mesh.curves = groups.names;
  for (const Elements& elements : elements_of(1)) {
    if (!elements.are(2)) continue;
    for (const int curve : groups.of_entity(elements.entity))
      for (std::size_t i = 0; i + 1 < elements.nodes.size(); i += elements.nodes_each)
        mesh.edges.push_back({{nodes.index(elements.nodes[i]), nodes.index(elements.nodes[i + 1])}, curve});
  }
}

/// Keeps only the vertices of cells, in their order, and the edges between these vertices.
void drop_unused(RawMesh& mesh) {
  std::vector<unsigned int> number(mesh.vertices.size(), unused);
  for (const RawMesh::Cell& cell : mesh.cells)
    for (const unsigned int v : cell.vertices) number[v] = 0;
  std::vector<dealii::Point<2>> vertices;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != unused) {
      number[v] = static_cast<unsigned int>(vertices.size());
      vertices.push_back(mesh.vertices[v]);
    }
  mesh.vertices = vertices;
  for (RawMesh::Cell& cell : mesh.cells)
    for (unsigned int& v : cell.vertices) v = number[v];
  std::vector<RawMesh::Edge> edges;
  for (const RawMesh::Edge& edge : mesh.edges) {
    const std::array<unsigned int, 2> ends{number[edge.vertices[0]], number[edge.vertices[1]]};
    if (ends[0] != unused && ends[1] != unused) edges.push_back({ends, edge.curve});
  }
  mesh.edges = edges;
}

RawMesh read_in(const MeshRequest& request, MeshReport& report) {
  open_mesh(request, report);
  RawMesh mesh;
  if (!report.empty()) return mesh;
  if (!elements_of(3).empty()) report.add("it has cells in three dimensions", "make a plane mesh (gmsh -2)");
  const Nodes nodes;
  mesh.vertices = nodes.points;
  const std::vector<RawTriangle> triangles = read_cells(nodes, mesh, report);
  const std::size_t others = report.diagnostics().list().size();
  check_plane(nodes, mesh, triangles, report);
  if (report.diagnostics().list().size() > others) return {};  // its cells have no area in x and y
  read_edges(nodes, mesh, report);
  divide_triangles(triangles, mesh);
  drop_unused(mesh);
  return mesh;
}

void check_commands(const MeshRequest& request, MeshReport& report) {
  if (!is_script(request.file)) return;
  for (const OutsideCommand& command : outside_commands(request.file))
    report.add_in_script(command.place, "'" + command.word + "' would " + command.would,
                         "remove it: a script may draw and mesh, and nothing else");
}

/// Time and memory (bytes) for gmsh: a script may take long to mesh.
ConfinedLimits limits_for(const MeshRequest& request) {
  ConfinedLimits limits = limits_for_file(request.file);
  limits.hidden_ending = ".opt";
  if (!is_script(request.file)) return limits;
  constexpr double longest = 3600.;
  limits.seconds = longest;
  limits.memory = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return limits;
}

void report_end(const ConfinedOutcome& outcome, const MeshRequest& request, MeshReport& report) {
  for (const std::string& what : outcome.refused)
    report.add("it tries to " + what, "remove what does so: a mesh is drawn, and nothing else is done");
  if (outcome.result || !outcome.refused.empty()) return;
  if (is_script(request.file))
    report.add_about_parameters("gmsh " + outcome.end + " on it", "mend the script or its parameters");
  else
    report.add("gmsh breaks down on it, so it is damaged", "save it again from gmsh: File > Export, format 2.2 or 4.1");
}

}  // namespace

RawMesh read_raw_mesh(const MeshRequest& request, MeshReport& report) {
  check_source(request, report);
  check_commands(request, report);
  if (!report.empty()) return {};
  const ConfinedOutcome outcome = work_confined(
      [&request] {
        MeshReport found(request);
        const RawMesh mesh = read_in(request, found);
        Parcel parcel;
        parcel.put(found.diagnostics());
        put(parcel, mesh);
        return parcel.take();
      },
      limits_for(request));
  report_end(outcome, request, report);
  if (!outcome.result) return {};
  OpenParcel parcel(*outcome.result);
  report.add(parcel.diagnostics());
  std::optional<RawMesh> mesh = take_mesh(parcel);
  if (!mesh) report.add("gmsh hands back a mesh that does not fit together", "mend the file");
  return std::move(mesh).value_or(RawMesh());
}

}  // namespace upbead
