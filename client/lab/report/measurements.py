"""The engine against published measurements: the section of the report, and MEASURED.md, from validate.json."""

import tables
from numbers_in_words import NOTHING, duration, listed, metres
from results import median_of, solvers_of

NOT_MEASURED = """\
What no public measurement exists for, so that nothing here says how right the engine is there:

- the drop edge of a pocket: when a ball that slows on it falls, and when it hangs;
- the jaws of a pocket: how rubber that ends gives way, and how a ball rattles;
- the bounce of a ball on the slate, from a jump or a hard break;
- massé: swerve by an elevated cue;
- jump shots: speed and angle from cue to flight;
- English at the rails with pool balls, by angle and speed;
- clusters: how a rack or a pressed group shares an impact."""


def _value(table, value):
    return NOTHING if value is None else f"{value:.{table['digits']}f}"


def _error(table, value, sign="+"):
    if value is None:
        return NOTHING
    return f"{100 * value:{sign}.1f} %" if table["relative"] else f"{value:{sign}.{table['digits']}f}"


def _size(table, value):
    """An rms or a reach, with its unit."""
    text = _error(table, value, "")
    return text if value is None or table["relative"] or not table["unit"] else f"{text} {table['unit']}"


def _published(table, row):
    low, high = row["published"]
    return _value(table, low) if low == high else f"{_value(table, low)} to {_value(table, high)}"


def best_rms(table):
    """(rms, model) of the model that is nearest, without outliers where there are any."""
    rms = [plain if without is None else without for plain, without in zip(table["rms"], table["rms_without_outliers"])]
    known = [(value, model) for value, model in zip(rms, table["models"]) if value is not None]
    return min(known, default=None)


def _rms_words(table, number):
    text = _size(table, table["rms"][number])
    without = table["rms_without_outliers"][number]
    return text if without is None else f"{text}; {_size(table, without)} without *"


def markdown_table(table):
    """One published table: a row a value, a column a model, the rms below."""
    heads = ["", f"published{', ' + table['unit'] if table['unit'] else ''}", *table["models"]]
    rows = [[row["what"] + (" *" if row["outlier"] else ""), _published(table, row),
             *(NOTHING if ours is None else f"{_value(table, ours)} ({_error(table, error)})"
               for ours, error in zip(row["ours"], row["errors"]))] for row in table["rows"]]
    rows.append(["**rms error**", "", *(_rms_words(table, number) for number in range(len(table["models"])))])
    return tables.table(heads, rows)


def reached(validate):
    """A sentence for each table that has an aim."""
    for table in validate["tables"]:
        best = best_rms(table)
        if table["reach"] is None or best is None:
            continue
        value, model = best
        verdict = "reached" if value <= table["reach"] else "not reached"
        said = f"{table['title']}: {_size(table, value)} rms with {model}; aim {_size(table, table['reach'])}, {verdict}."
        yield f"{said} {table['note']}".strip() if verdict == "not reached" or table["relative"] else said


def _shares_of_reach(table):
    """By model, its rms over the aim."""
    rms = [plain if without is None else without for plain, without in zip(table["rms"], table["rms_without_outliers"])]
    return {model: value / table["reach"] for model, value in zip(table["models"], rms) if value is not None}


def both_at_once(validate):
    """Whether one model reaches both aims for the filmed shots; None where they were not measured."""
    found = {table["name"]: table for table in validate["tables"]}
    speed, angle = found.get("two_balls_speed"), found.get("two_balls_angle")
    if speed is None or angle is None:
        return None
    of_speed, of_angle = _shares_of_reach(speed), _shares_of_reach(angle)
    worse = {model: max(of_speed[model], of_angle[model]) for model in of_speed}
    best = min(worse, key=worse.get)
    verdict = "reaches both aims" if worse[best] <= 1 else "comes nearest; no one model reaches both aims"
    return (f"Two balls, speeds and angles by one model: {best} {verdict}, with {_size(speed, of_speed[best] * speed['reach'])} and "
            f"{_size(angle, of_angle[best] * angle['reach'])}.")


def recorded_table(validate):
    heads = ["rail", "shots", "all balls, whole shot: p25", "median", "p75", "cue ball to its third rail: p25", "median", "p75"]
    rows = []
    for one in validate["recorded"]:
        for name, part in (("even, constants not fitted", "unfitted"), ("odd, constants fitted to them", "odd"),
                           ("even, constants fitted to the odd", "even")):
            found = one[part]
            rows.append([one["model"], f"{found['shots']} {name}",
                         *(metres(found[distance][quartile]) for distance in ("whole", "to_third_rail")
                           for quartile in ("p25", "median", "p75"))])
    return tables.table(heads, rows)


def recorded_words(validate):
    """What the recorded shots say, best rail first; None without a recording."""
    known = sorted(validate["recorded"], key=lambda one: one["even"]["whole"]["median"])
    if not known:
        return None
    best = known[0]["even"]
    return (f"Of {validate['recorded_shots']} recorded three-cushion shots, constants fitted to the odd ones, the even ones follow "
            f"{known[0]['model']}'s rail within {metres(best['whole']['median'])} (all balls, whole shot, median) and "
            f"{metres(best['to_third_rail']['median'])} (cue ball to its third rail).")


def unknown_of(validate, name):
    return next((one for one in validate["unknowns"] if one["ensemble"] == name), None) if validate else None


def enough(ensemble, unknown):
    """By solver the lowest rate whose median error is below what balls put down 0.1 mm off make, with its cost."""
    for solver, points in solvers_of(ensemble).items():
        good = [point for point in points
                if median_of(point, "rest_error") is not None and median_of(point, "rest_error") <= unknown["placement"]["median"]]
        yield solver, min(good, key=lambda point: point["cost"]["ns"]) if good else None


def enough_table(accuracy, validate, time):
    """From which rate and cost on a better solver buys nothing that a table could show."""
    rows = []
    for ensemble in accuracy["ensembles"]:
        unknown = unknown_of(validate, ensemble["name"])
        if unknown is None or not ensemble["points"]:
            continue
        found = dict(enough(ensemble, unknown))
        cells = []
        for solver in ("euler", "semi_implicit", "exact_arc", "overlap", "event"):
            point = found.get(solver)
            rate = "" if point is None or point["hz"] is None else f" ({point['hz']:g} Hz)"
            cells.append(NOTHING if point is None else f"{time(point['cost']['ns'])}{rate}")
        rows.append([ensemble["title"], metres(unknown["placement"]["median"]), metres(unknown["coefficients"]["median"]), *cells])
    return tables.table(["ensemble", "balls 0.1 mm off", "another table", "`euler`", "`semi_implicit`", "`exact_arc`", "`overlap`",
                         "`event`"], rows) if rows else ""


def horizons_words(validate):
    """How soon a break is beyond prediction."""
    for one in validate["horizons"]:
        steps = listed(f"{horizon:.2f} s at {metres(error, 1)}" for error, horizon in zip(one["input_error"], one["horizon"]))
        yield (f"{one['ensemble'].replace('_', ' ')}: with every ball put down off by so much, its events are the same until "
               f"{steps} (median of {one['shots']}; a whole break takes {one['duration'][0]:.1f} s).")


def section(validate):
    """"Against measured billiards", in words."""
    heading = "## Against measured billiards\n\n"
    if validate is None:
        return heading + "Not measured in this run."
    lines = [*reached(validate), both_at_once(validate), recorded_words(validate)]
    return (f"{heading}`{validate['command']}` holds every model against every published measurement that we know; "
            "[MEASURED.md](MEASURED.md) has each table, its source, and what nobody has measured.\n\n"
            + "\n".join(f"- {line}" for line in lines if line))


def unknown_section(accuracy, validate, time):
    """What a better solver cannot buy."""
    if validate is None:
        return ""
    found = enough_table(accuracy, validate, time)
    if not found:
        return ""
    horizons = "\n".join(f"- {line}" for line in horizons_words(validate))
    return f"""### What is not known

However well a shot is computed, two things about it are not known: where the balls are, to 0.1 mm at best, and the table's
coefficients, within the spread of their measurements (`client/lab/validate/unknown.cpp` has each, with its source). The table says how
far they move the rest of the same shot (median), and by which rate and cost of each solver its own error is smaller than that of the
balls' places: what is more exact buys nothing that a table could show. The figures have both as bands.

{found}

How soon a break is beyond prediction:

{horizons}"""


def _figures(validate, names):
    return "\n\n".join(f"![{one['title']}](figures/measured_{one['name']}.png)\n\n[SVG](figures/measured_{one['name']}.svg)"
                       for one in validate["figures"] if one["name"] in names)


FIGURES = {"two_balls_angle": ("two_balls",), "square_rebound_slow": ("rebound",), "rail_ratio": ("rail_ratio",),
           "throw_by_speed": ("throw",), "squirt": ("squirt",)}


def _recorded(validate):
    if not validate["recorded"]:
        return "No recording was given in this run: `poolhall-lab validate --recorded FILE`."
    constants = [f"- {one['model']}: {', '.join(f'{name} {value:.4g}' for name, value in one['constants'].items())}; "
                 f"{duration(one['seconds'])}" for one in validate["recorded"]]
    return f"""{recorded_words(validate)} Root mean square distances over the samples of each shot, quartiles over shots. Of each shot the fit
may choose aim, speed, two offsets of the tip and a delay up to 0.08 s; the constants of the table are the same for all.

{recorded_table(validate)}

{chr(10).join(constants)}"""


def page(validate):
    """MEASURED.md."""
    build = validate["build"]
    parts = [f"""# Billiards as measured

Every published measurement that we know beside what the engine gives for it, model by model. Written by `./poolhall report` from

    {validate['command']} --out DIR

({build['compiler']}, `{build['flags']}`, {build['cpu']}). Errors are ours minus what was published, in brackets; within a published range
they are 0. The numbers are simulated by the event solver; published ones stand in `client/lab/validate`, a file a subject. "Second hand"
is what was read in another's quotation. * is an outlier."""]
    for table in validate["tables"]:
        reach = "" if table["reach"] is None else f" Aim: {_size(table, table['reach'])} rms."
        parts.append(f"## {table['title']}\n\nSource: {table['source']}. Accuracy: {table['accuracy']}.{reach}\n\n{markdown_table(table)}")
        if table["note"]:
            parts.append(table["note"])
        parts.append(_figures(validate, FIGURES.get(table["name"], ())))
    parts += [f"## Recorded three-cushion shots\n\n{_recorded(validate)}", f"## What nobody has measured\n\n{NOT_MEASURED}"]
    return "\n\n".join(part for part in parts if part) + "\n"
