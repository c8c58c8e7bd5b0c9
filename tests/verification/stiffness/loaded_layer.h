// A layer on a rough rigid base under a uniform strip load: one half of it, x >= 0, the surface at y = 0.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference.h"
#include "scenes.h"

namespace upbead::test {

struct LoadedLayer {
  double half_width;  ///< b of the load (m)
  double depth;       ///< H (m)
  double far = 8.;    ///< distance of the far side over H: motions die as exp(-pi x / (2 H)) or faster
};

/// A mesh of these lines, x from 0 on and y up to 0; curves: strip, outside, base, axis, far.
std::unique_ptr<Mesh> layer_mesh(const LoadedLayer& layer, const std::vector<double>& x, const std::vector<double>& y);

/// Cells of the size `edge` at the load's edge and at the surface that grow up to `largest`, and beside the load up to
/// four times that.
std::unique_ptr<Mesh> graded_layer_mesh(const LoadedLayer& layer, double edge, double growth, double largest);

/// Square cells of the size b / n within 3 b of the axis, growing beyond; they are stretched so that they fit the
/// depth.
std::unique_ptr<Mesh> even_layer_mesh(const LoadedLayer& layer, int n);

/// Soil under a load of q (Pa) from t = 0 on; `surface`: condition of the pore water at the surface, none for a
/// solid. Rollers and sealed at the axis and at the far side.
Scene loaded_layer(const Region& soil, double q, const std::optional<PressureCondition>& surface);

/// Adds probes PREFIX0, PREFIX1, ... at these points of the axis (depths) or of the surface.
void add_probes_at_depths(Scene& scene, const std::string& prefix, const std::vector<double>& depths);
void add_probes_on_surface(Scene& scene, const std::string& prefix, const std::vector<double>& x);

/// The test of tests/reference/ref9_stress.json with that id.
Json stress_test(const std::string& id);

/// Column `i` of a table of rows.
std::vector<double> column_of(const Json& rows, std::size_t i);

}  // namespace upbead::test
