#include "scale_mesh.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "mesh/geo_parameters.h"
#include "upbead/mesh/mesh.h"

namespace upbead {

namespace {

/// "m" of "m: height of the mound".
std::string unit_of(const GeoParameter& parameter) {
  const std::size_t colon = parameter.description.find(':');
  if (colon == std::string::npos) throw std::invalid_argument("its comment names no unit");
  return parameter.description.substr(0, colon);
}

/// The geometry's own value.
double value_of(const GeoParameter& parameter) {
  char* end = nullptr;
  const double value = std::strtod(parameter.default_value.c_str(), &end);
  if (parameter.default_value.empty() || *end != '\0')
    throw std::invalid_argument("its default '" + parameter.default_value + "' is no number");
  return value;
}

}  // namespace

void scale_mesh(const Case& problem, const ScaleOptions& options, Ratios& ratios, MeshChoice& mesh) {
  const MeshRequest request = mesh_request(problem);
  if (std::filesystem::path(request.file).extension() == ".msh")
    throw InputError(request.place, "a finished mesh (.msh) cannot be scaled", "name the .geo that made it");
  Mistakes mistakes;
  bool has_length = false;
  for (const GeoParameter& parameter : geo_parameters(request.file)) try {
      const double exponent = froude_exponent(unit_of(parameter));
      const double* ratio = ratios.find(dotted("mesh.parameters", parameter.name));
      has_length = has_length || exponent != 0.;
      if (exponent == 0. && ratio == nullptr) continue;
      const auto given = mesh.parameters.find(parameter.name);
      const double value = given == mesh.parameters.end() ? value_of(parameter) : given->second;
      mesh.parameters[parameter.name] = value * (ratio != nullptr ? *ratio : std::pow(options.factor, exponent));
    } catch (const std::invalid_argument& error) {
      mistakes.add(request.place,
                   "the parameter '" + parameter.name + "' of " + request.file + " cannot be scaled: " + error.what(),
                   "begin the comment behind its number with its unit, such as // m: height of the mound, or // -: for "
                   "a number without one");
    }
  if (mistakes.empty() && !has_length)
    mistakes.add(request.place, request.file + " cannot be scaled: no parameter of it is a length",
                 "make its lengths parameters (DefineConstant) with // m: comments");
  mistakes.throw_if_any();
}

}  // namespace upbead
