"""The numbers of each kind of result, as rows of a table: [what, value of each case ...]."""

import numpy as np

from upbead import outputs

PREFIXES = {  # unit: (factor, name), the largest first
    "N/m": [(1e6, "MN/m"), (1e3, "kN/m")],
    "N m/m": [(1e6, "MN m/m"), (1e3, "kN m/m")],
    "m": [(1.0, "m"), (1e-2, "cm"), (1e-3, "mm")],
    "s": [(1.0, "s"), (1e-3, "ms")],
}
LAWS = {"paper": "eq. (7)", "exact": "eqs. (4), (6)", "combined": "combined", "dynamic": "own dynamics"}


def number(value, unit=""):
    """Three digits, with the prefix that suits the size.

    >>> number(2999.7, "N/m"), number(0.0298, "s"), number(0.75), number(None), number(1645), number(0.0, "m")
    ('3.00 kN/m', '29.8 ms', '0.750', '-', '1,645', '0 m')
    """
    if value is None:
        return "-"
    if isinstance(value, int):
        return f"{value:,}"
    factor, name = prefix(value, unit)
    return f"{digits(value / factor)} {name}".strip()


def prefix(value, unit):
    """(factor, unit) that suits the size of a value."""
    scales = PREFIXES.get(unit, [(1.0, unit)])
    return next((s for s in scales if abs(value) >= 0.9995 * s[0]), scales[-1 if value else 0])


def digits(value):
    """Three digits, with an exponent only for very small and very large numbers.

    >>> digits(0.99998), digits(0.0123456), digits(4831.2), digits(3e-12), digits(0.0)
    ('1.00', '0.0123', '4,831', '3.00e-12', '0')
    """
    if value == 0:
        return "0"
    exponent = int(f"{value:.2e}".partition("e")[2])
    return f"{value:,.{max(0, 2 - exponent)}f}" if -4 < exponent < 6 else f"{value:.2e}"


def of_run(summaries):
    rows = [("peak P", "response.peak_force"), ("time of peak P", "response.peak_force_time"),
            ("peak F_T", "response.peak_shear"), ("time of peak F_T", "response.peak_shear_time"),
            ("peak F_T / peak P", "response.shear_to_force_ratio"), ("largest x_G", "response.peak_displacement"),
            ("arm of P above the bottom", "response.arm"), ("largest base moment", "response.peak_base_moment"),
            ("peak F_S / (mu W')", "sliding.ratio"), ("S by eq. (4)", "sliding.sliding_history"),
            ("unknowns", "discretisation.unknowns"), ("solves", "discretisation.solves")]
    return [[what, *(number(at(summary, path), outputs.unit(path)) for summary in summaries)] for what, path in rows]


def at(summary, path):
    for key in path.split("."):
        summary = summary[key] if isinstance(summary, dict) else None
    return summary


def of_waves(summaries):
    """The only wave of each summary, or its first and its last wave."""
    waves = [wave for summary in summaries for wave in ends(list(summary["waves"].values()))]
    rows = [("height H", "height"), ("period T", "period"), ("alpha*", "alpha_star"), ("P", "force"),
            ("safety factor against sliding", "safety_sliding"), ("tau_0", "tau_0"), ("S by eq. (7)", "sliding_paper"),
            ("S by eqs. (4), (6)", "sliding_exact")]
    return [[what, *(number(wave[key], outputs.unit(f"waves.NAME.{key}", "waves")) for wave in waves)] for what, key in rows]


def ends(items):
    return items if len(items) == 1 else [items[0], items[-1]]


def of_expected(summaries):
    found = [summary["expected"] for summary in summaries]
    rows = [["years", *(f"{f['years']:g}" for f in found)], ["waves", *(number(int(f["waves"])) for f in found)]]
    for law, name in LAWS.items():
        if any(f[f"distance_{law}"] is not None for f in found):
            rows.append([f"expected sliding, {name}", *(number(f[f"distance_{law}"], "m") for f in found)])
            rows.append([f"least height that slides the caisson, {name}",
                         *(number(f["threshold_height"][law], "m") for f in found)])
    return rows


def of_calibrate(summaries):
    """a, b and r^2 of the fits by eqs. (4), (6), a column for each model."""
    models = summaries[0]["models"]
    fits = {name: [fit for fit in model["fits"] if fit["measure"] == "exact" and fit["ratio"] is not None]
            for name, model in models.items()}
    rows = [["waves", *(number(fits[name][0]["points"]) for name in models)]]
    for i, first in enumerate(next(iter(fits.values()))):
        rows.append([f"a, b at r = {first['ratio']:g}", *(fit_text(fits[name][i]) for name in models)])
    return rows


def of_reliability(summaries):
    """Probability in a life and beta of an occasion, for each way to fail."""
    return [[name, *(f"{number(mode['life']['probability'])}, {number(mode['occasion']['index'])}"
                     for mode in (summary["modes"][name] for summary in summaries))] for name in summaries[0]["modes"]]


def fit_text(fit):
    if fit["a"] is None:
        return "-"
    doubt = "" if fit["doubt"] == "none" else f" ({fit['doubt'].replace('_', ' ')})"
    return f"{digits(fit['a'])}, {digits(fit['b'])}{doubt}"


def of_study(tables):
    """Least, median and largest of every number read from the runs."""
    rows = [["runs", *(number(len(table)) for table in tables)]]
    if any(table.failed for table in tables):
        rows.append(["failed", *(number(len(table.failed)) for table in tables)])
    for read in tables[0].reads:
        unit = outputs.unit(read)
        rows.append([f"`{read}`", *(spread(table.numbers(read), unit) for table in tables)])
    return rows


def spread(values, unit):
    """Least, median and largest, in the unit of the largest; numbers below its last digit are written as 0.

    >>> spread(np.array([1e-12, 0.02, 0.04]), "m")
    '0, 2.00, 4.00 cm'
    """
    good = values[np.isfinite(values)]
    if not good.size:
        return "-"
    factor, name = prefix(np.abs(good).max(), unit)
    found = np.percentile(good, [0, 50, 100])
    found[np.abs(found) < 1e-6 * np.abs(found).max()] = 0.0
    return f"{', '.join(digits(value / factor) for value in found)} {name}".strip()


def table(command, opened):
    """Rows of one entry, from the results that `upbead.open` returned for each of its cases."""
    if command == "study":
        return of_study(opened)
    summaries = [result if isinstance(result, dict) else result.summary for result in opened]
    return {"run": of_run, "waves": of_waves, "expected": of_expected, "calibrate": of_calibrate,
            "reliability": of_reliability}[command](summaries)


def heads(command, cases, opened):
    """A heading for each column of numbers."""
    stems = [case.rsplit("/", 1)[-1].removesuffix(".toml") for case in cases]
    if command == "waves":
        return [stem if len(result["waves"]) == 1 else f"{stem}, {name}" for stem, result in zip(stems, opened)
                for name in ends(list(result["waves"]))]
    if command == "calibrate":
        return list(opened[0].models)
    if command == "reliability":
        return ["probability in a life, beta of an occasion"]
    return stems if len(stems) > 1 else [""]
