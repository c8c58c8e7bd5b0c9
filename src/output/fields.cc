#include "output/fields.h"

#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/crew.h"
#include "output/field_patches.h"
#include "upbead/base/error.h"

namespace upbead {

using namespace dealii;

namespace {

/// The point nearest to a place.
const BorneStress& nearest(const std::vector<BorneStress>& points, const Point<dim>& place) {
  return *std::min_element(points.begin(), points.end(), [&](const BorneStress& a, const BorneStress& b) {
    return a.at.distance_square(place) < b.at.distance_square(place);
  });
}

/// Strain and effective stress of plane strain from the gradient of u, tension positive; zero in rigid regions. The
/// stress of yielding soil is that of the nearest point of quadrature, as it does not follow from the strain alone.
class StrainAndStress : public DataPostprocessor<dim> {
 public:
  StrainAndStress(const Space& space, const SoilFields& soil) : space_(space), soil_(soil) {}
  std::vector<std::string> get_names() const override {
    return {"strain_xx_(1)",
            "strain_yy_(1)",
            "strain_xy_(1)",
            "effective_stress_xx_(Pa)",
            "effective_stress_yy_(Pa)",
            "effective_stress_xy_(Pa)",
            "effective_stress_zz_(Pa)"};
  }
  std::vector<DataComponentInterpretation::DataComponentInterpretation> get_data_component_interpretation()
      const override {
    return {get_names().size(), DataComponentInterpretation::component_is_scalar};
  }
  UpdateFlags get_needed_update_flags() const override { return update_gradients | update_quadrature_points; }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<dim>& inputs,
                             std::vector<dealii::Vector<double>>& computed) const override {
    const auto cell = inputs.template get_cell<dim>();
    const ElasticLaw& law = space_.material(cell);
    const std::size_t index = cell->active_cell_index();
    const bool yields = !soil_.borne.empty() && !soil_.borne[index].empty();
    for (std::size_t q = 0; q < computed.size(); ++q) {
      const auto& g = inputs.solution_gradients[q];
      const PlaneStrain strain{g[0][0], g[1][1], 0.5 * (g[0][1] + g[1][0])};
      const PlaneStress stress =
          yields ? nearest(soil_.borne[index], inputs.evaluation_points[q]).change : law.stress(strain);
      const double values[] = {strain.xx, strain.yy, strain.xy, stress.xx, stress.yy, stress.xy, stress.zz};
      std::copy(std::begin(values), std::end(values), computed[q].begin());
    }
  }

 private:
  const Space& space_;
  const SoilFields& soil_;
};

/// Acceleration of u; those of W and phi are of no use to a reader.
class Acceleration : public DataPostprocessor<dim> {
 public:
  std::vector<std::string> get_names() const override { return std::vector<std::string>(dim, "acceleration_(m_s2)"); }
  std::vector<DataComponentInterpretation::DataComponentInterpretation> get_data_component_interpretation()
      const override {
    return {dim, DataComponentInterpretation::component_is_part_of_vector};
  }
  UpdateFlags get_needed_update_flags() const override { return update_values; }

  void evaluate_vector_field(const DataPostprocessorInputs::Vector<dim>& inputs,
                             std::vector<dealii::Vector<double>>& computed) const override {
    for (std::size_t q = 0; q < computed.size(); ++q)
      for (unsigned d = 0; d < dim; ++d) computed[q][d] = inputs.solution_values[q][d];
  }
};

template <class List>
dealii::Vector<double> to_dealii(const List& values) {
  return dealii::Vector<double>(values.data(), values.data() + values.size());
}

std::vector<std::string> component_names(const std::string& u, const std::string& W, const std::string& phi) {
  return {u, u, W, W, phi};
}

enum class Part { whole, ground, caisson };

/// A state on all degrees of freedom.
struct Expanded {
  dealii::Vector<double> x, v, a;
};

/// Mean mobilised share over the points of each cell; NaN for cells that stay elastic.
dealii::Vector<double> mobilised(const SoilFields& soil) {
  dealii::Vector<double> mean(static_cast<unsigned>(soil.borne.size()));
  for (unsigned c = 0; c < mean.size(); ++c) {
    mean[c] = soil.borne[c].empty() ? std::numeric_limits<double>::quiet_NaN() : 0.;
    for (const BorneStress& point : soil.borne[c])
      mean[c] += point.mobilised / static_cast<double>(soil.borne[c].size());
  }
  return mean;
}

/// Draws a state on a part of the mesh; without inertia there is no acceleration.
void fill(const Space& space, bool inertia, const Expanded& state, const SoilFields& soil, Part part,
          FieldPatches& out) {
  using Interpretation = DataComponentInterpretation::DataComponentInterpretation;
  const Interpretation of_vector = DataComponentInterpretation::component_is_part_of_vector;
  const std::vector<Interpretation> interpretation{of_vector, of_vector, of_vector, of_vector,
                                                   DataComponentInterpretation::component_is_scalar};
  const StrainAndStress strain_and_stress(space, soil);
  const Acceleration acceleration;
  out.attach_dof_handler(space.dofs());
  out.add_data_vector(state.x,
                      component_names("displacement_(m)", "relative_fluid_displacement_(m)", "pressure_impulse_(Pa_s)"),
                      DataOut<dim>::type_dof_data, interpretation);
  out.add_data_vector(state.v, component_names("velocity_(m_s)", "darcy_velocity_(m_s)", "pore_pressure_(Pa)"),
                      DataOut<dim>::type_dof_data, interpretation);
  if (inertia) out.add_data_vector(state.a, acceleration);
  out.add_data_vector(state.x, strain_and_stress);
  if (!soil.borne.empty()) {
    out.add_data_vector(to_dealii(soil.dissipated), "dissipated_energy_(J_m3)", DataOut<dim>::type_cell_data);
    out.add_data_vector(mobilised(soil), "mobilised_strength_(1)", DataOut<dim>::type_cell_data);
  }
  using MeshCell = Triangulation<dim>::cell_iterator;
  const Mesh& mesh = space.mesh();
  out.add_regions(mesh);
  if (part != Part::whole)
    out.set_cell_selection(FilteredIterator<MeshCell>([&mesh, part](const MeshCell& cell) {
      return cell->is_active() && (mesh.surfaces[cell->material_id()] == caisson_name) == (part == Part::caisson);
    }));
  out.build_patches(static_cast<unsigned>(space.degree()));
}

}  // namespace

FieldWriter::FieldWriter(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Space> space,
                         std::shared_ptr<const Unknowns> unknowns, bool inertia,
                         std::function<std::string(const std::string&)> path_of)
    : mesh_(std::move(mesh)),
      space_(std::move(space)),
      unknowns_(std::move(unknowns)),
      inertia_(inertia),
      path_of_(std::move(path_of)) {}

void FieldWriter::wait(std::size_t most) const {
  while (pending_.size() > most) {
    std::future<void> oldest = std::move(pending_.front());
    pending_.pop_front();
    oldest.get();
  }
}

const std::vector<std::pair<double, std::string>>& FieldWriter::written() const {
  wait();
  return written_;
}

void FieldWriter::take_over(const std::vector<std::pair<double, std::string>>& written) {
  wait();
  written_ = written;
}

void FieldWriter::write(const State& state) {
  wait(static_cast<std::size_t>(most_threads()) - 1);
  char name[40];
  std::snprintf(name, sizeof name, "fields/fields_%04d.vtu", static_cast<int>(written_.size()));
  pending_.push_back(std::async(std::launch::async, [this, state, soil = soil_fields(), file = std::string(name),
                                                     path = path_of_(name)] { write_file(state, soil, file, path); }));
  written_.emplace_back(state.time, name);
}

SoilFields FieldWriter::soil_fields() const {
  SoilFields fields;
  if (!soil_) return fields;
  fields.borne = soil_->borne();
  for (const auto& cell : space_->mesh().triangulation.active_cell_iterators()) {
    const unsigned index = cell->active_cell_index();
    fields.dissipated.push_back(std::max(soil_->dissipated()[index], 0.) / area_of(cell));
  }
  return fields;
}

/// Where the caisson may lift off the ground, both are drawn separately: each has its own displacements at the
/// bottom.
void FieldWriter::write_file(const State& state, const SoilFields& soil, const std::string& name,
                             const std::string& path) const {
  const bool apart = unknowns_->has_interface();
  FieldPatches out, caisson;
  const auto expanded = [&](const auto& expand) {
    return Expanded{to_dealii(expand(state.x)), to_dealii(expand(state.v)), to_dealii(expand(state.a))};
  };
  const auto of_ground = [&](const upbead::Vector& values) { return unknowns_->expand(values); };
  const auto of_caisson = [&](const upbead::Vector& values) { return unknowns_->expand_caisson(values); };
  fill(*space_, inertia_, expanded(of_ground), soil, apart ? Part::ground : Part::whole, out);
  if (apart) {
    fill(*space_, inertia_, expanded(of_caisson), soil, Part::caisson, caisson);
    out.merge_patches(caisson);
  }
  std::call_once(grid_made_, [&] { grid_ = out.grid(); });
  std::ofstream file(path, std::ios::binary);
  write_vtu(file, grid_, out.arrays());
  file.flush();
  if (!file)
    throw InputError({name}, "the fields cannot be written", "is the disk full? choose another folder with --out DIR");
}

void FieldWriter::finish() const {
  wait();
  std::ostringstream record;
  DataOutBase::write_pvd_record(record, written_);
  const std::string text = record.str();
  const std::size_t clock = text.find("<!--"), end = text.find("-->");  // so equal fields make equal files
  std::ofstream file(path_of_("fields.pvd"));
  file << text.substr(0, clock) << text.substr(end + 4);
  file.flush();
  if (!file)
    throw InputError({"fields.pvd"}, "the fields cannot be written",
                     "is the disk full? choose another folder with --out DIR");
}

}  // namespace upbead
