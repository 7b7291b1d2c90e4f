"""The documents agree with the project: links lead somewhere, and README's keys are the client's."""

import re
import unittest

from sources import ROOT

LINK = re.compile(r"\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)


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


class DocumentsTest(unittest.TestCase):
    def test_every_relative_link_leads_somewhere(self):
        self.assertEqual([], [fault for document in documents() for fault in broken_links(document)])


if __name__ == "__main__":
    unittest.main()
