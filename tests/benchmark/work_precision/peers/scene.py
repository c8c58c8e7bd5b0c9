"""The peers' scene in numbers: reads peer_scene.toml and computes what every peer needs."""

import math
import pathlib
import tomllib
from dataclasses import dataclass

SCENE = pathlib.Path(__file__).resolve().parents[1] / "peer_scene.toml"


@dataclass
class Soil:
    """Coefficients of the equations in docs/theory.md: rho u'' ..., storage 1/Q p', flow p/b."""

    G: float  # Pa
    lame: float  # Pa
    rho: float  # kg/m3, saturated
    storage: float  # 1/Q (1/Pa)
    mobility: float  # 1/b = k/(rho_f g) (m2/(Pa s))
    mass_damping: float  # Rayleigh a0 (1/s)
    stiffness_damping: float  # Rayleigh a1 (s)


@dataclass
class Scene:
    soils: dict  # name: Soil
    bottom: tuple  # left end of the caisson's bottom x, y, and its right end x (m)
    centre: tuple  # of gravity (m)
    mass: float  # kg/m
    inertia: float  # kg m2/m
    peak: float  # N/m
    duration: float  # s
    end: float  # s
    geometry: dict  # parameters of meshes/composite.geo

    def force(self, t):
        """The triangle, N/m."""
        return self.peak * max(0.0, 1 - abs(2 * t / self.duration - 1))


def soil(region, fluid, gravity):
    """Rayleigh: ratio = a0/(2 w) + a1 w/2 at both frequencies."""
    G, nu, n = (region[key] for key in ("shear_modulus", "poissons_ratio", "porosity"))
    one, two = (2 * math.pi * f for f in region["damping"]["frequencies"])
    a1 = 2 * region["damping"]["ratio"] / (one + two)
    return Soil(G=G, lame=2 * G * nu / (1 - 2 * nu), rho=(1 - n) * region["grain_density"] + n * fluid["density"],
                storage=n / fluid["bulk_modulus"],
                mobility=region["hydraulic_conductivity"] / (fluid["density"] * gravity),
                mass_damping=a1 * one * two, stiffness_damping=a1)


def read(path=SCENE):
    case = tomllib.loads(pathlib.Path(path).read_text())
    geometry, regions = case["mesh"]["parameters"], case["regions"]
    width, height, level = geometry["caisson_width"], geometry["caisson_height"], geometry["mound_height"]
    mass = regions["caisson"]["density"] * width * height
    pulse = case["loads"]["impulse"]["pulse"]
    return Scene(soils={name: soil(regions[name], case["fluid"], case["gravity"]) for name in ("seabed", "mound")},
                 bottom=(-width / 2, level, width / 2), centre=(0.0, level + height / 2), mass=mass,
                 inertia=mass * (width**2 + height**2) / 12, peak=pulse["peak"], duration=pulse["duration"],
                 end=case["time"]["end"], geometry=geometry)
