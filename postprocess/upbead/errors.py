"""Errors of this package, by who can correct them."""


class UpbeadError(Exception):
    """The base of all errors of this package."""


class UserError(UpbeadError):
    """An error that the caller can correct: a folder without results, a name that does not exist."""


class UnknownName(UserError, KeyError):
    """A name that is not there; the text says what is near."""

    def __str__(self) -> str:
        return str(self.args[0])


class CaseError(UserError):
    """The program refused its input (exit code 1). The text is the program's own: every mistake with its cure."""


class ModelError(UserError):
    """A file is no reduced model, or the question does not fit it."""


class SoilError(UserError):
    """A model of soils does not answer a soil: it lies outside the box, or its model did not converge. The text says
    why; `soil` is what was asked."""

    def __init__(self, text: str, soil: object = None) -> None:
        super().__init__(text, soil)
        self.soil = soil

    def __str__(self) -> str:
        return str(self.args[0])


class NumericsError(UpbeadError):
    """The program could not solve the case (exit code 2). The text says why."""
