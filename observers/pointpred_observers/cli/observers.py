"""``pointpred observers``: plants and observers in files, designed, audited and simulated."""

from __future__ import annotations

import warnings
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from pointpred.cli.output_files import Force, Numbers, Seed, check_targets
from pointpred.console import remark, remarks
from pointpred.errors import ParameterError
from pointpred.extras import require
from pointpred.files import write_whole
from pointpred_observers.cli import answer, existing, option

if TYPE_CHECKING:
    from pointpred_observers.simulations.result import Simulation

app = typer.Typer(no_args_is_help=True)


PlantFile = Annotated[Path, existing("JSON file of a plant.")]
DesignFile = Annotated[Path, existing("JSON file of a design.")]


@app.command()
def example(
    plant: Annotated[
        str,
        typer.Argument(
            help="motor, pendulum, tank, wing, spring, oven, or a generator: oscillator, heating."
        ),
    ] = "motor",
    out: Annotated[Path | None, option("FILE", "File to write; not given: printed.")] = None,
    force: Force = False,
) -> None:
    """Print a plant as JSON, to be changed into your own.

    A file holds one plant by its matrices, with "format", "version" and "kind" in front. Matrices are lists
    of rows, what is left out is zero.

    motor: with friction. pendulum: with a sine. tank: linear and sampled, time counts steps.
    wing: a matrix that varies, and an input that nobody measures. spring: equations as text, driven by the
    generator oscillator. oven: driven by the generator heating.

    Try:

      pointpred observers example

      pointpred observers example pendulum --out pendulum.json
    """
    from pointpred_observers.cli.observer_results import EXAMPLES
    from pointpred_observers.files import encoded

    if plant not in EXAMPLES:
        listed = " ".join(f"{name}: {one.__doc__}" for name, one in EXAMPLES.items())
        raise ParameterError(f"PLANT must be one of these, received {plant!r}. {listed}", field="plant")
    text = encoded(EXAMPLES[plant]())
    if out is None:
        typer.echo(text.decode(), nl=False)
        return
    check_targets({"--out": out}, [], force)
    write_whole(out, text)
    typer.echo(out)


@app.command()
def design(
    plant: PlantFile,
    generator: Annotated[Path | None, existing("JSON file of the generator (driven, interlaced).")] = None,
    kind: Annotated[
        str | None,
        option(
            "KIND",
            "reduced, full, driven, regulator, unknown-input or interlaced; else what the plant allows.",
        ),
    ] = None,
    decay: Annotated[float, option("RATE", "Decay demanded of the error, 1/s (1/step if discrete).")] = 1.0,
    out: Annotated[Path | None, option("FILE", "Design to write (PLANT_design.json).")] = None,
    upper: Annotated[int | None, option("ROWS", "Rows of the upper part (interlaced; 0).")] = None,
    first: Annotated[
        str | None, option("EXPRESSION", "Map of the first lower row, as w1 (interlaced).")
    ] = None,
    json: Numbers = None,
    force: Force = False,
) -> None:
    """Design an observer for the plant of a file, and write it with its certificate.

    reduced estimates what is not measured: for outputs with little noise. full filters the outputs too.
    driven: the plant follows a generator whose state is estimated. regulator: the estimate drives the plant.
    unknown-input: parameter-varying plants with inputs that nobody measures. interlaced: plants as equations.

    Where no gain satisfies the inequalities, the plant is refused with the reason, such as a mode that the
    outputs do not show, and exit code 1.

    Try:

      pointpred observers design motor.json --decay 5

      pointpred observers design motor.json --kind full --decay 5 --out filter.json
    """
    target = out or plant.with_name(f"{plant.stem}_design.json")
    inputs = [plant] if generator is None else [plant, generator]
    check_targets({"--out": target, "--json": json}, inputs, force)
    from pointpred_observers import SymbolicSystem, load, save
    from pointpred_observers import design as designed
    from pointpred_observers.cli.observer_results import print_design, summary

    read, driving = load(plant), None if generator is None else load(generator)
    if isinstance(read, SymbolicSystem) and kind in (None, "interlaced") and None in (driving, first):
        missing = [name for name, one in (("GENERATOR", driving), ("--first", first)) if one is None]
        words = "equations need the file of their generator as GENERATOR, --upper and --first"
        raise ParameterError(f"{plant}: {words}, received no {' and no '.join(missing)}", field="generator")
    options = {"generator": driving, "upper": upper, "first": first}
    given = {name: one for name, one in options.items() if one is not None}
    try:
        made = designed(read, kind, decay=decay, **given)
    except ParameterError as wrong:
        if wrong.field != "slopes":
            raise
        # Slopes stand in the file of the plant and in no option, so the file is where to mend them.
        raise ParameterError(f"{plant}: {wrong}", code=wrong.code, field=wrong.field) from wrong
    save(made, target)
    answer(json, partial(summary, made), partial(print_design, made))
    remarks().print(f"written: {target}. See it run: pointpred observers simulate {target}")


@app.command()
def audit(design: DesignFile, json: Numbers = None, force: Force = False) -> None:
    """Check every inequality and equality of a design again, from the matrices in its file.

    Prints how far each inequality holds, and the bound of the error that they prove. Exit code 1 if one
    fails, with its name. The gap, how far the design may be from the best one, is not checked.

    Try:

      pointpred observers audit motor_design.json
    """
    check_targets({"--json": json}, [design], force)
    from pointpred_observers import audit as audited
    from pointpred_observers.cli.observer_results import design_of, print_audit, summary

    made = design_of(design)
    margins = audited(made)
    answer(json, partial(summary, made), partial(print_audit, made, margins))


@app.command()
def simulate(
    design: DesignFile,
    seconds: Annotated[
        float | None, typer.Option(help="Length, s (10), or steps (1000) of a discrete plant.")
    ] = None,
    start: Annotated[str | None, option("A,B,...", "State of the plant at first; not given: ones.")] = None,
    input: Annotated[list[str] | None, option("EXPRESSION", "A known input over t; once for each.")] = None,
    unknown_input: Annotated[list[str] | None, option("EXPRESSION", "An unmeasured input over t.")] = None,
    parameter: Annotated[list[str] | None, option("NAME=EXPRESSION", "A scheduling variable over t.")] = None,
    noise: Annotated[str, option("SD", "Standard deviation of the outputs' noise, or one for each.")] = "0",
    seed: Seed = 0,
    plot: Annotated[Path | None, option("FILE", "Figure to draw: .svg, .png or .pdf.")] = None,
    out: Annotated[Path | None, option("FILE", "CSV file of every signal.")] = None,
    json: Numbers = None,
    force: Force = False,
) -> None:
    """Simulate a design with its plant: print the errors, draw them, write every signal.

    Expressions hold numbers, t, + - * / ** and functions such as sin, exp, tanh. --plot needs the
    extra 'report'.

    Try:

      pointpred observers simulate motor_design.json --input "sin(2*t)" --noise 0.01 --plot motor.png

      pointpred observers simulate motor_design.json --start 0.5,0,0 --seconds 4 --out motor.csv
    """
    check_targets({"--plot": plot, "--out": out, "--json": json}, [design], force)
    if plot is not None:
        from pointpred_observers.simulations.result import check_ending

        require("report", "--plot")
        check_ending(plot)
    from pointpred_observers import simulate as simulated
    from pointpred_observers.cli import observer_results as results

    made = results.design_of(design)
    asked = results.signals(start, noise, parameter, input=input, unknown_input=unknown_input)
    times = results.sampling(made.plant, seconds)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always", UserWarning)
        result: Simulation = simulated(made.plant, made, times=times, seed=seed, **asked)
    for one in told:
        remark(str(one.message))
    if plot is not None:
        result.plot(plot)
    if out is not None:
        results.write_signals(result, out)
    answer(json, partial(results.errors_document, result), partial(results.print_errors, result))
    for target in (plot, out):
        if target is not None:
            remarks().print(f"written: {target}")
