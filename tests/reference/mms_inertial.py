"""Manufactured solution of the full Biot equations (inertial flow); writes mms_inertial.json beside itself.

    python3 tests/reference/mms_inertial.py        needs sympy; the tests read the JSON only

In the format of ref8_mms.json, with the relative fluid displacement W added. Every closed form is compared with
balances that are written in another way and contain numerical derivatives of the exact fields in 40 digits.
"""

import json
from pathlib import Path

import mpmath
import sympy
from sympy import Rational as R

STATEMENT = """Manufactured solution of the full Biot equations (plane strain, x, y; stress positive in tension, p in
compression; W displacement of the pore water relative to the skeleton, per total area):
   momentum  rho u_tt + rho_f W_tt + aM rho u_t - div(s(u) + bK s(u_t)) + alpha grad p = f,  s(u) = lam tr(e) I + 2 mu e
   fluid     rho_f u_tt + m W_tt + W_t / kappa + grad p = h,       m = tortuosity rho_f / n
   mass      alpha div u_t + div W_t + p_t iM = g,                 iM = 1/Q
Fields: u and p of the solution 'trig' of ref8_mms.json with each its own function of time, and W that is no gradient:
   T1 = exp(-z t) sin(w t + .2)       u_x = U sin(a x + .3) cos(b y - .2) T1
   T2 = cos(1.3 w t)                  u_y = U cos(a x - .4) sin(b y + .5) T2
   T3 = sin(.7 w t) + .5              p = P cos(c x + .1) cos(d y - .3) T3
   T4 = exp(-z t) cos(w t) + .4 sin(1.3 w t)      W_x = V sin(c x + .7) sin(b y + .4) T4
   T5 = cos(.7 w t + .3)              W_y = V cos(a x + .2) sin(d y - .6) T5
   phi = integral of p from t = 0.
Given: the fields with their derivatives, total stress s(u) + bK s(u_t) - alpha p I, outward flux density q = W_t (its
normal component is the natural boundary term of the mass equation), the sources fx, fy, hx, hy, g."""

x, y, t = sympy.symbols("x y t", real=True)
NAMES = "lam mu rho rho_f m alpha iM kappa aM bK U V P a b c d w z".split()
S = {name: sympy.Symbol(name, positive=True) for name in NAMES}

AIR = dict(lam=40e6, mu=40e6, rho=2000.0, rho_f=1000.0, m=2500.0, alpha=1.0, iM=2e-9, kappa=1.5e-5, aM=0.0, bK=0.0)
WATER = dict(lam=30e6, mu=50e6, rho=1990.0, rho_f=1030.0, m=3862.5, alpha=0.95, iM=1.8e-10, kappa=5e-6, aM=0.8, bK=1e-3)
SHAPE = dict(U=1e-3, V=1e-3, P=5e3, a=0.35, b=0.4, c=0.3, d=0.45, w=25.0, z=2.0)
T_END = 0.05  # short, because the fast waves in the water require short steps
POINTS = [(0.7, 0.3, 0.0), (3.1, 2.2, 0.013), (7.9, 4.4, 0.05), (10.0, 2.5, 0.11), (4.3, 5.0, 0.2)]


def fields():
    """The exact fields, symbolic."""
    U, V, P, a, b, c, d, w, z = (S[n] for n in ("U", "V", "P", "a", "b", "c", "d", "w", "z"))
    p_of_t = sympy.sin(R(7, 10) * w * t) + R(1, 2)
    shape_p = P * sympy.cos(c * x + R(1, 10)) * sympy.cos(d * y - R(3, 10))
    decaying = sympy.exp(-z * t) * sympy.sin(w * t + R(1, 5))
    wave = sympy.exp(-z * t) * sympy.cos(w * t) + R(2, 5) * sympy.sin(R(13, 10) * w * t)
    return {
        "ux": U * sympy.sin(a * x + R(3, 10)) * sympy.cos(b * y - R(1, 5)) * decaying,
        "uy": U * sympy.cos(a * x - R(2, 5)) * sympy.sin(b * y + R(1, 2)) * sympy.cos(R(13, 10) * w * t),
        "Wx": V * sympy.sin(c * x + R(7, 10)) * sympy.sin(b * y + R(2, 5)) * wave,
        "Wy": V * sympy.cos(a * x + R(1, 5)) * sympy.sin(d * y - R(3, 5)) * sympy.cos(R(7, 10) * w * t + R(3, 10)),
        "p": shape_p * p_of_t,
        "phi": shape_p * sympy.integrate(p_of_t, (t, 0, t)),
    }


def equations(f, diff, s):
    """Stress and sources from fields `f`, the differentiation diff(field, *variables) and constants `s`."""

    def stress(rate):
        e_xx, e_yy = diff("ux", "x", *rate), diff("uy", "y", *rate)
        shear = s["mu"] * (diff("ux", "y", *rate) + diff("uy", "x", *rate))
        trace = s["lam"] * (e_xx + e_yy)
        return trace + 2 * s["mu"] * e_xx, trace + 2 * s["mu"] * e_yy, shear

    def div_stress(rate):
        lam, mu = s["lam"], s["mu"]
        xx, xy = diff("ux", "x", "x", *rate), diff("ux", "x", "y", *rate)
        yy, yx = diff("uy", "y", "y", *rate), diff("uy", "x", "y", *rate)
        x_part = (lam + 2 * mu) * xx + lam * yx + mu * (diff("ux", "y", "y", *rate) + yx)
        y_part = (lam + 2 * mu) * yy + lam * xy + mu * (diff("uy", "x", "x", *rate) + xy)
        return x_part, y_part

    out = {}
    elastic, viscous = stress(()), stress(("t",))
    for i, name in enumerate(("sxx_total", "syy_total", "sxy")):
        out[name] = elastic[i] + s["bK"] * viscous[i] - (s["alpha"] * f["p"] if i < 2 else 0)
    out["qx"], out["qy"] = diff("Wx", "t"), diff("Wy", "t")
    for i, n in enumerate("xy"):
        u, W = "u" + n, "W" + n
        u_t, u_tt, W_tt = diff(u, "t"), diff(u, "t", "t"), diff(W, "t", "t")
        internal = div_stress(())[i] + s["bK"] * div_stress(("t",))[i]
        inertia = s["rho"] * u_tt + s["rho_f"] * W_tt + s["aM"] * s["rho"] * u_t
        out["f" + n] = inertia - internal + s["alpha"] * diff("p", n)
        out["h" + n] = s["rho_f"] * u_tt + s["m"] * W_tt + diff(W, "t") / s["kappa"] + diff("p", n)
    div_u_t = diff("ux", "x", "t") + diff("uy", "y", "t")
    div_W_t = diff("Wx", "x", "t") + diff("Wy", "y", "t")
    out["g"] = s["alpha"] * div_u_t + div_W_t + s["iM"] * diff("p", "t")
    return out


def expressions():
    """{name in the JSON: closed form}"""
    f = fields()
    variables = {"x": x, "y": y, "t": t}

    def diff(name, *by):
        return sympy.diff(f[name], *(variables[v] for v in by))

    out = dict(f)
    for name in ("ux", "uy", "Wx", "Wy", "p"):
        out[name + "_t"] = diff(name, "t")
        if name != "p":
            out[name + "_tt"] = diff(name, "t", "t")
        for by in "xy":
            out[f"{name}_{by}"] = diff(name, by)
    out.update(equations(f, diff, S))
    return out


def numerical(constants, at):
    """Stress and sources at a point (x, y, t) in a second way: from balances of the stress, differentiated
    numerically."""
    c = {k: mpmath.mpf(str(v)) for k, v in constants.items()}
    exact = {n: sympy.lambdify((x, y, t), e.subs({S[k]: R(str(v)) for k, v in constants.items()}), "mpmath")
             for n, e in fields().items()}
    place = tuple(mpmath.mpf(str(v)) for v in at)

    def diff(function, by, where=place):
        return mpmath.diff(function, where, tuple(by.count(v) for v in "xyt"))

    def skeleton(row, column):
        """A component of s(u) + bK s(u_t): mean and difference of the normal strains instead of Lame's form."""

        def value(*where):
            def strain(*when):
                xx, yy = diff(exact["ux"], "x", when), diff(exact["uy"], "y", when)
                if row != column:
                    return c["mu"] * (diff(exact["ux"], "y", when) + diff(exact["uy"], "x", when))
                return (c["lam"] + c["mu"]) * (xx + yy) + (1 if row == "x" else -1) * c["mu"] * (xx - yy)

            return strain(*where) + c["bK"] * diff(strain, "t", where)

        return value

    out = {"qx": diff(exact["Wx"], "t"), "qy": diff(exact["Wy"], "t"), "sxy": skeleton("x", "y")(*place)}
    for n in "xy":
        u, W = exact["u" + n], exact["W" + n]
        out[f"s{n}{n}_total"] = skeleton(n, n)(*place) - c["alpha"] * diff(exact["phi"], "t")
        grad_p = diff(exact["phi"], n + "t")
        divergence = sum(diff(skeleton(n, by), by) for by in "xy") - c["alpha"] * grad_p
        out["f" + n] = c["rho"] * (diff(u, "tt") + c["aM"] * diff(u, "t")) + c["rho_f"] * diff(W, "tt") - divergence
        out["h" + n] = c["rho_f"] * diff(u, "tt") + c["m"] * diff(W, "tt") + diff(W, "t") / c["kappa"] + grad_p
    volume = c["alpha"] * (diff(exact["ux"], "xt") + diff(exact["uy"], "yt")) + c["iM"] * diff(exact["phi"], "tt")
    out["g"] = volume + diff(exact["Wx"], "xt") + diff(exact["Wy"], "yt")
    return out


def evaluated(closed, constants):
    """Samples, and the largest relative difference between both ways of differentiating."""
    names = list(closed)
    numbers = {S[k]: R(str(v)) for k, v in constants.items()}
    function = sympy.lambdify((x, y, t), [closed[n].subs(numbers) for n in names], "mpmath")
    samples, worst, size = [], mpmath.mpf(0), {}
    for at in POINTS:
        values = dict(zip(names, function(*(mpmath.mpf(str(v)) for v in at))))
        other = numerical(constants, at)
        for n, value in other.items():
            size[n] = max(size.get(n, 0), abs(value))
        samples.append((at, values, other))
    for _, values, other in samples:
        worst = max([worst] + [abs(values[n] - other[n]) / size[n] for n in other])
    rows = [dict(zip("xyt", at), **{n: float(v) for n, v in values.items()}) for at, values, _ in samples]
    return rows, float(mpmath.nstr(worst, 3))


def main():
    mpmath.mp.dps = 40
    closed = expressions()
    sets = []
    for constants in (AIR, WATER):
        parameters = dict(constants, **SHAPE)
        samples, difference = evaluated(closed, parameters)
        if difference > 1e-12:
            raise SystemExit(f"closed forms and numerical differentiation differ by {difference}")
        sets.append({"domain": "[0,10]x[0,5]", "t_end": T_END, "parameters": parameters, "samples": samples,
                     "check_rel_sympy_vs_mpmath_numdiff": difference})
    solution = {
        "kind": "inertial",
        "symbols": " ".join(NAMES),
        "c_code": {n: sympy.ccode(e) for n, e in closed.items()},
        "expressions": {n: str(e) for n, e in closed.items()},
        "sets": sets,
    }
    content = {
        "problem": "manufactured solution of the full Biot equations",
        "units": "SI (m, s, kg, Pa, N)",
        "generated_by": Path(__file__).name,
        "sympy": sympy.__version__,
        "statement": STATEMENT,
        "mms": [solution],
    }
    Path(__file__).with_suffix(".json").write_text(json.dumps(content, indent=1) + "\n")


if __name__ == "__main__":
    main()
