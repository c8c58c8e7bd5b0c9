"""Laws of stress as functions: while the program runs, it asks them by a socket."""

from __future__ import annotations

import contextlib
import functools
import os
import socket
import socketserver
import tempfile
import threading
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from .errors import UpbeadError, UserError

Array = NDArray[np.float64]
WORD = "python"  # of the law in a case
VARIABLE = "UPBEAD_STRESS_LAWS"
LONGEST = 70  # bytes of a folder in which a socket may be: with its own name 107
ROUND_OFF = 1e-9  # of the stress at rest, or of that at a strain of 1e-6: what a law may give without strain


@dataclass
class SoilPoints:
    """What is known of n points of soil: `shear_modulus` and `lame`, lambda (n, Pa), and the stress `at_rest` (n x 4: xx, yy, xy, zz, Pa,
    tension positive)."""

    shear_modulus: Array
    lame: Array
    at_rest: Array

    def elastic(self, strain: Array) -> Array:
        """The change of stress of elastic soil (n x 4, Pa)."""
        G2, mean = 2.0 * self.shear_modulus, self.lame * (strain[:, 0] + strain[:, 1])
        return np.column_stack([G2 * strain[:, 0] + mean, G2 * strain[:, 1] + mean, G2 * strain[:, 2], mean])


@dataclass
class StressLaw:
    """A law of stress for `law` of a region, to try one out: slow, as each evaluation of the ground asks Python.

    Parameters
    ----------
    function : f(strain, memory, soil) -> (stress, memory, mobilised)
        For n points at once: `strain` since rest (n x 3: xx, yy, xy, extension positive, xy half of gamma); `memory` of the points at the
        end of the last step (n x k), zero at rest; `soil`, SoilPoints. Returns the change of effective stress since rest (n x 4: xx, yy,
        xy, zz, Pa, tension positive), the memory with it, and the share of the strength that is mobilised (n). A strain of zero
        at rest gives a change of zero. Never called twice at once.
    memory : int
        k, numbers that the law remembers of a point.
    """

    function: Callable[[Array, Array, SoilPoints], tuple[Any, Any, Any]]
    memory: int = 0


def laws_of(case: Any) -> dict[str, StressLaw]:
    """The laws of a case's regions, or of the cases of a study, by the region's name."""
    found: dict[str, StressLaw] = {}
    if not isinstance(case, Mapping):
        return found
    regions = case.get("regions")
    for name, region in regions.items() if isinstance(regions, Mapping) else ():
        law = region.get("law") if isinstance(region, Mapping) else None
        if isinstance(law, StressLaw) or callable(law):
            found[str(name)] = law if isinstance(law, StressLaw) else StressLaw(law)
    cases = case.get("cases")
    for inner in (case.get("case"), *(cases if isinstance(cases, (list, tuple)) else [cases])):
        for name, law in laws_of(inner).items():
            if found.setdefault(name, law) != law:
                raise UserError(f"regions.{name}.law: two cases of a study have other functions for it; give them one, or the regions two names")
    return found


class Points:
    """The points of one region, of one process."""

    def __init__(self, region: str, law: StressLaw) -> None:
        self.region, self.law = region, law
        self.soil, self.kept, self.next = np.empty((0, 6)), np.empty((0, law.memory)), np.empty((0, law.memory))

    def add(self, soil: Array) -> None:
        if not len(soil):
            return
        none = np.zeros((len(soil), self.law.memory))
        stress = self.checked(np.zeros((len(soil), 3)), none, soil)[0]
        scale = np.maximum(np.abs(soil[:, 2:]).max(axis=1), 1e-6 * soil[:, 0])
        if (np.abs(stress).max(axis=1) > ROUND_OFF * scale).any():
            raise UserError(f"regions.{self.region}.law: without strain the stress changes by {np.abs(stress).max():.3g} Pa; let it start from soil.at_rest, with a change of 0")
        self.soil = np.concatenate([self.soil, soil])
        self.kept, self.next = np.concatenate([self.kept, none]), np.concatenate([self.next, none])

    def answer(self, committed: Array, asked: Array) -> Array:
        """The change of stress and the share mobilised (m x 5) of points that are asked for (m x 4: number, strain)."""
        past, at = committed.astype(int), asked[:, 0].astype(int)
        self.kept[past] = self.next[past]
        stress, self.next[at], mobilised = self.checked(asked[:, 1:], self.kept[at], self.soil[at])
        return np.column_stack([stress, mobilised])

    def checked(self, strain: Array, memory: Array, soil: Array) -> tuple[Array, Array, Array]:
        found = self.law.function(strain.copy(), memory.copy(), SoilPoints(soil[:, 0], soil[:, 1], soil[:, 2:]))
        n, k = len(strain), self.law.memory
        if not isinstance(found, tuple) or len(found) != 3:
            raise UserError(f"regions.{self.region}.law: give stress, memory and the share of the strength mobilised, three arrays")
        stress, after, mobilised = (np.asarray(part, dtype=float) for part in found)
        for what, part, shape in (("stress", stress, (n, 4)), ("memory", after, (n, k)), ("mobilised share", mobilised, (n,))):
            if part.shape != shape:
                raise UserError(f"regions.{self.region}.law: its {what} has the shape {part.shape}, not {shape}")
            if not np.isfinite(part).all():
                raise UserError(f"regions.{self.region}.law: its {what} has values that are no finite numbers")
        return stress, after, mobilised


class Conversation(socketserver.StreamRequestHandler):
    """With one process about one region: first the region's name; then, each time, points that are new, numbers of those whose step ended, and
    those that are asked for. A reply is the length of a complaint, and that; where it is 0 the numbers follow."""

    server: Answering

    def handle(self) -> None:
        with contextlib.suppress(EOFError, OSError):
            points = self.replied(lambda: self.points(self.read(int(self.numbers(1, np.int64)[0])).decode()))
            while points is not None:
                points = self.replied(functools.partial(self.answer, points))

    def points(self, region: str) -> tuple[Points, bytes]:
        if region not in self.server.laws:
            raise UserError(f"regions.{region}.law: no function was given for it")
        return Points(region, self.server.laws[region]), b""

    def answer(self, points: Points) -> tuple[Points, bytes]:
        soil, committed, asked = [self.numbers(n) for n in self.numbers(3, np.int64)]
        with self.server.turn:  # runs of a study ask at once
            points.add(soil.reshape(-1, 6))
            return points, points.answer(committed, asked.reshape(-1, 4)).tobytes()

    def replied(self, work: Callable[[], tuple[Points, bytes]]) -> Optional[Points]:
        try:
            points, reply = work()
        except (EOFError, OSError):
            raise
        except Exception as error:
            self.server.error = self.server.error or error
            text = f"{type(error).__name__}: {error}".encode()
            self.wfile.write(np.int64(len(text)).tobytes() + text)
            return None
        self.wfile.write(np.int64(0).tobytes() + reply)
        return points

    def numbers(self, n: Any, kind: Any = np.float64) -> NDArray[Any]:
        return np.frombuffer(self.read(8 * int(n)), dtype=kind)

    def read(self, size: int) -> bytes:
        data = self.rfile.read(size)
        if len(data) < size:
            raise EOFError
        return data


class Answering(socketserver.ThreadingUnixStreamServer):
    daemon_threads = True
    request_queue_size = socket.SOMAXCONN

    def __init__(self, path: Path, laws: dict[str, StressLaw]) -> None:
        self.laws = laws
        self.error: Optional[Exception] = None  # the first of a function
        self.turn = threading.Lock()
        super().__init__(str(path), Conversation)


@contextlib.contextmanager
def answering(laws: dict[str, StressLaw], raises: bool = True) -> Iterator[dict[str, str]]:
    """Answers for the laws as long as the context lasts; gives the variables of the environment by which the program asks. `raises`: an error
    of a function is raised in place of what the program says of it."""
    if not laws:
        yield {}
        return
    inside = tempfile.gettempdir() if len(os.fsencode(tempfile.gettempdir())) < LONGEST else "/tmp"
    with tempfile.TemporaryDirectory(prefix="upbead-", dir=inside) as folder, Answering(Path(folder) / "laws", laws) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            yield {VARIABLE: str(server.server_address)}
        except UpbeadError as found:
            if raises and server.error is not None:
                raise server.error from found
            raise
        finally:
            server.shutdown()
