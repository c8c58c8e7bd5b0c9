// Claim: keys that contradict each other or are missing for their kind, in regions, mesh, time and probes, are
// reported.
#include "bad_case.h"

namespace upbead::test {
namespace bad_regions_test {

class BadRegions : public BadCaseTest {};

TEST_P(BadRegions, IsExplained) {
  check();
}

const std::vector<BadCase> rows{
    BadCase{"BiotBelowPorosity", "biot = 0.9", "biot = 0.3",
            "case.toml:23:1: [regions.rubble]: biot is less than the porosity, and the grains are compressible; give a "
            "Biot coefficient within "
            "[porosity, 1], or leave out grain_bulk_modulus"},
    BadCase{"StepBeyondTheEnd", "step = 0.001", "step = 3",
            "case.toml:68:1: step = 3 is longer than end = 2; give a shorter step (s), or \"auto\""},
    BadCase{"DescendingFrequencies", "frequencies = [1.0, 8]", "frequencies = [8, 1.0]",
            "case.toml:25:1: [regions.rubble]: the two frequencies of damping do not ascend; give the lower one first, "
            "such as [1.0, 10.0]"},
    BadCase{"MissingKind", "kind = \"porous\"\n", "",
            "case.toml:14:10: 'kind' is missing in [regions.rubble]; add kind, one of porous, solid, rigid, water"},
    BadCase{"MissingPorosity", "porosity = 0.4\n", "",
            "case.toml:14:10: [regions.rubble]: 'porosity' is missing, which a porous region needs; add porosity"},
    BadCase{"MissingConductivity", "hydraulic_conductivity = 0.1\n", "",
            "case.toml:14:10: [regions.rubble]: 'hydraulic_conductivity' is missing, which a porous region needs; add "
            "hydraulic_conductivity"},
    BadCase{"MissingModulus", "shear_modulus = 100e6\n", "",
            "case.toml:14:10: [regions.rubble]: neither 'shear_modulus' nor 'youngs_modulus' is given, one of which a "
            "porous region needs; add shear_modulus or youngs_modulus"},
    BadCase{"BothModuli", "shear_modulus = 100e6", "shear_modulus = 100e6\nyoungs_modulus = 260e6",
            "case.toml:17:1: [regions.rubble]: both 'shear_modulus' and 'youngs_modulus' are given; keep one of them"},
    BadCase{"MissingDensityOfASolid", "density = 2400\n", "",
            "case.toml:27:10: [regions.block]: 'density' is missing, which a solid region needs; add density"},
    BadCase{"NeitherDensityNorMass", "mass = 756e3\n", "",
            "case.toml:33:10: [regions.caisson]: neither 'density' nor 'mass' is given, one of which a rigid region "
            "needs; add density or mass"},
    BadCase{"DensityAndMass", "mass = 756e3", "mass = 756e3\ndensity = 2100",
            "case.toml:35:1: [regions.caisson]: both 'density' and 'mass' are given; keep one of them"},
    BadCase{"PorosityOfARigidRegion", "mass = 756e3", "mass = 756e3\nporosity = 0.3",
            "case.toml:36:1: 'porosity' does not belong in [regions.caisson] (only in porous regions); remove it"},
    BadCase{"DefaultGivenWhereItDoesNotBelong", "density = 2400", "density = 2400\ntortuosity = 1.0",
            "case.toml:32:1: 'tortuosity' does not belong in [regions.block] (only in porous regions); remove it"},
    BadCase{
        "DampingOfARigidRegion", "mass = 756e3", "mass = 756e3\ndamping = { ratio = 0.05 }",
        "case.toml:36:1: 'damping' does not belong in [regions.caisson] (only in porous and solid regions); remove it"},
    BadCase{"InertialFlowWithoutInertia", "inertia = true", "inertia = false",
            "case.toml:21:1: flow = \"inertial\" contradicts time.inertia = false; write flow = \"auto\" or inertia = "
            "true"},
    BadCase{"GeometryAndFile", "geometry = \"composite\"", "geometry = \"composite\"\nfile = \"my.msh\"",
            "case.toml:10:1: both 'geometry' and 'file' are given in [mesh]; keep one of them"},
    BadCase{"NeitherGeometryNorFile", "geometry = \"composite\"\n", "",
            "case.toml:8:2: neither 'geometry' nor 'file' is given in [mesh]; add geometry = \"composite\", or file = "
            "the path of a mesh"},
    BadCase{"UnknownGeometry", "geometry = \"composite\"", "geometry = \"compsite\"",
            "case.toml:9:1: there is no geometry 'compsite'; did you mean 'composite'?"},
    BadCase{"GeometryFarFromAny", "geometry = \"composite\"", "geometry = \"wedge\"",
            "case.toml:9:1: there is no geometry 'wedge'; known geometries: column, composite"},
    BadCase{"ParametersOfAMesh", "geometry = \"composite\"", "file = \"my.msh\"",
            "case.toml:10:1: 'parameters' are those of a .geo, a .msh has none; remove parameters, or give the .geo as "
            "file"},
    BadCase{"ProbeNameWithASlash", "[probes.A]", "[probes.\"A/B\"]",
            "case.toml:76:9: probe \"A/B\" cannot name a dataset of the results; use letters, digits, _ and -"},
    BadCase{"TwoMistakesInOneRegion", "porosity = 0.4\ngrain_density = 2650\n", "porosity = 40\n",
            "case.toml:14:10: [regions.rubble]: 'grain_density' is missing, which a porous region needs; add "
            "grain_density\n"
            "case.toml:18:1: porosity = 40 is outside (0, 1); give the share of the pores in the volume"},
};

INSTANTIATE_TEST_SUITE_P(, BadRegions, testing::ValuesIn(rows), name_of);

}  // namespace bad_regions_test
}  // namespace upbead::test
