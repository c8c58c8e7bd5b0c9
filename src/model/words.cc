#include "model/words.h"

#include "material/soil_law.h"

namespace upbead {

const Words<RegionKind> region_kind_words{{"porous", RegionKind::porous},
                                          {"solid", RegionKind::solid},
                                          {"rigid", RegionKind::rigid},
                                          {"water", RegionKind::water}};

const Words<ContactKind> contact_kind_words{{"bonded", ContactKind::bonded}, {"friction", ContactKind::friction}};

const Words<GapSource> gap_source_words{{"pores", GapSource::pores}, {"sea", GapSource::sea}};

const Words<SoilLaw> soil_law_words = [] {
  Words<SoilLaw> words{{"elastic", SoilLaw::elastic}};
  for (const SoilLawRow* row : soil_law_rows()) words.emplace_back(row->word, static_cast<SoilLaw>(words.size()));
  return words;
}();

const Words<RestStart> rest_start_words{
    {"k0", RestStart::k0}, {"virgin", RestStart::virgin}, {"gravity", RestStart::gravity}};

const Words<Flow> flow_words{
    {"auto", Flow::automatic}, {"darcy", Flow::darcy}, {"inertial", Flow::inertial}, {"drained", Flow::drained}};

const Words<Deformation> deformation_words{
    {"auto", Deformation::automatic}, {"elastic", Deformation::elastic}, {"rigid", Deformation::rigid}};

const Words<Compressibility> compressibility_words{{"auto", Compressibility::automatic},
                                                   {"compressible", Compressibility::compressible},
                                                   {"incompressible", Compressibility::incompressible}};

const Words<DisplacementCondition> displacement_words{
    {"fixed", DisplacementCondition::fixed}, {"roller", DisplacementCondition::roller},
    {"free", DisplacementCondition::free},   {"absorbing", DisplacementCondition::absorbing},
    {"plate", DisplacementCondition::plate}, {"level", DisplacementCondition::level}};

const Words<PressureCondition> pressure_words{{"sealed", PressureCondition::sealed},
                                              {"open", PressureCondition::open},
                                              {"absorbing", PressureCondition::absorbing},
                                              {"surface_waves", PressureCondition::surface_waves}};

const Words<PulseShape> pulse_shape_words{{"triangle", PulseShape::triangle},
                                          {"step", PulseShape::step},
                                          {"half_sine", PulseShape::half_sine},
                                          {"church_roof", PulseShape::church_roof},
                                          {"harmonic", PulseShape::harmonic}};

const Words<LoadKind> load_kind_words{{"force", LoadKind::force},           {"traction", LoadKind::traction},
                                      {"normal", LoadKind::normal},         {"pressure", LoadKind::pressure},
                                      {"pressures", LoadKind::pressures},   {"wave", LoadKind::wave},
                                      {"train", LoadKind::train},           {"displacement", LoadKind::displacement},
                                      {"velocity", LoadKind::velocity},     {"acceleration", LoadKind::acceleration},
                                      {"body_force", LoadKind::body_force}, {"gravity", LoadKind::gravity},
                                      {"source", LoadKind::source}};

const Words<TimeScheme> time_scheme_words{{"auto", TimeScheme::automatic},
                                          {"generalised_alpha", TimeScheme::generalised_alpha},
                                          {"sdirk4", TimeScheme::sdirk4},
                                          {"reduced", TimeScheme::reduced}};

const Words<RayleighFit> rayleigh_fit_words{{"ends", RayleighFit::ends}, {"band", RayleighFit::band}};

const Words<UpliftKind> uplift_kind_words{
    {"prescribed", UpliftKind::prescribed}, {"computed", UpliftKind::computed}, {"wave", UpliftKind::wave}};

const Words<UpliftCourse> uplift_course_words{{"held", UpliftCourse::held}, {"in_phase", UpliftCourse::in_phase}};
const Words<UpliftDistribution> uplift_distribution_words{{"triangle", UpliftDistribution::triangle},
                                                          {"uniform", UpliftDistribution::uniform}};

}  // namespace upbead
