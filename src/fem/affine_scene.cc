#include "fem/affine_scene.h"

#include <stdexcept>

#include "base/progress.h"
#include "fem/system_scene.h"

namespace upbead {

namespace {

RegionConstants constants_of(const Region& region, const Fluid& fluid, double gravity) {
  const Material m = material(region, fluid, gravity);
  if (region.kind == RegionKind::rigid) return {m, {}, {}};
  const CellKind kind = kind_of(region);
  return {m, impedance(m, kind, false), impedance(m, kind, true)};
}

/// Rayleigh's products of a region, where one of them varies, are all terms of their own: each has one of two factors.
Varied with_products(Varied varied) {
  const auto at = [&varied](Coefficient c) -> bool& { return varied[static_cast<std::size_t>(c)]; };
  const bool stiffness = at(Coefficient::stiffness_damping_G) || at(Coefficient::stiffness_damping_lambda);
  at(Coefficient::stiffness_damping_G) = at(Coefficient::stiffness_damping_lambda) = stiffness;
  return varied;
}

/// Compiles a scene again and again with other constants.
class PartsCompiler {
 public:
  PartsCompiler(const Scene& scene, const Mesh& mesh, const std::vector<bool>& absent, bool with_interface)
      : scene_(as_scene(system_scene(scene))),
        mesh_(mesh),
        space_(mesh, scene_, absent),
        bodies_(rigid_bodies(space_)),
        nodes_(with_interface ? interface_nodes(space_) : std::vector<InterfaceNode>()),
        unknowns_(space_, scene_, bodies_, nodes_) {}

  const std::vector<std::string>& surfaces() const { return mesh_.surfaces; }
  RegionConstants constants(const std::string& surface) const {
    return constants_of(scene_.regions.at(surface), scene_.fluid, scene_.gravity);
  }
  CompiledScene whole(const std::vector<RegionConstants>& constants) const {
    return compile(scene_, space_.with(constants), unknowns_, bodies_, {}, nodes_);
  }
  /// Only what the constants of one region multiply.
  System of_region(const std::string& region, const RegionConstants& constants) const {
    std::vector<RegionConstants> all(surfaces().size());
    AssemblyShare share{{}, false, true};
    for (std::size_t s = 0; s < all.size(); ++s)
      if (surfaces()[s] == region) all[s] = constants;
    for (const auto& cell : mesh_.triangulation.active_cell_iterators())
      share.cells.push_back(mesh_.surface_of(cell) == region);
    return compile(scene_, space_.with(all), unknowns_, bodies_, share, nodes_).system;
  }

 private:
  Scene scene_;
  const Mesh& mesh_;
  Space space_;
  std::vector<Body> bodies_;
  std::vector<InterfaceNode> nodes_;
  Unknowns unknowns_;
};

/// The terms in C alone.
System of_damping(System part) {
  part.M.setZero();
  part.K.setZero();
  for (Reading& reading : part.readings) reading.position = reading.acceleration = {};
  return part;
}

bool is_zero(const System& part) {
  return part.M.nonZeros() + part.C.nonZeros() + part.K.nonZeros() == 0;
}

/// Terms of the fluid alone cancel between two compilations, and must be finite; the direction of flow is no constant
/// that varies.
RegionConstants as_in(const RegionConstants& region, RegionConstants constants) {
  constants.material.rho_f = 1.;
  constants.material.vertical_flow = region.material.vertical_flow;
  return constants;
}

}  // namespace

std::vector<double> AffineScene::factors(const std::map<std::string, Coefficients>& of_region) const {
  std::vector<double> list;
  for (const AffineTerm& term : terms)
    list.push_back(of_region.at(term.region)[static_cast<std::size_t>(term.coefficient)]);
  return list;
}

CompiledScene AffineScene::at(const std::vector<double>& factors) const {
  CompiledScene compiled = fixed;
  compiled.system = AffineSystem{fixed.system, parts}.at(factors);
  return compiled;
}

AffineScene affine_scene(const Scene& scene, const Mesh& mesh, const std::vector<bool>& absent,
                         const std::map<std::string, Varied>& varied, bool with_interface) {
  const PartsCompiler compiler(scene, mesh, absent, with_interface);
  AffineScene out;
  std::vector<RegionConstants> fixed;
  for (const std::string& surface : compiler.surfaces()) {
    fixed.push_back(compiler.constants(surface));
    const auto found = varied.find(surface);
    if (found == varied.end()) continue;
    const Varied here = with_products(found->second);
    fixed.back() = without(fixed.back(), here);
    const RegionConstants own = compiler.constants(surface);
    const System none = compiler.of_region(surface, as_in(own, {}));
    std::array<System, n_coefficients> parts;
    in_parallel(parts.size(), "", [&](std::size_t i) {
      if (!here[i]) return;
      const auto coefficient = static_cast<Coefficient>(i);
      parts[i] = difference(compiler.of_region(surface, as_in(own, unit_constants(coefficient))), none);
      if (is_of_damping(coefficient)) parts[i] = of_damping(std::move(parts[i]));
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!here[i] || is_zero(parts[i])) continue;
      out.terms.push_back({surface, static_cast<Coefficient>(i)});
      out.parts.push_back(std::move(parts[i]));
    }
  }
  out.fixed = with_courses(compiler.whole(fixed), scene);
  return out;
}

}  // namespace upbead
