// The words of the case file for all choices of a scene; messages use them too.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "upbead/model/scene.h"

namespace upbead {

template <class Enum>
using Words = std::vector<std::pair<std::string, Enum>>;

extern const Words<RegionKind> region_kind_words;
extern const Words<ContactKind> contact_kind_words;
extern const Words<GapSource> gap_source_words;
extern const Words<SoilLaw> soil_law_words;
extern const Words<RestStart> rest_start_words;
extern const Words<Flow> flow_words;
extern const Words<Deformation> deformation_words;
extern const Words<Compressibility> compressibility_words;
extern const Words<DisplacementCondition> displacement_words;
extern const Words<PressureCondition> pressure_words;
extern const Words<PulseShape> pulse_shape_words;
extern const Words<LoadKind> load_kind_words;
extern const Words<TimeScheme> time_scheme_words;
extern const Words<RayleighFit> rayleigh_fit_words;
extern const Words<UpliftKind> uplift_kind_words;
extern const Words<UpliftCourse> uplift_course_words;
extern const Words<UpliftDistribution> uplift_distribution_words;

template <class Enum>
std::string word_of(Enum value, const Words<Enum>& words) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return word;
  return "";
}

}  // namespace upbead
