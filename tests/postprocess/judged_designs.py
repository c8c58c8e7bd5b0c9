"""Random designs for the tests of what is told of checks and warnings."""

import random

G = 9.81


def design(seed):
    """A design as TOML: a section, waves, and by chance levels, limits, sea states or storms with a life."""
    rng = random.Random(seed)
    depth = rng.uniform(6.0, 22.0)
    base = depth * rng.uniform(0.45, 0.95)
    width, crest = rng.uniform(8.0, 26.0), rng.uniform(2.0, 9.0)
    weight = rng.uniform(1.8e3, 2.3e3) * G * width * (base + crest)
    lines = [f'title = "random {seed}: <b>&amp;</b>"', "[section]", f"water_depth = {depth}", f"foundation_depth = {base}",
             f"berm_depth = {base * rng.uniform(0.6, 1.0)}", f"crest = {crest}", f"width = {width}", f"berm_width = {rng.uniform(2.0, 20.0)}",
             f"bed_slope = {rng.choice([0.002, 0.01, 0.02, 0.05])}", f"weight = {weight}",
             f"submerged_weight = {weight - rng.uniform(0.85, 1.15) * 1030.0 * G * base * width}", f"friction = {rng.uniform(0.4, 0.7)}"]  # fmt: skip
    for number in range(rng.randint(1, 3)):
        lines += [f"[waves.wave_{number}]", f"height = {depth * rng.uniform(0.2, 0.95)}", f"period = {rng.uniform(5.0, 18.0)}", f"angle = {rng.choice([0, 0, 15, 40])}"]
    lines += limits(rng)
    if rng.random() < 0.6:
        lines += ["[levels]", f"high = {0.5 * crest * rng.random()}", f"low = {-0.3 * base * rng.random()}"]
    if rng.random() < 0.4:
        lines += storms(rng, depth)
    return "\n".join(lines) + "\n"


def limits(rng):
    known = (("base_pressure", rng.uniform(2e5, 7e5)), ("overturning", 1.2), ("sliding", rng.choice([1e-4, 0.03, 0.3])))
    return ["[limits]", *(f"{key} = {value}" for key, value in known if rng.random() < 0.8)]


def storms(rng, depth):
    return ["[storms]", f"location = {0.15 * depth}", f"scale = {0.06 * depth}", "shape = 1.4", "steepness = 0.03", "[life]", "years = 50",
            "simulated_lives = 20", "[scatter.force]", "cov = 0.1", "low = 0.2"]  # fmt: skip
