"""What a model of soils answers, as plain numbers and arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass
class WaveAnswer:
    """numbers: as a wave has them in summary.json, each an attribute, too: `ratio`, `peak_shear` (N/m), `sliding` (S, m),
    `error_estimate`; None where there is none. time: s; histories: {name: array} in SI units; history_errors: of each,
    estimated, over its largest value."""

    name: str
    numbers: dict[str, Any]
    time: NDArray[np.float64] | None = field(default=None, repr=False)
    histories: dict[str, NDArray[np.float64]] = field(default_factory=dict, repr=False)
    history_errors: dict[str, float] = field(default_factory=dict)

    def __getattr__(self, name: str) -> Any:
        try:
            return self.__dict__["numbers"][name]
        except KeyError:
            raise AttributeError(f"a wave's answer has no '{name}'") from None


@dataclass
class SoilAnswer:
    """soil: all keys of the box. error: of F_T's history under the loads of the case, over its peak. waves: a WaveAnswer
    for each wave; where there is one, its attributes are those of this, too. warnings, why_void: as in summary.json."""

    soil: dict[str, float]
    error: float
    waves: list[WaveAnswer]
    warnings: list[dict[str, Any]]
    why_void: str | None = None

    def __getattr__(self, name: str) -> Any:
        waves = self.__dict__.get("waves", [])
        if len(waves) != 1:
            raise AttributeError(f"'{name}' is of one wave, and there are {len(waves)}: take that of waves[i]")
        return getattr(waves[0], name)


def soil_answer(line: Mapping[str, Any]) -> SoilAnswer:
    """The SoilAnswer of a line of the server, a dict."""
    return SoilAnswer(line["soil"], line["error"], [wave_answer(dict(wave)) for wave in line["waves"]], line["warnings"], line.get("why_void"))


def wave_answer(numbers: dict[str, Any]) -> WaveAnswer:
    time, histories = numbers.pop("time", None), numbers.pop("histories", {})
    return WaveAnswer(numbers.pop("name"), history_errors=numbers.pop("history_errors", {}),
                      time=None if time is None else np.array(time), numbers=numbers,
                      histories={name: np.array(values) for name, values in histories.items()})
