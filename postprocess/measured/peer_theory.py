"""Exact answers of the problems in cases/validation/peers, in closed form, with the numbers of the peers' inputs."""

import math

import numpy as np
from scipy.special import hankel2

TERMS = 400


def terzaghi(where, time):
    """p at a height of a column of 10 m under 1 Pa, water and grains incompressible: Terzaghi (1943), c = kappa/mu E = 0.1 m2/s."""
    height, c = 10.0, 0.1
    a = (np.arange(TERMS) + 0.5) * np.pi
    return float(np.sum(2 * np.sin(a) / a * np.cos(a * where / height) * np.exp(-(a**2) * c * time / height**2)))


def compressible(where, time):
    """p at a height of PyLith's column of 10 km under 10 kPa, grains and water compressible: Terzaghi's series times alpha/(M_d S), Cheng (2016), B.11 to B.16."""
    oedometric, biot, storage, mobility, height = 80e9, 0.6, 0.1 / 80e9 + (0.6 - 0.1) / 100e9, 1.5e-13 / 0.001, 1e4
    whole = storage + biot**2 / oedometric
    a = (np.arange(TERMS) + 0.5) * np.pi
    series = np.sum(2 * np.sin(a) / a * np.cos(a * where / height) * np.exp(-(a**2) * mobility / whole * time / height**2))
    return float(1e4 * biot / (oedometric * whole) * series)


def mandel_roots(ratio):
    """Roots of tan a = ratio a, one in each ((i - 1/2) pi, (i + 1/2) pi) for ratio > 1 from i = 0 on, by bisection."""
    found = []
    for number in range(TERMS):
        low, high = max(number - 0.5, 0) * math.pi + 1e-9, (number + 0.5) * math.pi - 1e-12
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (middle, high) if math.tan(middle) < ratio * middle else (low, middle)
        found.append((low + high) / 2)
    return np.array(found)


def mandel(quantity, where, time):
    """p, u_x or u_y of Mandel's specimen of half width 1 under a force of 1 on that half: Cheng and Detournay (1988)."""
    shear, nu, alpha, mobility, bulk = 0.75, 0.2, 0.6, 1.5, 1.0
    storage = 0.1 / 8 + (alpha - 0.1) * (1 - alpha) / bulk
    undrained = bulk + alpha**2 / storage
    nu_u = (3 * undrained - 2 * shear) / (6 * undrained + 2 * shear)
    skempton = alpha / (storage * undrained)
    c = mobility / (storage + alpha**2 / (bulk + 4 / 3 * shear))
    a = mandel_roots((1 - nu) / (nu_u - nu))
    share, fading = 1 / (a - np.sin(a) * np.cos(a)), np.exp(-(a**2) * c * time)
    if quantity == "pressure":
        return float(2 / 3 * skempton * (1 + nu_u) * np.sum(share * np.sin(a) * (np.cos(a * where) - np.cos(a)) * fading))
    if quantity == "displacement_y":
        return float(where * (-(1 - nu) / (2 * shear) + (1 - nu_u) / shear * np.sum(share * np.sin(a) * np.cos(a) * fading)))
    own = nu / (2 * shear) - nu_u / shear * np.sum(share * np.sin(a) * np.cos(a) * fading)
    return float(own * where + np.sum(share * np.cos(a) * np.sin(a * where) * fading) / shear)


def ramp(time):
    """p at the base of a layer of height 1 whose top goes down by 0.05 in 100 s. u diffuses, u_t = c u_zz with c = M kappa/mu, because the base is
    sealed and all pores are full; p = M (u_z(z) - u_z(top)) is the equilibrium of the whole. u of the ramp is its steady growth less a fading series."""
    modulus, speed = (1 - 0.1) / ((1 + 0.1) * (1 - 0.2)), 0.05 / 100
    c = modulus * 1e-3
    a = np.arange(1, 4000) * np.pi
    signs = np.where(np.arange(1, 4000) % 2 == 0, 1.0, -1.0)
    # u(z, t) = -speed (z t + (z^3 - z)/(6 c) - sum 2 signs/(c a^3) sin(a z) exp(-a^2 c t)), where (z^3 - z)/6 = sum 2 signs/a^3 sin(a z)
    fading = np.exp(-(a**2) * c * time)
    base = time + (-1 / 6 - np.sum(2 * signs / a**2 * fading)) / c
    top = time + (2 / 6 - np.sum(2 / a**2 * fading)) / c
    return float(-speed * modulus * (base - top))


def gravity(reading, where):
    """p and u_y at a height of a column of 5 m at rest, 100 kPa in the water on top and nothing on the soil: equilibrium of the whole, M u'' = p' + rho g."""
    modulus, g = 2.25e8 * (1 - 0.4) / ((1 + 0.4) * (1 - 0.8)), 10.0
    if reading == "pressure":
        return 1e5 + 1000 * g * (5 - where)
    return (1600 - 1000) * g / (2 * modulus) * where * (where - 10) + 1e5 / modulus * where


def bar(time):
    """Change of u in the middle of a fixed bar of 10 m when 1 kPa is taken off its end: d'Alembert, up to the third passing of the front."""
    density, modulus = 1890.0, 5e7 * 0.7 / (1.3 * 0.4)
    speed = math.sqrt(modulus / density)
    return 1000 / (density * speed) * (max(time - 5 / speed, 0) - max(time - 15 / speed, 0))


def bell(where, time):
    """u of a bell of displacement that comes up a column of 50 m from its base, and of the one that its free top reflects."""
    speed = math.sqrt(4.44e8 / (2 * 1.48) / 1900)

    def at(way):
        return 1e-3 * math.exp(-(((time - way / speed - 0.17706) / 0.035590) ** 2) / 2)

    return at(where) + at(100 - where)


def force(direction, where, time):
    """u_x or u_y at a place by a vertical force in a plane without ends, downward, a Ricker wavelet of 8 Hz whose peak, 1e10 N/m, is at 0.15 s:
    (delta H_0(k_s r) + grad grad (H_0(k_s r) - H_0(k_p r))/k_s^2)/(4 i mu) of each frequency (Eason, Fulton and Sneddon 1956), summed."""
    density, fast, slow = 2700.0, 3000.0, 1732.05
    w = 2 * np.pi * np.arange(1, 600) / 4.0  # nothing of the wavelet is above 30 Hz, and nothing comes back within 4 s
    a = (np.pi * 8.0) ** 2
    wavelet = 1e10 * np.sqrt(np.pi / a) * w**2 / (2 * a) * np.exp(-(w**2) / (4 * a) + 1j * w * (time - 0.15))
    r, shear, press = np.hypot(*where), w / slow, w / fast
    first = -shear * hankel2(1, shear * r) + press * hankel2(1, press * r)
    second = -first / r - shear**2 * hankel2(0, shear * r) + press**2 * hankel2(0, press * r)
    own, along = float(direction == "y"), where["xy".index(direction)] * where[1] / r**2
    kernel = own * hankel2(0, shear * r) + (along * second + (own - along) * first / r) / shear**2
    return float(-np.sum((kernel * wavelet / (4j * density * slow**2)).real) * w[0] / np.pi)
