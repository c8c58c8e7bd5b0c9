"""A caisson quay wall in Kobe in 1995: how far inertia and backfill push it seaward, without pore pressure in the ground."""

from pathlib import Path

import numpy as np

from .runs import CASES, run

CASE = CASES / "quay/quay.toml"
PEAK, PERIOD, LASTS, START, ENDS = 5.3, 0.9, 9.0, 2.0, 12.0  # m/s2, s; from memory: 0.54 g 32 m below the surface
HEIGHT, SOIL, WATER, GRAVITY = 18.5, 2000.0, 1030.0, 9.81
MEASURED = {"seaward": "4 to 5", "down": "about 2", "tilt": "about 4"}  # m, m, degrees: PHRI Technical Note 813, part 7 (1995), abstract
INERTIA = 0.5  # of it by inertia alone, by their computation


def motion():
    """Velocity -(A/w) sin^2 (pi t/D) cos w t, so that none is left; its derivative."""
    time = np.arange(0, LASTS + 5e-3, 0.01)
    w = 2 * np.pi / PERIOD
    velocity = -PEAK / w * np.sin(np.pi * time / LASTS) ** 2 * np.cos(w * time)
    return START + time, np.gradient(velocity, time)


def write():
    """The three histories of the case: the motion, and what a backfill that holds presses."""
    time, acceleration = motion()
    rest, shaken = backfill(False)
    columns = {"shaking": ("acceleration (m/s2)", acceleration), "shaken": ("force (N/m)", -shaken * acceleration)}
    for name, (head, values) in columns.items():
        rows = "".join(f"{t:.3f},{value:.6g}\n" for t, value in [(0.0, 0.0), (START - 0.01, 0.0), *zip(time, values, strict=True), (ENDS, 0.0)])
        (CASE.parent / f"{name}.csv").write_text(f"time (s),{head}\n{rows}", encoding="utf-8")
    (CASE.parent / "rest.csv").write_text(f"time (s),force (N/m)\n0,0\n1,{rest:.6g}\n{ENDS},{rest:.6g}\n", encoding="utf-8")


def backfill(liquefied):
    """Thrust at rest beyond water's, and per acceleration beyond what water's mass has: earth pressure K_a gamma' or, of a heavy liquid, gamma';
    Mononobe and Okabe's increment, 3/8 rho h^2 a (Seed and Whitman 1970), or Westergaard's of that liquid, 7/12 rho h^2 a."""
    wet = (SOIL - WATER) * GRAVITY
    if liquefied:
        return wet * HEIGHT**2 / 2, 7 / 12 * (SOIL - WATER) * HEIGHT**2
    return 0.27 * wet * HEIGHT**2 / 2, max(0.0, (3 / 8 * SOIL - 7 / 12 * WATER)) * HEIGHT**2


def keys_of(liquefied=False):
    rest, shaken = (one / other for one, other in zip(backfill(liquefied), backfill(False), strict=True))
    return {"loads.backfill.factor": rest, "loads.backfill_shaken.factor": shaken}


WEAK = {"regions.seabed.shear_modulus": 56e6, "regions.seabed.strain": {"reference_strain": 3.57e-4}}  # pore pressure of half the effective stress: half of the strength, G by the root
VARIANTS = {
    "with a backfill that holds": keys_of(),
    "likewise, pore pressure of half the stress in the sand": keys_of() | WEAK,
    "with a backfill that is liquid": keys_of(liquefied=True),
}


def numbers(program, folder):
    """What is left of each variant: caisson's displacement seaward and downward (m), tilt (degrees), slip on its mound (m)."""
    found = {}
    for name, keys in VARIANTS.items():
        summary = run(program, CASE, keys, Path(folder) / "quay")
        left = summary["residual"]
        found[name] = {"seaward": left["displacement_x"], "down": -left["displacement_y"], "tilt": float(np.degrees(left["rotation"])), "slip": summary["contact"]["solved"]["slip"]}
    return found
