"""The package's exceptions as the command line's: same sentence, exit status 2 or 1."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import click


class RefusedValue(click.UsageError):
    """A value the package does not take; its own sentence says all there is to say."""


@contextmanager
def reported() -> Iterator[None]:
    """Turn a refused value into a usage error (status 2), a missing package into a failure (1)."""
    try:
        yield
    except (TypeError, ValueError) as error:
        raise RefusedValue(str(error), click.get_current_context(silent=True)) from error
    except ImportError as error:
        raise click.ClickException(str(error)) from error
