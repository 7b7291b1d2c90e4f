"""The program refuses what it cannot read or write in one line, and keeps what is finished when it is interrupted."""

import json
import os
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import report_files

# Stands for a poolhall-lab that is interrupted: it has one ensemble, says that it waits, and writes it at Ctrl-C.
WAITING_LAB = """\
#!/bin/sh
[ "$1" = accuracy ] || exit 2
while [ "$1" != --out ]; do shift; done
trap 'cp "{measured}" "$2/accuracy.json"; exit 130' INT
echo waiting
while :; do sleep 0.05; done
"""


class ProgramTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def refused(self, *arguments):
        """One line and status 2; the line."""
        result = report_files.run(*arguments)
        self.assertEqual((2, "", 1), (result.returncode, result.stdout, result.stderr.count("\n")), result.stderr)
        return result.stderr

    def program(self, name, text):
        path = self.folder / name
        path.write_text(text)
        path.chmod(0o755)
        return path

    def test_results_that_are_not_there_are_one_line(self):
        self.assertIn("accuracy.json: No such file", self.refused("--draw-only", "--out", self.folder))

    def test_broken_results_are_one_line_with_the_place(self):
        good = json.loads((report_files.HERE / "accuracy.json").read_text())
        no_cost = json.loads(json.dumps(good))
        del no_cost["ensembles"][1]["points"][2]["cost"]
        uneven = json.loads(json.dumps(good))
        uneven["ensembles"][1]["error_in_time"][0]["median"].pop()
        cases = {
            "{": "no JSON",
            "[" * 100000: "no JSON",
            "{}": "'schema' is a required property",
            json.dumps({**good, "seed": "one"}): "/seed: ",
            json.dumps({**good, "schema": "poolhall.accuracy/2"}): "/schema: ",
            json.dumps({**good, "seconds": float("nan")}): "NaN is no JSON number",
            json.dumps(no_cost): "/ensembles/1/points/2: 'cost' is a required property",
            json.dumps(uneven): "/ensembles/1/error_in_time/0: t, median, p90 are not equally long",
        }
        out = report_files.measured_folder(self.folder / "out")
        for text, said in cases.items():
            with self.subTest(said):
                (out / "results" / "accuracy.json").write_text(text)
                self.assertIn(said, self.refused("--draw-only", "--out", out))
                self.assertEqual(["results"], os.listdir(out))

    def test_broken_effects_are_one_line_with_the_place(self):
        out = report_files.measured_folder(self.folder / "out")
        (out / "results" / "effects.json").write_text('{"schema": "poolhall.effects/0"}')
        self.assertIn("effects.json: ", self.refused("--draw-only", "--out", out))

    def test_a_folder_that_cannot_be_written_is_one_line_before_anything_is_run(self):
        (self.folder / "file").write_text("")
        self.assertIn(f"{self.folder}/file", self.refused("--out", self.folder / "file" / "report", "--lab", "/nowhere"))

    def test_options_without_meaning_are_refused(self):
        result = report_files.run("--draw-only", "--seed", "3", "--out", self.folder)
        self.assertEqual(2, result.returncode)
        self.assertIn("--draw-only measures nothing, so --seed has no meaning", result.stderr)

    def test_what_the_lab_refuses_is_refused_with_its_status(self):
        lab = self.program("lab", "#!/bin/sh\necho no such flag >&2\nexit 2\n")
        self.assertEqual("no such flag\n", self.refused("--bad", "--out", self.folder / "out", "--lab", lab))

    def test_what_fails_after_the_long_run_does_not_lose_it(self):
        lab = self.program("lab", f"""#!/bin/sh
            [ "$1" = --help ] && echo "  effects   What each effect costs"
            [ "$1" = effects ] && exit 3
            [ "$1" = accuracy ] && cp {report_files.HERE}/accuracy.json "$5"
            exit 0
            """)
        result = report_files.run("--quick", "--seed=4", "--out", self.folder / "out", "--lab", lab)
        self.assertEqual(3, result.returncode)
        self.assertEqual("poolhall: 'effects' failed, so the report leaves it out\n"
                         "poolhall: this poolhall-lab has no 'compare', so the report leaves it out\n"
                         "poolhall: this poolhall-lab has no 'validate', so the report leaves it out\n", result.stderr)
        self.assertIn("what each effect costs and is worth is left out", (self.folder / "out" / "README.md").read_text())

    def test_ctrl_c_keeps_what_is_finished_and_says_so(self):
        measured = json.loads((report_files.HERE / "accuracy.json").read_text())
        measured.update(ensembles=measured["ensembles"][1:], complete=False)
        (self.folder / "measured.json").write_text(json.dumps(measured))
        lab = self.program("lab", WAITING_LAB.format(measured=self.folder / "measured.json"))
        command = [sys.executable, "-B", str(report_files.REPORT / "report.py"), "--out", str(self.folder / "out"), "--lab", str(lab)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
            self.assertEqual("waiting\n", child.stdout.readline())
            child.send_signal(signal.SIGINT)
            out, err = child.communicate(timeout=120)
        self.assertEqual((130, ""), (child.returncode, out), err)
        self.assertIn("has what was finished", err)
        page = (self.folder / "out" / "README.md").read_text()
        self.assertIn("**The run was interrupted**", page)
        self.assertIn("### Two balls", page)
        self.assertEqual(["README.md", "figures", "results"], sorted(os.listdir(self.folder / "out")))

    def test_ctrl_c_before_anything_is_finished_leaves_the_report_as_it_was(self):
        out = self.folder / "out"
        out.mkdir()
        (out / "README.md").write_text("the old one")
        lab = self.program("lab", "#!/bin/sh\ntrap 'exit 130' INT\necho waiting\nwhile :; do sleep 0.05; done\n")
        command = [sys.executable, "-B", str(report_files.REPORT / "report.py"), "--out", str(out), "--lab", str(lab)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
            self.assertEqual("waiting\n", child.stdout.readline())
            child.send_signal(signal.SIGINT)
            _, err = child.communicate(timeout=60)
        self.assertEqual((130, 1), (child.returncode, err.count("\n")), err)
        self.assertEqual((["README.md"], "the old one"), (os.listdir(out), (out / "README.md").read_text()))


if __name__ == "__main__":
    unittest.main()
