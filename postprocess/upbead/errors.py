"""Errors of this package, by who can correct them."""


class UpbeadError(Exception):
    """The base of all errors of this package."""


class UserError(UpbeadError):
    """An error that the caller can correct: a folder without results, a name that does not exist."""


class CaseError(UserError):
    """The program refused its input (exit code 1). The text is the program's own: every mistake with its cure."""


class ModelError(UserError):
    """A file is no reduced model, or the question does not fit it."""


class NumericsError(UpbeadError):
    """The program could not solve the case (exit code 2). The text says why."""
