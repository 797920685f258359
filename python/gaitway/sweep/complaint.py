"""What can go wrong with a sweep, and the exit code that each of it ends a program with."""

from __future__ import annotations

EXIT_FINE = 0
EXIT_BAD_INPUT = 1  # nothing ran
EXIT_NOT_DONE = 3  # trials are missing; what is stored stays, and the same command goes on from there
EXIT_INCOMPLETE = 4  # all trials ran, but their results could not be written
EXIT_DISAGREEMENT = 5  # two workers gave two results for one trial


class SweepError(Exception):
    """Ends a sweep; `exit_code` is the program's."""

    exit_code = EXIT_NOT_DONE


class InputError(SweepError, ValueError):
    """A file or an option that cannot be used. Nothing ran."""

    exit_code = EXIT_BAD_INPUT


class NoWorkersError(SweepError):
    """Nobody is there to run trials, or nobody who may."""


class TrialError(SweepError):
    """A trial that no worker survives."""


class DisagreementError(SweepError):
    """Two workers gave two results for one trial."""

    exit_code = EXIT_DISAGREEMENT


class ResultsError(SweepError):
    """The client cannot write what the trials brought."""

    exit_code = EXIT_INCOMPLETE


class ImpossibleError(ValueError):
    """Values that are right, each by itself, but that nobody can run together: that is a result."""


class UnfitWorkerError(Exception):
    """Raised on a worker that must run no trials of this sweep: it lacks something, or has something else."""
