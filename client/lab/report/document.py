"""The report: figures, tables, and what they say, put together as one page of Markdown."""

import measurements
import tables
import words
from findings import has_verdicts, measured
from numbers_in_words import duration, listed, metres, time_of_ns
from results import ensemble_of

# The two that the short answer and the main table are about, where the run has them.
MAIN = ("two_balls", "nine_ball_break")

SOLVERS = """\
- `euler`: explicit Euler, the original game's way, with contacts found inside the tick.
- `semi_implicit`: semi-implicit Euler.
- `exact_arc`: closed-form motion inside each tick.
- `overlap`: the original's test for overlap at the end of a tick, kept to show what it misses.
- `event`: closed-form motion from event to event; it has no ticks.

`euler:30` is `euler` at 30 ticks a second (30 Hz)."""

DEFINITIONS = """\
- **Ensemble**: many shots of one kind, drawn at random from the seed: the same seed gives the same shots.
- **Reference**: the same shot by the means named in the table of ensembles. What it says counts as right.
- **Error at rest**: how far a ball comes to rest from where the reference has it; of a shot, the worst of its balls. Where
  the collisions have gone another way, that is no longer a small number but the size of the table: see *horizon*.
- **Median, 90th percentile, largest**: over the shots of the ensemble. Half of the shots are better than the median.
- **Time a shot**: CPU time of one whole shot, on the average over shots of the ensemble; measured apart from the errors,
  the median of repeats.
- **Worst tick**: the most CPU time that falls into one thirtieth of a second of a shot, which is what a game that shows
  30 states a second feels.
- **Verdict**: which balls are in which pockets at the end. It **flips** when it is not the reference's. **Winner**
  likewise, by the game's rules or the ball that goes down first.
- **Events that match**: the part of the reference's collisions, pocketings and so on, from the start, that the solver has
  in the same order. The **horizon** is the time at which that ends: up to it places can be compared, after it only
  statistics.
- **Missed, invented**: collisions between balls that only the reference has, and that only the solver has.
- **First impact**: when, where and how fast the first collision of a shot is.
- **Energy**: how far the balls' energy is off while the events match, as a part of the energy at the start.
- **Order**: p, where the error falls as 1/rate^p: with p = 1, twice the rate halves the error; with p = 2 it quarters it.
  Fitted to the medians at the rates at which the error falls evenly; in brackets the interval that holds it with a
  confidence of 95 %. Expected: by theory.
- **Pareto front**: the solvers and rates that no other beats in both time and error. The same shots timed twice
  differ by 15 % on a quiet machine and by 30 % on a busy one, so neighbours on it may change places.
- **A tenth of the error**: from its rate with the largest median error to that with the smallest, the error falls E times
  and the time grows C times; a tenth then costs C^(1 / log10 E) times the time."""


TO_THE_LETTER = "`client/lab/accuracy/README.md` has each of these to the letter."


def _picture(name, text):
    return f"![{text}](figures/{name}.png)\n\n[SVG](figures/{name}.svg)"


def _bullets(lines):
    return "\n".join(f"- {line}" for line in lines if line)


def _by_title(ensembles, say):
    return _bullets(f"{ensemble['title']}: {said}" for ensemble in ensembles for said in [say(ensemble)] if said)


def _head(accuracy):
    build = accuracy["build"]
    warnings = ""
    if accuracy["quick"]:
        warnings += "\n**A quick run**: few shots and fewer rates; the numbers are rougher than those of a full one.\n"
    if not accuracy["complete"]:
        warnings += "\n**The run was interrupted**: this is what was finished.\n"
    rows = [["processor", build["cpu"]], ["compiler", build["compiler"]], ["flags", f"`{build['flags']}`"],
            ["seed", str(accuracy["seed"])], ["command", f"`{accuracy['command']}`"],
            ["time that it took", duration(accuracy["seconds"])]]
    return f"""\
# What accuracy costs in time

The same shots by every solver at many rates, each compared with a reference of far higher precision. Text, tables and figures are
written by `./poolhall report` from what it measured; [the words](#what-the-words-mean) are explained below.
{warnings}
| | |
| --- | --- |
""" + "\n".join(f"| {name} | {value} |" for name, value in rows)


def _short(accuracy, main):
    ensembles = accuracy["ensembles"]
    lines = [words.simplest(accuracy)] if any(measured(ensemble) for ensemble in ensembles) else []
    for ensemble in main:
        for said in (words.event_beside_euler(ensemble), words.price_of_ten(ensemble)):
            lines.append(said and f"{ensemble['title']}: {said}")
    lines += [f"Where `euler:30` is enough. {words.where_euler_is_enough(ensembles)}", words.who_wins(ensembles)]
    return f"## In short\n\n{_bullets(lines)}"


def _main_tables(main):
    parts = ["## The main table"]
    for ensemble in main:
        parts += [f"### {ensemble['title']}, {ensemble['shots']} shots", tables.main_table(ensemble)]
        impacts = tables.impacts_table(ensemble)
        if impacts:
            parts += ["Medians of the first impact's errors and of the energy's:", impacts]
    return "\n\n".join(parts)


def _work_precision(ensembles, main):
    shown = [ensemble for ensemble in ensembles if measured(ensemble)]
    others = listed(f"[{ensemble['title']}](figures/work_precision_{ensemble['name']}.png)"
                    for ensemble in shown if ensemble not in main)
    parts = ["## Error against cost", _picture("work_precision", "Error against cost, a panel for each ensemble")]
    for ensemble in main:
        if ensemble not in shown:
            continue
        parts += [_picture(f"work_precision_{ensemble['name']}", f"{ensemble['title']}: error against cost, rate by rate"),
                  f"The cheapest way to some accuracies (median), {ensemble['title'].lower()}:", tables.bounds_table(ensemble)]
    if others:
        parts.append(f"The other ensembles, as large: {others}.")
    parts += ["Who is on the Pareto front:", _by_title(shown, words.front_of),
              "What a tenth of the error costs, in times the time:", tables.tenfold_table(shown)]
    return "\n\n".join(parts)


def _orders(accuracy):
    found = tables.orders_table(accuracy["ensembles"])
    if not found:
        return "## Order of convergence\n\nNo order was fitted in this run."
    missed = words.orders_missed(accuracy)
    verdict = "All are within 10 % of what theory expects."
    if missed:
        verdict = f"Not within 10 % of what theory expects:\n\n{_bullets(missed)}"
    return f"## Order of convergence\n\n{found}\n\n{verdict}"


def _verdicts(ensembles):
    if not any(map(has_verdicts, ensembles)):
        return "## Verdicts\n\nNo solver flipped a verdict in this run."
    none = listed(ensemble["title"] for ensemble in ensembles if not has_verdicts(ensemble))
    rest = f"\n\nNo solver at any rate flips a verdict in: {none}." if none else ""
    return "\n\n".join(["## Verdicts", _picture("verdict_flips", "Share of shots whose verdict flips, against the rate"),
                        tables.flips_table(ensembles) + rest])


def _in_time(ensembles):
    shown = [ensemble for ensemble in ensembles if ensemble["error_in_time"]]
    picture = _picture("error_in_time", "Error against time within a shot") if shown else "No run in time was recorded."
    horizons = tables.horizons_table(ensembles)
    said = ""
    if horizons:
        said = f"The horizon: until when the events are those of the reference, in the median shot.\n\n{horizons}"
    return f"## Within a shot\n\n{picture}\n\n{said}"


def _measured_or_not(heading, found, name, text):
    return f"## {heading}\n\n{_picture(name, text) if found else 'Not measured in this run.'}"


def _effects(effects):
    if effects is None or not (effects["effects"] or effects["kernels"]):
        return "## Effects\n\nNot measured in this run, so what each effect costs and is worth is left out."
    measured_by = f"Measured by `{effects['command']}`"
    if effects.get("shots"):
        measured_by += f", on {effects['shots']} shots for each effect and kernel"
    unfinished = "" if effects.get("complete", True) else " **The run was interrupted**: this is what was finished."
    parts = ["## Effects", f"{measured_by}.{unfinished}"]
    if effects["effects"]:
        parts += [_picture("effects", "What each effect costs, and how far it moves the balls"),
                  words.effects_in_words(effects["effects"]), tables.effects_table(effects)]
        counted = tables.instructions_table(effects)
        if counted:
            parts += ["The same in instructions, which no other work on the machine disturbs:", counted]
    if effects["kernels"]:
        parts += ["A kernel is the simulation with one set of effects compiled in; the cheapest that has all effects of a scene is "
                  "taken. A ball-step is one ball in one tick, by `semi_implicit` at 120 Hz; events and shots are by `event`:",
                  tables.kernels_table(effects)]
    return "\n\n".join(parts)


def _comparison(picture):
    said = "No picture of one shot by several solvers was drawn in this run."
    if picture:
        said = f"""{_picture("compare", "One break by several solvers: all paths on one table")}

The same break, computed by each; the crosses are collisions. [Event by event](results/compare.txt)."""
    return f"## One shot, several solvers\n\n{said}"


def _ensembles(accuracy):
    rows = [[ensemble["title"], str(ensemble["shots"]), ensemble["reference"], metres(ensemble["reference_error"], 1)]
            for ensemble in accuracy["ensembles"]]
    return tables.table(["ensemble", "shots", "reference", "its own error, about"], rows)


def markdown(accuracy, effects, validate, picture):
    """The whole report. `picture`: whether there is a comparison of one shot beside the other figures."""
    ensembles = accuracy["ensembles"]
    main = [ensemble for name in MAIN for ensemble in [ensemble_of(accuracy, name)] if ensemble] or ensembles[:2]
    again = accuracy["command"].removeprefix("poolhall-lab accuracy").strip()
    parts = [
        _head(accuracy), _short(accuracy, main), _main_tables(main), _work_precision(ensembles, main),
        measurements.unknown_section(accuracy, validate, time_of_ns), _orders(accuracy),
        _verdicts(ensembles), _in_time(ensembles),
        _measured_or_not("Tunnelling", accuracy["tunnelling"], "tunnelling", "Collisions missed, against speed"),
        _measured_or_not("Many balls", accuracy["crowds"], "crowds", "Cost of a shot, against the number of balls"),
        _effects(effects), _comparison(picture), measurements.section(validate),
        f"## What the words mean\n\n{SOLVERS}\n\n{DEFINITIONS}\n\n{TO_THE_LETTER}\n\n{_ensembles(accuracy)}",
        f"""## Again

    ./poolhall report{' ' + again if again else ''}

measures all of it anew and writes this page and its figures; other machines give other times, and the same errors,
verdicts and orders.
`./poolhall report --help` has what else it can do."""]
    return "\n\n".join(part.strip() for part in parts if part) + "\n"
