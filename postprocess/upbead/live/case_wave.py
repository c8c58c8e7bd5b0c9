"""The wave by Goda's formulas of a model's case: its section, its wave and the history of the force."""

# Values of docs/waves.md, used if the case has a section and no wave.
IMPACT = {"rise_coefficient": 0.769, "duration_least": 2.0, "duration_gain": 8.0, "duration_decay": 18.0}


def case_wave(case, loads):
    """The data of live/goda_wave.js as a dict, or None if the case has no [section]. loads: names of the model's
    loads."""
    if "section" not in case:
        return None
    design = {
        "water": {"density": case["fluid"]["density"], "gravity": case["gravity"]},
        "section": case["section"],
        "duration": {"a": 0.3, "b": 2.0},
        "combined": {"added_mass_factor": 1.0855, "uplift": "in_phase"},
        "limits": {},
    }
    waves = {name: load["wave"] for name, load in case.get("loads", {}).items() if name in loads and "wave" in load}
    if not waves:
        return of_design(design, first_wave(case["section"]), 0)
    name, wave = next(iter(waves.items()))
    given = {key: wave[key] for key in ("height", "significant_height", "deep_water_height", "period", "angle") if key in wave}
    found = of_design(design, given, loads.index(name))
    found |= {"course": wave["course"], "force": wave.get("force", "goda_with_alpha_I"), "impact": wave.get("impact", IMPACT)}
    return {**found, "profile": None if wave["course"] == "standing" else {"design": design, "given": given}}


def of_design(design, given, load):
    """The wave of a design, from which a load of the model may be made; the distribution of that load over the wall
    is not known."""
    return {"design": design, "given": given, "load": load, "course": "church_roof", "force": "goda_with_alpha_I", "impact": IMPACT, "profile": None}


def first_wave(section):
    """The wave shown at first: its height is half the water depth."""
    return {"height": 0.5 * section["water_depth"], "period": 10.0, "angle": 0.0}
