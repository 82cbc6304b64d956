"""Options that are declared once, elsewhere: a command gets them, and what they say as one parameter."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import wraps
from inspect import Parameter, Signature, signature
from typing import Annotated, Any, get_origin, get_type_hints

import typer

Command = Callable[..., None]


def option(name: str, kind: Any, default: Any = None, **about: Any) -> Parameter:
    """An option as a parameter; ``about`` are arguments of ``typer.Option``."""
    words = [f"--{name.replace('_', '-')}"] if kind is bool else []
    return Parameter(
        name,
        Parameter.KEYWORD_ONLY,
        default=default,
        annotation=Annotated[kind, typer.Option(*words, **about)],
    )


def with_options(
    name: str, options: Iterable[Parameter], made: Callable[..., Any]
) -> Callable[[Command], Command]:
    """Give a command ``options``, and as its parameter ``name`` what ``made`` makes of them.

    An option that the command has itself, such as ``cpi``, is passed to both; where the command does not say
    what it means, it means what it does in ``options``.
    """
    given = {one.name: one for one in options}

    def decorated(command: Command) -> Command:
        types = get_type_hints(command, include_extras=True)
        own = {
            key: one.replace(annotation=types[key])
            for key, one in signature(command).parameters.items()
            if key != name
        }

        @wraps(command)
        def run(**arguments: Any) -> None:
            values = {name: made(**{key: arguments[key] for key in given})}
            command(**{key: arguments[key] for key in own}, **values)

        # The interface of the command line is made from the signature and the annotations.
        declared = {key for key, one in own.items() if get_origin(one.annotation) is Annotated}
        shown = own | {key: one for key, one in given.items() if key not in declared}
        run.__dict__["__signature__"] = Signature(list(shown.values()))
        run.__annotations__ = {key: one.annotation for key, one in shown.items()}
        return run

    return decorated
