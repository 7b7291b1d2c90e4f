"""What `./poolhall report` does once poolhall-lab is built: measures, draws, and writes the page."""

import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import curves
import document
import effects_figure
import measured_figures
import measurements
import measuring
import verdicts
import work_precision
from findings import measured
from results import BadResults, read_accuracy, read_effects, read_validate

HERE = Path(__file__).resolve().parent
SCENE = HERE.parent / "scenes" / "break_9_ball.json"
BAD_INPUT = 2
FLAGS_OF_BOTH = ("--quick", "--seed")


def arguments_of(command_line):
    """The report's own options, and those that go on to `poolhall-lab accuracy`."""
    parser = argparse.ArgumentParser(
        prog="./poolhall report", allow_abbrev=False,
        description="Measures what accuracy costs in time, and writes it down with figures. "
                    "Other options go to poolhall-lab accuracy: --quick, --shots N, --seed N, --only PART.")
    parser.add_argument("--out", type=Path, default=HERE, metavar="DIR",
                        help="the folder for README.md, figures/ and results/; else client/lab/report")
    parser.add_argument("--draw-only", action="store_true", help="draw again from DIR/results, without measuring")
    parser.add_argument("--recorded", type=Path, metavar="FILE", help="recorded shots, for poolhall-lab validate")
    parser.add_argument("--lab", default="poolhall-lab", help=argparse.SUPPRESS)
    options, rest = parser.parse_known_args(command_line)
    if options.draw_only and rest:
        parser.error(f"--draw-only measures nothing, so {rest[0]} has no meaning")
    return options, rest


def effects_flags(rest):
    """Of the flags for accuracy, those that effects takes too; a full run counts instructions as well."""
    taken = [] if "--quick" in rest else ["--callgrind"]
    for number, flag in enumerate(rest):
        if flag.partition("=")[0] in FLAGS_OF_BOTH:
            taken += rest[number:number + (2 if flag == "--seed" else 1)]
    return taken


def measure(lab, rest, work, recorded):
    """Fills work/results and work/figures as far as it gets; the exit status.

    A run of accuracy takes long: what comes after it may fail without losing it."""
    results, figures = work / "results", work / "figures"

    def compare():
        with open(results / "compare.txt", "w", encoding="utf-8") as text:
            return lab.run("compare", SCENE, "--out", figures, stdout=text)

    def validate():
        return lab.run("validate", *(["--recorded", recorded] if recorded else []), "--out", results, stdout=subprocess.DEVNULL)

    status = 0
    if not lab.run("accuracy", *rest, "--out", results):
        return measuring.INTERRUPTED
    for command, run in (("effects", lambda: lab.run("effects", *effects_flags(rest), "--out", results)), ("compare", compare),
                         ("validate", validate)):
        if not lab.knows(command):
            print(f"poolhall: this poolhall-lab has no '{command}', so the report leaves it out", file=sys.stderr)
            continue
        try:
            if not run():
                return measuring.INTERRUPTED
        except measuring.Failed as failed:
            print(f"poolhall: '{command}' failed, so the report leaves it out", file=sys.stderr)
            status = failed.status
    return status


def source_of(data):
    build = data["build"]
    return f"{data['command']} · seed {data['seed']} · {build['cpu']} · {build['compiler']} · {build['flags']}"


def sheets(accuracy, effects, validate):
    """(name, sheet) of every figure for which there are numbers."""
    source = source_of(accuracy)
    ensembles = [ensemble for ensemble in accuracy["ensembles"] if measured(ensemble)]
    if ensembles:
        yield "work_precision", work_precision.overview(ensembles, validate, source)
    for ensemble in ensembles:
        yield f"work_precision_{ensemble['name']}", work_precision.figure(ensemble, validate, source)
    yield "verdict_flips", verdicts.figure(accuracy["ensembles"], source)
    yield "error_in_time", curves.errors_in_time(accuracy["ensembles"], source)
    yield "tunnelling", curves.tunnelling(accuracy, source)
    yield "crowds", curves.crowds(accuracy, source)
    if effects:
        yield "effects", effects_figure.figure(effects, source_of(effects))
    for one in validate["figures"] if validate else ():
        yield f"measured_{one['name']}", measured_figures.figure(one, validate["command"])


def draw(results, work):
    """work/README.md and work/figures from what was measured."""
    accuracy = read_accuracy(results / "accuracy.json")
    effects = read_effects(results / "effects.json")
    validate = read_validate(results / "validate.json")
    for name, sheet in sheets(accuracy, effects, validate):
        if sheet:
            sheet.save(work / "figures", name)
    picture = (work / "figures" / "compare.png").exists()
    (work / "README.md").write_text(document.markdown(accuracy, effects, validate, picture), encoding="utf-8")
    if validate:
        (work / "MEASURED.md").write_text(measurements.page(validate), encoding="utf-8")


def publish(folder, work, out):
    """Puts a finished folder in the place of the one before."""
    shutil.rmtree(out / folder, ignore_errors=True)
    (work / folder).rename(out / folder)


def make(options, rest):
    """The exit status. An old report stays until a new one is drawn; old results until there are new ones."""
    lab, status = measuring.Lab(options.lab), 0
    options.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".report-", dir=options.out) as folder:
        work = Path(folder)
        for name in ("results", "figures"):
            (work / name).mkdir()
        if options.draw_only:
            for picture in (options.out / "figures").glob("compare.*"):
                shutil.copy(picture, work / "figures")
        else:
            status = measure(lab, rest, work, options.recorded)
            if lab.interrupted and not (work / "results" / "accuracy.json").exists():
                print("poolhall: interrupted before anything was finished; the report is as it was", file=sys.stderr)
                return status
            publish("results", work, options.out)
        draw(options.out / "results", work)
        publish("figures", work, options.out)
        for page in ("README.md", "MEASURED.md"):
            if (work / page).exists():
                (work / page).rename(options.out / page)
    if lab.interrupted:
        print(f"poolhall: interrupted; {options.out / 'README.md'} has what was finished", file=sys.stderr)
    else:
        print(f"poolhall: the report is {options.out / 'README.md'}")
    return status


def main(command_line):
    options, rest = arguments_of(command_line)
    try:
        return make(options, rest)
    except measuring.Failed as failed:
        return failed.status
    except KeyboardInterrupt:
        print("poolhall: interrupted; what was measured can be drawn with --draw-only", file=sys.stderr)
        return measuring.INTERRUPTED
    except BadResults as fault:
        print(f"poolhall: report: {fault}", file=sys.stderr)
    except OSError as error:
        print(f"poolhall: report: {error.filename or options.out}: {error.strerror}", file=sys.stderr)
    return BAD_INPUT


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
