// What a page of a design asks: the wave, the still water and the section, with the keys and bounds of a design file.

const within = (low, high) => (value) => value >= low && value <= high;
const LENGTH = {holds: within(1e-3, 1e4), needs: "a length from 0.001 to 10,000 m"};
const NOT_BELOW_0 = {holds: within(0, 1e4), needs: "a length from 0 to 10,000 m"};
const WEIGHT = {unit: "kN/m", factor: 1e3, holds: within(1, 1e12), needs: "a weight from 0.001 kN/m to a thousand million kN/m"};
const metres = (key, name, low, high, bounds = LENGTH) => ({key, name, unit: "m", factor: 1, low, high, ...bounds});

// [{spec, value}] of the wave; what is not given is the other way to give the height.
export function specsOfWave(waves) {
  const largest = Math.max(...waves.map((wave) => wave.deep_water_height ?? wave.height)), longest = Math.max(...waves.map(({period}) => period));
  const [first] = waves, height = first.height ?? first.deep_water_height;
  return [
    {spec: metres("design-height", "Highest wave H", 0.1 * largest, 1.6 * largest), value: first.height ?? height},
    {spec: {...metres("design-significant_height", "H 1/3 (empty: H/1.8)", 0.05 * largest, largest), optional: true}, value: first.significant_height ?? null},
    {spec: metres("design-deep_water_height", "Deep-water height H₀′", 0.1 * largest, 1.6 * largest), value: first.deep_water_height ?? height},
    {spec: {key: "design-period", name: "Period T", unit: "s", factor: 1, low: 0.3 * longest, high: 1.6 * longest, holds: within(0.01, 1e4),
      needs: "a period from 0.01 to 10,000 s"}, value: first.period},
    {spec: {key: "design-angle", name: "Angle β to the wall's normal", unit: "°", factor: 1, low: 0, high: 75, holds: (value) => value >= 0 && value < 90,
      needs: "an angle from 0 to below 90 degrees"}, value: first.angle},
  ];
}

export function specOfLevel({water_depth: h, foundation_depth, berm_depth, crest}) {
  const most = Math.min(h, foundation_depth, berm_depth);
  return {spec: {...metres("design-rise", "Water level above the section's", -0.6 * most, crest), holds: within(-1e4, 1e4),
    needs: "a rise from -10,000 to 10,000 m"}, value: 0};
}

export function specsOfCaisson({width, weight, submerged_weight, friction}) {
  return [
    {spec: metres("design-width", "Width B", 0.5 * width, 2 * width), value: width},
    {spec: {key: "design-weight", name: "Weight in air W", low: 0.4 * weight, high: 2 * weight, ...WEIGHT}, value: weight},
    {spec: {key: "design-submerged_weight", name: "W′ at the section's level", low: 0.4 * submerged_weight, high: 2 * submerged_weight, ...WEIGHT}, value: submerged_weight},
    {spec: {key: "design-friction", name: "Friction μ", unit: "", factor: 1, low: 0.3, high: 1, holds: within(0.01, 10), needs: "a number from 0.01 to 10"},
      value: friction},
  ];
}

export function specsOfDepths({water_depth: h, foundation_depth, berm_depth, crest, berm_width, bed_slope}) {
  return [
    {spec: metres("design-water_depth", "Depth at the wall h", 0.5 * h, 2 * h), value: h},
    {spec: metres("design-foundation_depth", "Depth of the bottom h′", 0.5 * foundation_depth, 2 * foundation_depth), value: foundation_depth},
    {spec: metres("design-berm_depth", "Depth of the armour d", 0.5 * berm_depth, 2 * berm_depth), value: berm_depth},
    {spec: metres("design-crest", "Crest above still water h_c", 0, 2 * crest || 10, NOT_BELOW_0), value: crest},
    {spec: metres("design-berm_width", "Width of the berm B_M", 0, 3 * berm_width || 20, NOT_BELOW_0), value: berm_width},
    {spec: {key: "design-bed_slope", name: "Slope of the bed tan θ", unit: "", factor: 1, low: 0, high: 0.1, holds: within(0, 1), needs: "a slope from 0 to 1"},
      value: bed_slope},
  ];
}
