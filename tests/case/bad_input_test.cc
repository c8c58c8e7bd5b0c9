// Claim: every key that is unknown, missing, of the wrong type or out of its range is reported with its place, the
// key, what was expected and a cure.
#include "bad_case.h"

namespace upbead::test {
namespace bad_input_test {

class BadInput : public BadCaseTest {};

TEST_P(BadInput, IsExplained) {
  check();
}

const std::vector<BadCase> rows{
    BadCase{"NumberForARegion", "[regions.block]", "[regions]\nslab = 3\n[regions.block]",
            "case.toml:28:1: regions.slab: expected a table, found the number 3; write [regions.slab] and its keys"},
    BadCase{"UnknownKey", "porosity = 0.4", "porosty = 0.4",
            "case.toml:14:10: [regions.rubble]: 'porosity' is missing, which a porous region needs; add porosity\n"
            "case.toml:18:1: unknown key 'porosty' in [regions.rubble]; did you mean 'porosity'?"},
    BadCase{"UnknownKeyFarFromAny", "refine = 1", "colour = 1",
            "case.toml:11:1: unknown key 'colour' in [mesh]; known keys: geometry, file, parameters, refine, degree, "
            "full_domain"},
    BadCase{"UnknownTable", "[accuracy]", "[acuracy]",
            "case.toml:73:2: unknown key 'acuracy' at the top of the file; did you mean 'accuracy'?"},
    BadCase{
        "UnknownKeyAtTheTop", "title = \"prototype\"", "name = \"prototype\"",
        "case.toml:1:1: unknown key 'name' at the top of the file; known keys: title, gravity, fluid, mesh, "
        "regions, boundaries, loads, section, duration, combined, initial, construction, time, accuracy, probes, "
        "measured, "
        "output, sliding, cycles, limits, report, levels, ground, waves, sea, storms, life, scatter, dynamics, impact, "
        "calibration, reliability"},
    BadCase{"KeyOfAnotherKind", "boundary = \"front\"", "gauges = \"g.csv\"\nboundary = \"front\"",
            "case.toml:47:1: 'gauges' does not belong in [loads.impact] (only where kind = \"pressures\"); remove it"},
    BadCase{
        "TableOfNone", "[output]", "[harbour]\nfriction = 0.6\n[output]",
        "case.toml:79:2: unknown key 'harbour' at the top of the file; known keys: title, gravity, fluid, mesh, "
        "regions, boundaries, loads, section, duration, combined, initial, construction, time, accuracy, probes, "
        "measured, "
        "output, sliding, cycles, limits, report, levels, ground, waves, sea, storms, life, scatter, dynamics, impact, "
        "calibration, reliability"},
    BadCase{"StringForANumber", "shear_modulus = 100e6", "shear_modulus = \"stiff\"",
            "case.toml:16:1: shear_modulus: expected a number (Pa), found a string; give the shear modulus G of the "
            "skeleton (Pa)"},
    BadCase{"NumberInQuotes", "shear_modulus = 100e6", "shear_modulus = \"100e6\"",
            "case.toml:16:1: shear_modulus: expected a number (Pa), found a string; write the number without quotes"},
    BadCase{"NumberForAString", "title = \"prototype\"", "title = 3",
            "case.toml:1:1: title: expected a string, found the number 3; give the title of the case"},
    BadCase{"DateForANumber", "end = 2", "end = 2024-01-01",
            "case.toml:67:1: end: expected a number (s), found a date or time; give the end of the computed time (s)"},
    BadCase{
        "FractionForAWholeNumber", "refine = 1", "refine = 1.5",
        "case.toml:11:1: refine: expected a whole number or \"auto\", found the number 1.5; give the number of uniform "
        "refinements"},
    BadCase{"NumberForABoolean", "inertia = true", "inertia = 1",
            "case.toml:70:1: inertia: expected true or false, found the number 1; write true or false"},
    BadCase{
        "NumberForAPair", "at = [0.0, -5.0]", "at = -5.0",
        "case.toml:77:1: at: expected a pair of numbers (m), found the number -5.0; give the point (x, y) to read (m)"},
    BadCase{"TripleForAPair", "at = [0.0, -5.0]", "at = [0.0, -5.0, 1.0]",
            "case.toml:77:1: at: expected a pair of numbers (m), found a list of 3; give the point (x, y) to read (m)"},
    BadCase{"StringInAPair", "at = [0.0, -5.0]", "at = [0.0, \"deep\"]",
            "case.toml:77:12: at: expected a pair of numbers (m), found a string; give the point (x, y) to read (m)"},
    BadCase{"PairForAListOfPairs", "shape = [[6.0, 1.0], [26.0, 0.5]]", "shape = [6.0, 1.0]",
            "case.toml:50:10: shape: expected a pair of numbers, found the number 6.0; give the pairs of height y (m) "
            "and relative intensity\n"
            "case.toml:50:15: shape: expected a pair of numbers, found the number 1.0; give the pairs of height y (m) "
            "and relative intensity"},
    BadCase{"NumberForATable", "damping = { ratio = 0.05, frequencies = [1.0, 8] }", "damping = 0.05",
            "case.toml:25:1: regions.rubble.damping: expected a table, found the number 0.05; write "
            "[regions.rubble.damping] and its keys"},
    BadCase{"NumberForAMapOfTables", "[probes.A]\nat = [0.0, -5.0]", "[probes]\nA = 3",
            "case.toml:77:1: probes.A: expected a table, found the number 3; write [probes.A] and its keys"},
    BadCase{"StringForAParameter", "mound_height = 6", "mound_height = \"6\"",
            "case.toml:10:16: mound_height: expected a number, found a string; write the number without quotes"},
    BadCase{"NumberForAWord", "kind = \"porous\"", "kind = 1",
            "case.toml:15:1: kind: expected one of porous, solid, rigid, water, found the number 1; write kind = "
            "\"porous\""},
    BadCase{"WordNearAnother", "kind = \"porous\"", "kind = \"porus\"",
            "case.toml:15:1: kind = \"porus\" is none of porous, solid, rigid, water; did you mean 'porous'?"},
    BadCase{"WordOutOfAList", "displacement = \"roller\"", "displacement = \"sliding\"",
            "case.toml:40:1: displacement = \"sliding\" is none of fixed, roller, free, absorbing, plate, level; "
            "choose one of them"},
    BadCase{"WordForAStep", "step = 0.001", "step = \"automatic\"",
            "case.toml:68:1: step: expected a number (s) or \"auto\", found a string; give the time step (s)"},
    BadCase{"OutOfRangeAtItsEnd", "poissons_ratio = 0.3", "poissons_ratio = 0.5",
            "case.toml:17:1: poissons_ratio = 0.5 is outside [0, 0.5); give the Poisson ratio of the drained skeleton"},
    BadCase{"NegativeModulus", "shear_modulus = 100e6", "shear_modulus = -1",
            "case.toml:16:1: shear_modulus = -1 is outside (0, inf); give the shear modulus G of the skeleton (Pa)"},
    BadCase{"PorosityInPercent", "porosity = 0.4", "porosity = 40",
            "case.toml:18:1: porosity = 40 is outside (0, 1); give the share of the pores in the volume"},
    BadCase{"ZeroConductivity", "hydraulic_conductivity = 0.1", "hydraulic_conductivity = 0.0",
            "case.toml:20:1: hydraulic_conductivity = 0 is outside (0, inf); give the hydraulic conductivity k (m/s)"},
    BadCase{"NotANumber", "tortuosity = 1.2", "tortuosity = nan",
            "case.toml:22:1: tortuosity = nan is outside [1, inf); give the tortuosity of the pores"},
    BadCase{"InfiniteWhereNotAllowed", "shear_modulus = 100e6", "shear_modulus = inf",
            "case.toml:16:1: shear_modulus = inf is outside (0, inf); give the shear modulus G of the skeleton (Pa)"},
    BadCase{"MinusInfinity", "grain_bulk_modulus = 3.6e10", "grain_bulk_modulus = -inf",
            "case.toml:24:1: grain_bulk_modulus = -inf is outside (0, inf]; give the bulk modulus of the grains (Pa)"},
    BadCase{"BiotAboveOne", "biot = 0.9", "biot = 1.1",
            "case.toml:23:1: biot = 1.1 is outside [0, 1]; give the Biot coefficient alpha"},
    BadCase{"ZeroFluidModulus", "bulk_modulus = inf", "bulk_modulus = 0",
            "case.toml:6:1: bulk_modulus = 0 is outside (0, inf]; give the bulk modulus of the water (Pa)"},
    BadCase{"DegreeFour", "degree = 3", "degree = 4",
            "case.toml:12:1: degree = 4 is outside [2, 3]; give the polynomial degree of the displacement"},
    BadCase{"EndNotPositive", "end = 2", "end = 0",
            "case.toml:67:1: end = 0 is outside (0, inf); give the end of the computed time (s)"},
    BadCase{"ReducedModelKeepsNoEnergy", "scheme = \"sdirk4\"", "scheme = \"reduced\"",
            "case.toml:69:1: scheme = \"reduced\" cannot do what the case asks for: it keeps no account of "
            "energy to stop by; write scheme = \"auto\""},
    BadCase{"EnergyNotBelowOne", "stop_at_energy = 1e-4", "stop_at_energy = 1.0",
            "case.toml:71:1: stop_at_energy = 1 is outside (0, 1); give the share of the largest energy"},
    BadCase{"ToleranceZero", "tolerance = 0.01", "tolerance = 0",
            "case.toml:74:1: tolerance = 0 is outside (0, 1); give the error allowed in the shear force F_T, over its "
            "largest"},
    BadCase{"NegativeFrequency", "frequencies = [1.0, 8]", "frequencies = [-1.0, 8]",
            "case.toml:25:42: frequencies = -1 is outside (0, inf); give the two frequencies, ascending, at or between "
            "which the ratio holds (Hz)"},
    BadCase{"PulseWithoutShape", "shape = \"church_roof\"\n", "",
            "case.toml:52:15: 'shape' is missing in [loads.impact.pulse]; add shape, one of triangle, step, half_sine, "
            "church_roof, harmonic"},
    BadCase{"PulseWithoutPeak", "peak = 2e6\n", "",
            "case.toml:52:15: 'peak' is missing in [loads.impact.pulse]; add peak, a number (N/m or Pa)\n"
            "case.toml:52:15: [loads.impact]: peak is zero, so there is no load; give the largest value"},
    BadCase{"NegativeStart", "start = 0.01", "start = -0.01",
            "case.toml:57:1: start = -0.01 is outside [0, inf); give the time of the start (s)"},
    BadCase{"RegionWithoutPoint", "at = [-9.0, 16.0]\n", "",
            "case.toml:61:8: 'at' is missing in [loads.gauge]; add at, a pair of numbers (m)"},
    BadCase{"ProbeWithoutPoint", "at = [0.0, -5.0]\n", "",
            "case.toml:76:9: 'at' is missing in [probes.A]; add at, a pair of numbers (m)"},
    BadCase{"FieldsWithoutInterval", "fields = { every = 0.02 }", "fields = {}",
            "case.toml:80:1: 'every' is missing in [output.fields]; add every, a number (s)"},
    BadCase{"TimesOutOfOrder", "fields = { every = 0.02 }", "times = [0.2, 0.1]",
            "case.toml:80:1: times do not ascend: 0.1 follows 0.2; order them, each once"},
    BadCase{"TimesAfterTheEnd", "fields = { every = 0.02 }", "times = [0.2, 3]",
            "case.toml:80:1: times = [..., 3] lies after time.end = 2; give times (s) up to the end, or a later end"},
    BadCase{"TimeZero", "fields = { every = 0.02 }", "times = [0]",
            "case.toml:80:10: times = 0 is outside (0, inf); give the times at which all readings are written to "
            "times.csv and /at_times of results.h5, and, with fields, these are written (s)"},
    BadCase{"NotToml", "gravity = 9.8", "gravity = ",
            "case.toml:2:11: not TOML: Error while parsing key-value pair: expected value, saw '\\n'; see "
            "https://toml.io for the syntax"},
    BadCase{"DuplicateTable", "[probes.A]", "[time]",
            "case.toml:76:1: not TOML: Error while parsing table header: cannot redefine existing table 'time'; see "
            "https://toml.io for the syntax"},
    BadCase{"TwoMistakesInTheOrderOfTheFile", "degree = 3\n\n[regions.rubble]\nkind = \"porous\"",
            "degre = 3\n\n[regions.rubble]\nkind = \"sand\"",
            "case.toml:12:1: unknown key 'degre' in [mesh]; did you mean 'degree'?\n"
            "case.toml:15:1: kind = \"sand\" is none of porous, solid, rigid, water; choose one of them"},
    BadCase{"WrongTypeIsNotMissing", "porosity = 0.4\n", "porosity = \"high\"\n",
            "case.toml:18:1: porosity: expected a number, found a string; give the share of the pores in the volume"},
};

INSTANTIATE_TEST_SUITE_P(, BadInput, testing::ValuesIn(rows), name_of);

}  // namespace bad_input_test
}  // namespace upbead::test
