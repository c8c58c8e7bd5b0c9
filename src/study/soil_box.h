// The box of soils of a model: the tables [vary] of a study, whose values are taken as ranges.
#pragma once

#include <string>
#include <vector>

#include "output/soil_model_file.h"
#include "soils/soil_text.h"
#include "study/study.h"

namespace upbead {

/// Reads the tables [vary] of a study file, or of a file with such tables alone: from the least to the largest value of
/// a list, a range or a uniform distribution, and three standard deviations to both sides of the mean of a normal or
/// log-normal one. Throws InputError with every mistake, such as a key that is none of a soil.
std::vector<SoilAxis> read_soil_box(const std::string& path);

/// A soil as settings of a case.
std::vector<Setting> settings_of(const Soil& soil);

/// The soils at which numbers of one region reach the ends of the box, all others being those of the case: region by
/// region, as each decides by its own numbers.
std::vector<std::vector<Setting>> corners_by_region(const std::vector<SoilAxis>& box);

}  // namespace upbead
