// One reduced model for a box of soils, and the reduced model of each of them.
#pragma once

#include <string>
#include <vector>

#include "output/soil_model_file.h"
#include "soils/soil_text.h"

namespace upbead {

/// The reduced model of a soil, and what tells the errors of its readings.
struct AnsweredSoil {
  ReducedModelFile model;
  /// The same soil in half of the directions, with F_T and the readings that were asked for: the difference of a
  /// history, times nested_safety, is an estimate of its error, which was tested for F_T alone (docs/soils.md).
  ModalModel fewer;
};

/// Makes the reduced model of any soil of a box from the file of a family.
class SoilAnswers {
 public:
  /// `path`: of the file, for messages. Throws InputError where the texts of the file do not fit its numbers.
  SoilAnswers(SoilModelFile file, std::string path);

  const SoilModelFile& file() const { return file_; }
  /// All keys of the box, those that are not given with the case's value. Throws InputError where one lies outside the
  /// box, or is none of its keys.
  Soil whole(const Soil& given) const;
  /// Coefficients by part. `whole`: has all keys of the box.
  std::vector<double> factors(const Soil& whole) const;
  /// A model as `upbead reduce` makes it, for a soil that has all keys of the box. Its `nested` are the member itself
  /// as the reference and the member in fewer coordinates as the middle model, so that the error of each wave is
  /// estimated as in docs/soils.md. Throws NumericsError where the member does not reduce.
  ReducedModelFile at(const Soil& whole) const { return member(whole, {}).model; }
  /// The same, where other readings meet the tolerance of F_T, too, in the member's own reduction. Throws
  /// std::out_of_range where the model lacks one.
  AnsweredSoil member(const Soil& whole, const std::vector<std::string>& readings) const;
  /// The unit of a key of the box.
  std::string unit(const std::string& key) const { return text_.unit(key); }
  /// Labels of the readings of any soil.
  std::vector<ReadingLabel> readings() const;
  /// "regions.seabed.shear_modulus from 1e6 to 1e8, ...".
  std::string box_text() const;

 private:
  SoilModelFile file_;
  std::string path_;
  SoilText text_;
  System like_;  ///< see without_matrices()
};

/// Soil number `draw` of many at random, uniform over the box or over the logarithms of its keys.
Soil drawn_soil(const std::vector<SoilAxis>& box, int draw);

/// "regions.seabed.shear_modulus = 25000000, ...".
std::string soil_in_words(const Soil& soil);

/// Soils as options tell them, KEY=NUMBER; `before`: what stands before each where it is written. Throws InputError.
Soil soil_of_options(const std::vector<std::string>& options, const std::string& before = "--soil ");

}  // namespace upbead
