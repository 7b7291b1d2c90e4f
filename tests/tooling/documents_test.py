"""The documents agree with the project and with each other: links lead somewhere, README's table of keys is the client's
help, and a measured figure stands on one page, to which the others link."""

import re
import unittest

from sources import ROOT

LINK = re.compile(r"\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
# A page that a program writes of its own measurements, and tests hold against them: it repeats nobody's.
REPORT = "client/lab/report/README.md"
# Measured figures by kind: how one is written, and the page that has them.
NUMBER = r"\b\d[\d,.]*"
FIGURES = (
    ("what the simulation costs in instructions", NUMBER + r" instructions\b|^\|.*\| *instructions\b", "shared/PHYSICS.md"),
    ("what a step costs a kernel and a loop by hand", r"^\|.*\| *by hand *\|", "tests/bench/README.md"),
    ("what the simulation costs in time", NUMBER + r" [nuµ]s (?:a|per) (?:tick|shot|step|event)\b|^\|[^|]*\btick\b[^|]*\| *"
     + NUMBER + r" [nuµ]s", "shared/PHYSICS.md"),
    ("what the server costs", NUMBER + r" % of a core|" + NUMBER + r" kB in (?:JSON|CBOR)", "README.md"),
    ("how exact the solvers are", NUMBER + r" (?:%|of 100) of (?:them|the verdicts|verdicts)\b|median rest error",
     REPORT),
)


def documents():
    return [path for path in sorted(ROOT.rglob("*.md")) if path.relative_to(ROOT).parts[0] not in ("build", "data")]


def anchors_of(text):
    """The anchors of a document's headings, formed as the usual Markdown renderers do."""
    headings = re.findall(r"^#+ +(.+?) *$", FENCE.sub("", text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(document):
    for link in LINK.findall(FENCE.sub("", document.read_text())):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, anchor = link.partition("#")
        target = (document.parent / name).resolve() if name else document
        if not target.exists():
            yield f"{document.relative_to(ROOT)}: {link} does not exist"
        elif anchor and target.suffix == ".md" and anchor not in anchors_of(target.read_text()):
            yield f"{document.relative_to(ROOT)}: {link} has no such heading"


def keys_of_the_client():
    """The pairs {"key", "what it does"} of the help, in order; adjacent literals are joined as the compiler does."""
    text = re.sub(r'"\s*\n\s*"', "", (ROOT / "client/desktop/view/help_text.hpp").read_text())
    return re.findall(r'\{\s*"([^"]+)"\s*,\s*"([^"]+)"\s*\}', text)


def keys_of_the_readme():
    """The rows of the table between <!-- keys --> and <!-- /keys --> below its heading, without marks of style."""
    text = (ROOT / "README.md").read_text()
    table = text.partition("<!-- keys -->")[2].partition("<!-- /keys -->")[0]
    plain = re.sub(r"`|</?kbd>", "", table)
    return re.findall(r"^\| *(.+?) *\| *(.+?) *\|$", plain, re.MULTILINE)[2:]


def misplaced_figures(name, text):
    """The figures of a page that belong on another, as 'page:line: what'."""
    for kind, pattern, page in FIGURES:
        if name not in (page, REPORT):
            for match in re.finditer(pattern, text, re.MULTILINE):
                yield f"{name}:{text.count(chr(10), 0, match.start()) + 1}: '{match[0]}': {kind} stands in {page}; link to it"


class DocumentsTest(unittest.TestCase):
    def test_the_keys_in_the_readme_are_those_of_the_help(self):
        self.assertTrue(keys_of_the_client())
        self.assertEqual(keys_of_the_client(), keys_of_the_readme())

    def test_every_relative_link_leads_somewhere(self):
        self.assertEqual([], [fault for document in documents() for fault in broken_links(document)])

    def test_a_measured_figure_stands_on_one_page(self):
        faults = [fault for document in documents()
                  for fault in misplaced_figures(str(document.relative_to(ROOT)), document.read_text())]
        self.assertEqual([], faults)
        for kind, pattern, page in FIGURES:
            self.assertRegex((ROOT / page).read_text(), re.compile(pattern, re.MULTILINE), f"{kind} is not in {page}")

    def test_a_figure_on_a_second_page_is_found(self):
        rows = ("| one 30 Hz tick, two balls | 32 ns |", "a whole shot takes 106,300 instructions", "| kernel | a step | by hand |",
                "| one table | 24 % of a core |", "other balls fall in 37 of 100 of them")
        for row in rows:
            with self.subTest(row):
                self.assertTrue([*misplaced_figures("docker/README.md", f"# Title\n\n{row}\n")])
        self.assertEqual([], [*misplaced_figures("docker/README.md", "It takes 5 % fewer instructions, a tick is 1/30 s.\n")])


if __name__ == "__main__":
    unittest.main()
