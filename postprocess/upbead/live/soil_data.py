"""The numbers of a model of soils that a page needs: a still smaller system for F_T alone, under the loads of the case."""

import base64

import numpy as np

from ..errors import ModelError
from ..h5 import open_h5
from ..reduced_model import warnings_in
from ..results import text_of

TOLERANCE = 0.01  # of the history of F_T over its peak; of it the basis takes SHARE on soils that it was not made of
SHARE, CHECKED, MADE_OF = 0.6, 4, 8  # soils beside the points of the model
FREQUENCIES, MOST = 16, 160  # of the snapshots; coordinates
READING = "shear_force"
SENSES = ("position", "velocity", "acceleration")


class Family:
    """fixed + sum_q theta_q part_q, without the slip; rows of phi as in the file."""

    def __init__(self, file):
        family, self.path = file["family"], file.filename
        attributes = family.attrs
        self.phi = family["is_phi"][()].astype(bool)
        self.u, self.p = np.flatnonzero(~self.phi), np.flatnonzero(self.phi)  # of the file, for matrix()
        n_kept, slips = int(attributes["n_kept"]), int(attributes["slip_loads"])
        keep = [i for i in range(self.phi.size) if not slips or i != n_kept - 1]  # the last kept one is the slip
        self.exact = n_kept - (1 if slips else 0)
        n_loads = family["load"].shape[1] - slips
        if np.any(family["prescribed"][()][:n_loads] >= 0):
            raise ModelError(f"'{self.path}' has a motion that is prescribed, which a page of soils does not answer")
        groups = [family["fixed"], *(family[f"part{q}"] for q in range(family["term_region"].size))]
        self.systems = [{key: self.matrix(group, key)[np.ix_(keep, keep)] for key in "MCK"} for group in groups]
        names = [text_of(name) for name in family["readings/quantity"][()]]
        at, push = names.index(READING), names.index("force")
        self.rows = [[group[sense][at, keep] if sense in group else np.zeros(len(keep)) for sense in SENSES] for group in groups]
        self.load, self.direct = family["load"][()][keep, :n_loads], family["feedthrough"][()][at, :n_loads]
        self.push = family["feedthrough"][()][push, :n_loads]
        self.phi = self.phi[keep]
        self.u, self.p = np.flatnonzero(~self.phi), np.flatnonzero(self.phi)
        times = family["time"][()]
        steps = int(np.clip(4 * times.size, 400, 2000))
        self.step = (times[-1] - times[0]) / steps
        values = np.column_stack([family["begin"][()], family["end"][()][:, -1]])[:n_loads]
        self.force = np.array([np.interp(times[0] + self.step * np.arange(steps + 1), times, row) for row in values])

    def matrix(self, group, key):
        out, u, p = np.zeros((self.phi.size,) * 2), self.u, self.p
        for rows, name in ((u, f"{key}_uu"), (p, f"{key}_pp")):
            if name in group:
                half = np.zeros((rows.size,) * 2)
                half[np.tril_indices(rows.size)] = group[name][()]
                out[np.ix_(rows, rows)] = half + np.tril(half, -1).T
        if f"{key}_up" in group:
            block = group[f"{key}_up"][()].reshape(u.size, p.size)
            out[np.ix_(u, p)], out[np.ix_(p, u)] = block, block.T
        return out

    def projected(self, basis):
        """The family in fewer coordinates, those of u first."""
        small = object.__new__(Family)
        small.__dict__ |= self.__dict__
        small.systems = [{key: basis.T @ A @ basis for key, A in one.items()} for one in self.systems]
        small.rows = [[row @ basis for row in rows] for rows in self.rows]
        small.load = basis.T @ self.load
        return small

    def at(self, theta):
        weights = [1.0, *theta]
        matrices = [sum(w * one[key] for w, one in zip(weights, self.systems)) for key in "MCK"]
        return matrices, [sum(w * rows[k] for w, rows in zip(weights, self.rows)) for k in range(3)]

    def answer(self, theta):
        """F_T at the ends of the steps, by the trapezoidal rule (Newmark's constant average acceleration), as soil_system.js has it."""
        (M, C, K), (position, velocity, acceleration) = self.at(theta)
        h, rest = self.step, np.zeros(len(M))
        A = np.linalg.inv(M + 0.5 * h * C + 0.25 * h * h * K)
        q = v = a = rest
        F = self.direct @ self.force[:, 1:]
        for i, f in enumerate(self.force[:, 1:].T):
            q, v = q + h * v + 0.25 * h * h * a, v + 0.5 * h * a
            a = A @ (self.load @ f - C @ v - K @ q)
            q, v = q + 0.25 * h * h * a, v + 0.5 * h * a
            F[i] += position @ q + velocity @ v + acceleration @ a
        return F


def laws_of(path, points, factors, nominal):
    """theta_q = theta_q0 prod (key/key_0)^e: e by the solved soils, halves of whole numbers as stiffness, conductivity and damping have them, so
    that other constants are noticed however few soils there are."""
    logs, of = np.log(points / nominal), np.log(np.abs(factors / factors[0]))
    powers, *_ = np.linalg.lstsq(logs, of, rcond=None)
    halves = np.round(2 * powers) / 2
    if np.linalg.matrix_rank(logs) < points.shape[1] or np.abs(logs @ halves - of).max() > 1e-8:
        raise ModelError(f"constants of the soils of '{path}' are no products of powers of its keys, such as with Poisson's ratio among them; "
                         "a page needs that: vary shear modulus, conductivity or damping")
    return halves.T


def theta(data, soil):
    """As soil_system.js has it."""
    ratio = np.array([soil[key["key"]] / key["value"] for key in data["keys"]])
    return np.array(data["theta"]) * np.prod(ratio ** np.array(data["powers"]), axis=1)


def drawn(keys, rng):
    def one(key):
        low, high, share = key["low"], key["high"], rng.random()
        return low * (high / low) ** share if key["logarithmic"] else low + (high - low) * share

    return {key["key"]: one(key) for key in keys}


def snapshots(family, thetas):
    """Answers at frequencies of the loads, weighed by these: columns of Re and Im."""
    end = family.step * (family.force.shape[1] - 1)
    frequencies = [0.0, *np.geomspace(0.3 / end, 30 / end, FREQUENCIES - 1)]
    times, columns = family.step * np.arange(family.force.shape[1]), []
    for one in thetas:
        (M, C, K), _ = family.at(one)
        for f in frequencies:
            s = 2 / end + 2j * np.pi * f
            of_loads = family.step * family.force @ np.exp(-s * times)
            x = s * np.linalg.solve(s * s * M + s * C + K, family.load @ of_loads)
            columns += [x.real, x.imag]
    return np.array(columns).T


def directions(columns, metric, exact=0):
    """All directions of the columns, the largest in a metric first, behind `exact` coordinates that are kept."""
    columns, kept = columns.copy(), np.eye(len(columns), exact)
    columns[:exact] = 0
    L = np.linalg.cholesky(metric + 1e-10 * np.trace(metric) / len(metric) * np.eye(len(metric)))
    found = np.linalg.svd(L.T @ columns, full_matrices=False)[0]
    return np.hstack([kept, np.linalg.solve(L.T, found)])


def basis_of(family, parts, size):
    """u and phi apart, as symmetry and energy ask for; of u 3 in 5."""
    of_u = round(0.6 * size)
    basis = np.zeros((family.phi.size, size))
    basis[np.ix_(family.u, range(of_u))] = np.linalg.qr(parts[0][:, :of_u])[0]
    basis[np.ix_(family.p, range(of_u, size))] = np.linalg.qr(parts[1][:, : size - of_u])[0]
    return basis, of_u


def reduced(family, data):
    """(the family in as few coordinates as meet the tolerance, those of u, the largest error on unseen soils)."""
    rng = np.random.default_rng(1)
    made_of = [*data["solved"], *(theta(data, drawn(data["keys"], rng)) for _ in range(MADE_OF))]
    unseen = [theta(data, drawn(data["keys"], rng)) for _ in range(CHECKED)]
    columns, rate = snapshots(family, made_of), 2 * np.pi * 3 / (family.step * family.force.shape[1])
    (M, C, K), _ = family.at(np.exp(np.log(made_of).mean(axis=0)))
    of_u, of_p = (np.ix_(rows, rows) for rows in (family.u, family.p))
    parts = (directions(columns[family.u], (K + rate**2 * M)[of_u], family.exact), directions(columns[family.p], -(rate * (K + rate**2 * M) + C)[of_p]))
    exact = [family.answer(one) for one in unseen]
    size = 60
    while size <= MOST:
        basis, n_u = basis_of(family, parts, size)
        small = family.projected(basis)
        error = max(np.abs(small.answer(one) - F).max() / np.abs(F).max() for one, F in zip(unseen, exact))
        if error <= SHARE * TOLERANCE:
            return small, n_u, error
        size = int(1.25 * size)
    raise ModelError(f"'{family.path}': F_T of unseen soils is {100 * error:.2g} % wrong with {MOST} coordinates; a page needs {100 * TOLERANCE:.2g} %: make the box smaller")


def is_of_soils(path):
    """Whether a path is the file of a model of soils."""
    if path.suffix != ".h5" or not path.is_file():
        return False
    with open_h5(path) as file:
        return "family" in file and "box" in file


def soil_data(path):
    """The data of live/soils.js as a dict."""
    with open_h5(path) as file:
        box, family = file["box"], Family(file)
        factors, points = file["family/factors"][()], box["points"][()]
        names = [text_of(key) for key in box["key"][()]]
        rows = zip(names, *(box[key][()].tolist() for key in ("low", "high", "logarithmic")), points[0].tolist())
        data = {
            "title": text_of(file.attrs.get("title", "")),
            "warnings": warnings_in(file),
            "keys": [dict(zip(("key", "low", "high", "logarithmic", "value"), row)) for row in rows],
            "theta": factors[0].tolist(),
            "powers": laws_of(path, points, factors, points[0]).tolist(),
            "solved": factors,
        }
    small, n_u, error = reduced(family, data)
    del data["solved"]
    return {
        **data,
        "error": float(error),
        "tolerance": TOLERANCE,
        "step": family.step,
        "size": len(small.load),
        "of_u": n_u,
        "load": floats(small.load),
        "force": floats(family.force),
        "push": family.push.tolist(),
        "direct": family.direct.tolist(),
        "parts": [{**packed(one, n_u), "rows": [floats(row) for row in rows]} for one, rows in zip(small.systems, small.rows)],
    }


def packed(system, n_u):
    """Lower triangles of u and of phi, and the block between them; without what is zero."""
    blocks = {}
    for key, A in system.items():
        for name, block in (("uu", A[:n_u, :n_u]), ("pp", A[n_u:, n_u:]), ("up", A[:n_u, n_u:])):
            if np.any(block):
                blocks[key + name] = floats(block if name == "up" else block[np.tril_indices(len(block))])
    return blocks


def floats(values):
    return base64.b64encode(np.ascontiguousarray(values, dtype="<f4").tobytes()).decode()
