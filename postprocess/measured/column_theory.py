"""A layer of poroelastic soil on a rigid sealed base under a uniform pressure p0 exp(i w t) of the water on it, in closed
form: Biot's equations in one dimension, which are those of Yamamoto et al. (1978) for long waves on a layer.

z is the height above the base, M = 2 G (1 - nu)/(1 - 2 nu), S = n (1/K_f), 1/K_f = S_r/K_w + (1 - S_r)/p_absolute,
K = k/(rho_f g). Momentum: M u'' - p' = rho u_tt; mass of water: S p_t + u'_t = K p''. On top p = p0, and the skeleton
bears nothing, M u' = 0; at the base u = 0, p' = 0.
"""

from dataclasses import dataclass

import numpy as np


@dataclass
class Soil:
    shear_modulus: float
    poissons_ratio: float
    porosity: float
    conductivity: float
    saturation: float
    absolute_pressure: float
    water_density: float = 1000.0
    water_modulus: float = 2.2e9
    grain_density: float = 2650.0
    gravity: float = 9.81

    @property
    def oedometric(self):
        return 2 * self.shear_modulus * (1 - self.poissons_ratio) / (1 - 2 * self.poissons_ratio)

    @property
    def storage(self):
        return self.porosity * (self.saturation / self.water_modulus + (1 - self.saturation) / self.absolute_pressure)

    @property
    def mobility(self):
        return self.conductivity / (self.water_density * self.gravity)

    @property
    def density(self):
        return (1 - self.porosity) * self.grain_density + self.porosity * self.water_density


def quasi_static(soil, height, period, z):
    """p/p0: total stress is p0 at every depth, so p diffuses towards A p0, the share that water bears where it cannot flow:
    p = A + (1 - A) cosh(q z)/cosh(q h), A = (1/M)/(S + 1/M), q^2 = i w/c, c = K/(S + 1/M)."""
    compressibility = 1 / soil.oedometric
    undrained = compressibility / (soil.storage + compressibility)
    q = np.sqrt(2j * np.pi / period * (soil.storage + compressibility) / soil.mobility)
    return undrained + (1 - undrained) * np.cosh(q * np.asarray(z)) / np.cosh(q * height)


def with_inertia(soil, height, period, z):
    """p/p0 with the mass of soil and water: u = sum of U_j exp(l_j z), where (M l^2 + rho w^2)(i w S - K l^2) + i w l^2 = 0."""
    w, m, rho, k = 2 * np.pi / period, soil.oedometric, soil.density, soil.mobility
    square = np.roots([-m * k, 1j * w * soil.storage * m - rho * w**2 * k + 1j * w, 1j * w**3 * rho * soil.storage])
    roots = np.concatenate([np.sqrt(square), -np.sqrt(square)])
    pressure = (m * roots**2 + rho * w**2) / roots  # P_j over U_j
    scale = np.exp(-np.maximum(roots.real, 0) * height)  # so that no exponential is large
    top = np.exp(roots * height) * scale
    system = np.array([scale, pressure * roots * scale, pressure * top, roots * top])
    amounts = np.linalg.solve(system, np.array([0, 0, 1, 0]))
    return np.array([np.sum(amounts * pressure * scale * np.exp(roots * at)) for at in np.atleast_1d(z)])
