"""What a summary tells that nobody may miss: its checks and its warnings, wherever in it they stand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from html import escape
from math import inf
from typing import Any

LIFE = "failure over the life"  # the way to fail of a probability, whose target is a limit without a key


def objects(found: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], dict[str, Any]]]:
    """(path, object) of a summary and of all that is in it. A sheet has the checks and warnings of its parts."""
    if not path and isinstance(found, dict) and "parts" in found:
        found = {key: found.get(key) for key in ("verdict", "checks", "warnings")}
    if isinstance(found, dict):
        yield path, found
        for key, value in found.items():
            yield from objects(value, (*path, key))
    elif isinstance(found, list):
        for value in found:
            yield from objects(value, path)


def checks(summary: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Every check once, the worst first: those that fail, those that could not be judged, those that hold, those
    without a limit."""
    found: list[dict[str, Any]] = []
    for path, one in objects(summary):
        if path[-1:] != ("verdict",) and "name" in one and ("holds" in one or "failing" in one) and one not in found:
            found.append(one)
    return sorted(found, key=rank)


def rank(check: Mapping[str, Any]) -> tuple[int, float]:
    order = 0 if fails(check) else 1 if check.get("why_not") else 2 if check.get("holds") else 3
    return order, check["margin"] if check.get("margin") is not None else -inf


def fails(check: Mapping[str, Any]) -> bool:
    """Of a study `failing` is the number of runs in which it fails."""
    return check.get("holds") is False or (check.get("failing") or 0) > 0


def is_judged(check: Mapping[str, Any]) -> bool:
    return check.get("holds") is not None or (check.get("failing") or 0) > 0


def unjudged(summary: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Checks whose limit was given, and that could not be judged: mu W' is a capacity, and no limit."""
    return [check for check in checks(summary) if check.get("why_not") and check.get("capacity") is not None and "judged" not in check
            and (check.get("limit") or check.get("mode") == LIFE)]


def check_text(check: Mapping[str, Any]) -> str:
    """One line for people, the program's own; results of older versions have none."""
    if check.get("text"):
        return str(check["text"])
    demand, capacity, unit = (check.get(key) for key in ("demand", "capacity", "unit"))
    number = "without bound" if demand is None else f"{demand:.4g} {unit or ''}".strip()
    against = "no limit given" if capacity is None else f"against {capacity:.4g}: {'holds' if check.get('holds') else 'DOES NOT HOLD'}"
    return f"{check['name']}: {number} {against}"


def warnings(summary: Mapping[str, Any]) -> list[tuple[str, str]]:
    """[(name, text)] of every warning once, its cure first; of a wave's own that of the whole summary, which names the
    wave, stands for it."""
    found: list[tuple[str, str]] = []
    seen: list[tuple[str, str]] = []
    for path, one in objects(summary):
        for warning in one.get("warnings") or () if isinstance(one.get("warnings"), list) else ():
            pair = warning["name"], warning["text"]
            if not any(name == pair[0] and pair[1] in text for name, text in seen):
                seen.append(pair)
                found.append((pair[0], text_at(path, warning_text(warning))))
    return found


def warning_text(warning: Mapping[str, Any]) -> str:
    """What to do, and why; results of older versions have no cure of its own."""
    cure = warning.get("cure")
    return f"{cure}: {warning['text'].removesuffix(f'; {cure}')}" if cure else str(warning["text"])


def text_at(path: tuple[str, ...], text: str) -> str:
    """The text, with the wave and the level that it is of: of ("waves", "design", "levels", "low")."""
    where = [name for above, name in zip(path, path[1:]) if above in ("waves", "levels")]
    return f"{' at '.join(where)}: {text}" if where else text


def void(summary: Mapping[str, Any]) -> str | None:
    """Why no verdict may be drawn, of a study by runs; or None."""
    runs = summary.get("void")
    if isinstance(runs, list):
        return "; ".join(f"{numbered(one['runs'])}: {one['why']}" for one in runs) or None
    return (summary.get("verdict") or {}).get("why_void") or summary.get("why_void") or runs  # an answer to waves has no verdict


def is_partly_void(summary: Mapping[str, Any]) -> bool:
    """Of a study: whether runs are, and not all."""
    return void(summary) is not None and not is_all_void(summary)


def is_all_void(summary: Mapping[str, Any]) -> bool:
    """Of a study: whether all of its runs are."""
    runs = summary.get("void")
    return bool(sum(len(one["runs"]) for one in runs) >= summary["runs"]) if isinstance(runs, list) else void(summary) is not None


def numbered(runs: list[int], most: int = 5) -> str:
    """
    >>> numbered([3]), numbered([1, 2, 3], 2)
    ('run 3', 'runs 1, 2 and 1 more')
    """
    more = f" and {len(runs) - most} more" if len(runs) > most else ""
    return f"run{'s' * (len(runs) > 1)} {', '.join(map(str, runs[:most]))}{more}"


def summaries(thing: Any) -> list[Mapping[str, Any]]:
    """Those of a result, of a model, which has warnings alone, and of all that is in a list or dict of them."""
    if hasattr(thing, "cautions"):  # of a Fit or a Posterior
        return [{"warnings": [{"name": text, "text": text} for text in thing.cautions]}]
    if isinstance(getattr(thing, "summary", None), Mapping):
        return [thing.summary]
    if isinstance(thing, Mapping) and (isinstance(thing.get("verdict"), Mapping) or isinstance(thing.get("warnings"), list)):
        return [thing]
    if isinstance(thing, (Mapping, list, tuple)):
        return [one for part in (thing.values() if isinstance(thing, Mapping) else thing) for one in summaries(part)]
    found = getattr(thing, "warnings", None)
    if isinstance(found, Mapping):  # of a Sensitivity, by name
        return [{"warnings": [{"name": name, "text": text} for name, text in found.items()], "why_void": thing.why_void}]
    return [of_warnings(found, getattr(thing, "title", ""))] if isinstance(found, list) else []


def of_warnings(found: list[dict[str, Any]], title: str = "") -> dict[str, Any]:
    """As a summary, of what has neither checks nor verdict."""
    return {"title": title, "warnings": found, "why_void": "; ".join(dict.fromkeys(one["name"] for one in found if one.get("voids"))) or None}


def listed(summary: Mapping[str, Any]) -> str:
    """HTML of all checks that fail or have a limit and no judgement, and of all warnings, in the program's words; "" where there is
    none of them."""
    fail = [check_text(check) for check in [*(check for check in checks(summary) if fails(check)), *unjudged(summary)]]
    items = [f'<li class="warned">{escape(text)}</li>' for text in ([f"No verdict may be drawn: {void(summary)}"] if void(summary) else []) + fail]
    items += [f'<li class="warned"><code>{escape(name)}</code>: {escape(text)}</li>' for name, text in warnings(summary)]
    return f'<ul class="told">{"".join(items)}</ul>' if items else ""
