// One reduced model for a box of soils in one HDF5 file.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "dynamics/reduced_family.h"
#include "fem/coefficients.h"
#include "upbead/dynamics/modal_response.h"
#include "upbead/output/model_file.h"

namespace upbead {

/// A key of the case that varies, and how far.
struct SoilAxis {
  std::string key;  ///< dotted, such as regions.seabed.shear_modulus
  double low = 0., high = 0.;
  bool logarithmic = false;  ///< whether soils are spread over its logarithm
};

/// A family of reduced models, how its members are reduced further, and how it was made.
struct SoilFamilyFile {
  std::vector<AffineTerm> terms;   ///< by part of `reduced`: what multiplies it
  ReducedFamily reduced;           ///< its `shift` is that of a member's own reduction, too
  std::vector<ReadingName> names;  ///< of its readings
  SampledLoads training;           ///< histories of the bonded scene, under which a member is reduced
  double tolerance = 0.;           ///< of a member's own reduction, of F_T over its peak
  Eigen::MatrixXd factors;         ///< of the soils that were solved (rows), by part
  FieldBasis phi;                  ///< of `reduced`, in unknowns of the scene; empty where it is not kept
  std::vector<double> estimates;   ///< largest estimate over the candidates, after each round of points
};

/// Everything that `respond` needs for any soil of the box.
struct SoilModelFile {
  ReducedModelFile frame;  ///< of the first soil; all but `modes`, `nested` and errors holds for the others, too
  std::vector<SoilAxis> box;
  /// gravity, [fluid] and [regions] of the scene with all choices made, as TOML: from these follow the coefficients of
  /// any soil.
  std::string regions_text;
  SoilFamilyFile family;
  Eigen::MatrixXd points;  ///< soils that were solved (rows), by axis of the box
};

/// The bytes of the file. Throws NumericsError where a number is not finite, std::logic_error where a matrix of the
/// family is not symmetric.
std::string soil_model_file(const SoilModelFile& model);

/// Reads such a file. Throws InputError where it cannot be read, is no such model, or is incomplete; the text of the
/// regions is not looked at.
SoilModelFile read_soil_model_file(const std::string& path);

/// The bytes of a family alone, as processes of a study hand it on. `made_for`: a fingerprint of what it was made for.
std::string soil_family_file(const SoilFamilyFile& family, const std::string& made_for);

/// Reads such a file; none where it was made for something else. Throws InputError as above.
std::optional<SoilFamilyFile> read_soil_family_file(const std::string& path, const std::string& made_for);

/// Reads a file of either kind of model.
std::variant<ReducedModelFile, SoilModelFile> read_any_model_file(const std::string& path);

/// A family's System without matrices, for as_system(): loads and readings with their names, those of the slip left
/// out.
System bonded_names(const SoilFamilyFile& family);
/// The same with those of the slip.
System slipping_names(const SoilFamilyFile& family);

}  // namespace upbead
