// Claim: loads that act on nothing, have no history or two, or a pulse with contradictory keys, are reported.
#include "bad_case.h"

namespace upbead::test {
namespace bad_loads_test {

class BadLoads : public BadCaseTest {};

TEST_P(BadLoads, IsExplained) {
  check();
}

const std::vector<BadCase> rows{
    BadCase{"BoundaryAndRegion", "boundary = \"front\"", "boundary = \"front\"\nregion = \"caisson\"\nat = [0.0, 1.0]",
            "case.toml:48:1: [loads.impact]: both 'boundary' and 'region' are given; keep one of them"},
    BadCase{"NeitherBoundaryNorRegion", "boundary = \"front\"\n", "",
            "case.toml:46:8: [loads.impact]: neither 'boundary' nor 'region' is given; add boundary or region"},
    BadCase{
        "RowWithoutPeriod", "start = 0.01", "start = 0.01\nnumber = 5",
        "case.toml:52:15: [loads.impact]: 'period' is missing, which number > 1 needs; add period, from one pulse to "
        "the next (s)"},
    BadCase{"RowOfOverlappingPulses", "start = 0.01", "start = 0.01\nnumber = 5\nperiod = 2.0",
            "case.toml:59:1: [loads.impact]: period = 2 s is shorter than a pulse, 3 s; give at least that"},
    BadCase{
        "UnknownBoundary", "boundary = \"front\"", "boundary = \"frnt\"",
        "case.toml:47:1: [loads.impact]: boundary = \"frnt\" has no table [boundaries.frnt]; did you mean 'front'?"},
    BadCase{"UnknownRegion", "region = \"caisson\"", "region = \"pier\"",
            "case.toml:62:1: [loads.gauge]: region = \"pier\" has no table [regions.pier]; known regions: block, "
            "caisson, rubble"},
    BadCase{"LoadOnASoftRegion", "region = \"caisson\"", "region = \"block\"",
            "case.toml:62:1: [loads.gauge]: region = \"block\" is not rigid; load one of its boundaries instead; only "
            "a rigid region takes a load at a point"},
    BadCase{"PressureOnARegion", "at = [-9.0, 16.0]", "at = [-9.0, 16.0]\nkind = \"pressure\"",
            "case.toml:64:1: [loads.gauge]: a load on a region is a force, no traction or pressure; write kind = "
            "\"force\""},
    BadCase{"PointOnABoundary", "boundary = \"front\"", "boundary = \"front\"\nat = [0.0, 1.0]",
            "case.toml:48:1: 'at' does not belong in [loads.impact] (only for a force on a region); remove "
            "it"},
    BadCase{"DirectionOfAPressure", "kind = \"force\"", "kind = \"pressure\"",
            "case.toml:49:1: 'direction' does not belong in [loads.impact] (only for forces, tractions, "
            "motions and body forces); remove it"},
    BadCase{
        "GravityOnABoundary", "kind = \"force\"\ndirection = [1.0, 0.5]\nshape = [[6.0, 1.0], [26.0, 0.5]]",
        "kind = \"gravity\"",
        "case.toml:47:1: [loads.impact]: kind = \"gravity\" acts on the volume of a region; remove boundary, and give "
        "region, or neither for all of them"},
    BadCase{"SourceNowhere",
            "boundary = \"front\"\nkind = \"force\"\ndirection = [1.0, 0.5]\nshape = [[6.0, 1.0], [26.0, 0.5]]",
            "kind = \"source\"",
            "case.toml:46:8: [loads.impact]: 'region' is missing, which kind = \"source\" needs; add region"},
    BadCase{"BodyForceAtAPoint", "at = [-9.0, 16.0]", "at = [-9.0, 16.0]\nkind = \"body_force\"",
            "case.toml:63:1: 'at' does not belong in [loads.gauge] (only for a force on a region); remove it"},
    BadCase{"DirectionZero", "direction = [1.0, 0.5]", "direction = [0, 0.0]",
            "case.toml:49:1: [loads.impact]: direction is zero; give a direction such as [1.0, 0.0]"},
    BadCase{"ShapeDescends", "[[6.0, 1.0], [26.0, 0.5]]", "[[26.0, 1.0], [6.0, 0.5]]",
            "case.toml:50:1: [loads.impact]: the heights of shape do not ascend; order the pairs by height"},
    BadCase{"ShapeAllZero", "[[6.0, 1.0], [26.0, 0.5]]", "[[6.0, 0.0], [26.0, 0.0]]",
            "case.toml:50:1: [loads.impact]: every intensity of shape is zero; give an intensity other than zero"},
    BadCase{"ShapeOfOnePair", "[[6.0, 1.0], [26.0, 0.5]]", "[[6.0, 1.0]]",
            "case.toml:50:1: [loads.impact]: one pair of height and intensity makes no shape; give two pairs or more"},
    BadCase{"PulseAndHistory", "history = \"force.csv\"",
            "history = \"force.csv\"\npulse = { shape = \"step\", peak = 1.0 }",
            "case.toml:64:1: [loads.gauge]: both 'pulse' and 'history' are given; keep one of them"},
    BadCase{"NeitherPulseNorHistory", "history = \"force.csv\"\n", "",
            "case.toml:61:8: [loads.gauge]: neither 'pulse' nor 'history' is given; add pulse or history"},
    BadCase{"PeakZero", "peak = 2e6", "peak = 0",
            "case.toml:54:1: [loads.impact]: peak is zero, so there is no load; give the largest value"},
    BadCase{"MissingPlateau", "plateau = 0.3\n", "",
            "case.toml:52:15: [loads.impact]: 'plateau' is missing, which shape church_roof needs; add plateau"},
    BadCase{"FrequencyOfAChurchRoof", "plateau = 0.3", "plateau = 0.3\nfrequency = 2.0",
            "case.toml:59:1: [loads.impact]: 'frequency' does not belong to shape church_roof; remove it"},
    BadCase{"PlateauOfATriangle", "church_roof", "triangle",
            "case.toml:58:1: [loads.impact]: 'plateau' does not belong to shape triangle; remove it\n"
            "case.toml:59:1: [loads.impact]: 'plateau_duration' does not belong to shape triangle; remove it"},
    BadCase{"RiseOfAHalfSine", "history = \"force.csv\"",
            "pulse = { shape = \"half_sine\", peak = 1.0, rise = 0.1, duration = 0.2 }",
            "case.toml:64:44: 'rise' does not belong in [loads.gauge.pulse] (only in a triangle, a church_roof and a "
            "step); remove it"},
    BadCase{"RiseBeyondDuration", "rise = 0.04", "rise = 0.2",
            "case.toml:55:1: [loads.impact]: rise is longer than duration; give a rise within the duration"},
    BadCase{"PlateauTooShort", "plateau_duration = 3", "plateau_duration = 0.1",
            "case.toml:59:1: [loads.impact]: plateau_duration is not longer than duration; give the time from start "
            "until the slow part has gone"},
    BadCase{"MissingHistoryFile", "history = \"force.csv\"", "history = \"froce.csv\"",
            "case.toml:64:1: cannot read 'froce.csv'; check the path and the rights"},
    BadCase{"WrongTypeIsNotNeither", "history = \"force.csv\"", "history = 3",
            "case.toml:64:1: history: expected a string, found the number 3; give the path of a CSV file with a header "
            "line, then time (s) and value"},
    BadCase{"TwoMistakesInOneLoad", "boundary = \"front\"\nkind = \"force\"\ndirection = [1.0, 0.5]",
            "direction = [1.0, \"a\"]",
            "case.toml:46:8: [loads.impact]: neither 'boundary' nor 'region' is given; add boundary or region\n"
            "case.toml:47:19: direction: expected a pair of numbers, found a string; give the direction (x, y)"},
    BadCase{"EmptyNameOfABoundary", "boundary = \"front\"", "boundary = \"\"",
            "case.toml:47:1: [loads.impact]: boundary = \"\" has no table [boundaries.\"\"]; known boundaries: base, "
            "front"},
};

INSTANTIATE_TEST_SUITE_P(, BadLoads, testing::ValuesIn(rows), name_of);

}  // namespace bad_loads_test
}  // namespace upbead::test
