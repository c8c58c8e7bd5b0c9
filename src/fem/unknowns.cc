#include "fem/unknowns.h"

#include <algorithm>

#include "fem/constraints.h"

namespace upbead {

using namespace dealii;

namespace {

/// The field of every degree of freedom, and for each cell with W its degrees of freedom of W.
struct CellLayout {
  std::vector<Field> field;
  std::vector<Dofs> W;
};

CellLayout cell_layout(const Space& space) {
  CellLayout layout;
  layout.field.assign(space.dofs().n_dofs(), Field::displacement);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    const auto& fe = cell->get_fe();
    const Dofs dofs = dofs_of(cell);
    Dofs W;
    for (unsigned i = 0; i < dofs.size(); ++i) {
      const int component = static_cast<int>(fe.system_to_component_index(i).first);
      if (component == phi_component) {
        layout.field[dofs[i]] = Field::pressure_impulse;
      } else if (component >= dim) {
        layout.field[dofs[i]] = Field::relative_fluid;
        W.push_back(dofs[i]);
      }
    }
    if (!W.empty()) layout.W.push_back(std::move(W));
  }
  return layout;
}

}  // namespace

Unknowns::Unknowns(const Space& space, const Scene& scene, const std::vector<Body>& bodies,
                   const std::vector<InterfaceNode>& interface)
    : n_interface_(static_cast<int>(interface.size())) {
  const SceneMotions motions = scene_motions(space, scene, bodies.size());
  prescribed_ = motions.loads;
  std::vector<Field> fields;
  for (const std::string& load : prescribed_)
    fields.push_back(is_motion(scene.loads.at(load).kind) ? Field::displacement : Field::pressure_impulse);
  number(space, make_constraints(space, scene, bodies, motions, interface),
         n_motions * bodies.size() + motions.plates.size(), fields);
  separate(interface);
}

void Unknowns::separate(const std::vector<InterfaceNode>& interface) {
  const int first = size() - 2 * n_interface_;
  for (const InterfaceNode& node : interface) {
    if (!node.has_ground()) continue;
    for (const auto dof : {node.ux, node.uy}) {
      Row& row = of_caisson_[dof];
      for (const auto& [j, weight] : expansion_[dof])
        if (j < first) row.emplace_back(j, weight);
    }
  }
}

const Row& Unknowns::caisson_expansion(types::global_dof_index dof) const {
  const auto found = of_caisson_.find(dof);
  return found == of_caisson_.end() ? expansion_[dof] : found->second;
}

void Unknowns::number(const Space& space, const AffineConstraints<double>& constraints, std::size_t n_coordinates,
                      const std::vector<Field>& prescribed) {
  const auto n_dofs = space.dofs().n_dofs();
  const CellLayout layout = cell_layout(space);
  std::vector<int> index(n_dofs + n_coordinates + prescribed_.size() + 2 * static_cast<std::size_t>(n_interface_), -1);
  const auto append = [&](types::global_dof_index i, Field field) {
    index[i] = size();
    field_.push_back(field);
  };
  for (types::global_dof_index i = 0; i < n_dofs; ++i)
    if (!constraints.is_constrained(i) && layout.field[i] != Field::relative_fluid) append(i, layout.field[i]);
  first_coordinate_ = size();
  for (std::size_t c = 0; c < n_coordinates; ++c) append(n_dofs + c, Field::displacement);
  for (const auto& block : layout.W) {
    const int begin = size();
    for (const auto i : block) append(i, Field::relative_fluid);
    blocks_.push_back({begin, size()});
  }
  for (std::size_t l = 0; l < prescribed.size(); ++l) append(n_dofs + n_coordinates + l, prescribed[l]);
  for (auto i = n_dofs + n_coordinates + prescribed_.size(); i < index.size(); ++i) append(i, Field::displacement);

  expansion_.resize(n_dofs);
  for (types::global_dof_index i = 0; i < n_dofs; ++i) {
    if (!constraints.is_constrained(i)) {
      expansion_[i] = {{index[i], 1.}};
      continue;
    }
    for (const auto& [j, weight] : *constraints.get_constraint_entries(i)) expansion_[i].emplace_back(index[j], weight);
  }
}

int Unknowns::prescribed(const std::string& load) const {
  const auto found = std::find(prescribed_.begin(), prescribed_.end(), load);
  return found == prescribed_.end() ? -1 : size() - n_prescribed() + static_cast<int>(found - prescribed_.begin());
}

Vector Unknowns::expand(const Vector& x) const {
  Vector full = Vector::Zero(static_cast<Eigen::Index>(expansion_.size()));
  for (std::size_t i = 0; i < expansion_.size(); ++i)
    for (const auto& [j, weight] : expansion_[i]) full[i] += weight * x[j];
  return full;
}

Vector Unknowns::expand_caisson(const Vector& x) const {
  Vector full = expand(x);
  for (const auto& [dof, row] : of_caisson_) {
    full[dof] = 0.;
    for (const auto& [j, weight] : row) full[dof] += weight * x[j];
  }
  return full;
}

void Unknowns::add_to(std::map<int, double>& row, types::global_dof_index dof, double weight) const {
  for (const auto& [j, part] : expansion_[dof]) row[j] += weight * part;
}

Row to_row(const std::map<int, double>& entries) {
  Row row;
  for (const auto& entry : entries)
    if (entry.second != 0.) row.push_back(entry);
  return row;
}

Row scaled(Row row, double factor) {
  for (auto& entry : row) entry.second *= factor;
  return row;
}

}  // namespace upbead
