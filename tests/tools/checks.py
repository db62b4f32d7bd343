# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Counts what the readers of scripts/check-formats check.
import sys

checks, failures = 0, []


def check(name, found, expected):
    global checks
    checks += 1
    if found != expected:
        failures.append(f"{name}: {found} instead of {expected}")


def skip(reason):
    """A check that cannot be made here."""
    global checks
    checks += 1
    print(f"skipped: {reason}")


def run(*steps):
    """A reader that gives up is a failure like another."""
    global checks
    for step in steps:
        try:
            step()
        except (Exception, SystemExit) as error:
            checks += 1
            failures.append(f"{getattr(step, '__name__', 'step')}: {type(error).__name__}: {error}")


def finish():
    """The summary scripts/test counts, as Catch2 writes it; exit 1 after a failure."""
    for failure in failures:
        print(failure)
    print(f"test cases: {checks} | {checks - len(failures)} passed | {len(failures)} failed")
    sys.exit(1 if failures else 0)
