"""The documents agree with the project: links lead somewhere, and README's table of keys is the client's help."""

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


class DocumentsTest(unittest.TestCase):
    def test_the_keys_in_the_readme_are_those_of_the_help(self):
        self.assertTrue(keys_of_the_client())
        self.assertEqual(keys_of_the_client(), keys_of_the_readme())

    def test_every_relative_link_leads_somewhere(self):
        self.assertEqual([], [fault for document in documents() for fault in broken_links(document)])


if __name__ == "__main__":
    unittest.main()
