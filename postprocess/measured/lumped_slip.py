"""A rigid caisson on springs and dashpots of sway, heave and rocking at the middle of its bottom, which slips there by
Coulomb friction: what published lumped models of caisson breakwaters are.

m x_G'' + F_x = P,  x_G = e + s + a phi;   m z'' + F_z = U;   I phi'' + a m x_G'' + F_phi = P b + M_U
F_x = K_x e + C_x e',  |F_x| <= mu N,  N = W' - U + m z'';  s is the slip, phi turns the top landward.

The water moves with the wall: its added mass is in m of sway, and in I. While it sticks s stays; else F_x = +-mu N and e
follows from the spring alone. Steps are explicit and a thousandth of the shortest period.
"""

from dataclasses import dataclass

import numpy as np


@dataclass
class Caisson:
    mass: float
    inertia: float  # about the middle of the bottom
    centre: float  # height of the centre of gravity above the bottom
    weight: float  # W', submerged
    friction: float
    springs: tuple  # sway, heave, rocking
    dashpots: tuple
    added_mass: float = 0.0
    added_arm: float = 0.0  # height of the added mass above the bottom


def periods(caisson):
    """Natural periods of sway and rocking together (s), the longest first."""
    c = caisson
    coupling = c.mass * c.centre + c.added_mass * c.added_arm
    mass = np.array([[c.mass + c.added_mass, coupling], [coupling, c.inertia + c.added_mass * c.added_arm**2]])
    return sorted(2 * np.pi / np.sqrt(np.linalg.eigvals(np.linalg.solve(mass, np.diag([c.springs[0], c.springs[2]])))), reverse=True)


def slip(caisson, time, force, arm, uplift, uplift_moment):
    """Slip over time (m) under a force P (N/m) that attacks at height `arm`, and an uplift with its moment."""
    c, (kx, kz, kr), (cx, cz, cr) = caisson, caisson.springs, caisson.dashpots
    sway = c.mass + c.added_mass
    coupling = c.mass * c.centre + c.added_mass * c.added_arm
    turn = c.inertia + c.added_mass * c.added_arm**2
    determinant = sway * turn - coupling**2
    step = 2 * np.pi / np.sqrt(max(kx * turn, kr * sway) / determinant) / 1000
    times = np.arange(time[0], time[-1], step)
    loads = [np.interp(times, time, load) for load in (force, uplift, uplift_moment)]
    x = v = z = w = r = q = s = 0.0  # displacement and velocity of the bottom, heave, turn; slip
    slips = np.empty(len(times))
    for i, (p, u, mu) in enumerate(zip(*loads, strict=True)):
        heave = (u - kz * z - cz * w) / c.mass
        grip = c.friction * max(0.0, c.weight - u + c.mass * heave)
        extension = x - s
        base = kx * extension + cx * v  # where it sticks the spring stretches as the bottom moves
        if abs(base) > grip:
            base = np.sign(base) * grip
            # K e + C e' = +-mu N says how the spring stretches; the rest of the bottom's motion is slip
            s += step * (v - (base - kx * extension) / cx)
        turning = p * arm + mu - kr * r - cr * q
        a = ((p - base) * turn - coupling * turning) / determinant
        b = (sway * turning - coupling * (p - base)) / determinant
        v, w, q = v + step * a, w + step * heave, q + step * b
        x, z, r = x + step * v, z + step * w, r + step * q
        slips[i] = s
    return times, slips
