"""An enumeration's names stand in one place: the table `enum_names` beside its declaration (shared/enum_names.hpp)."""

import re
import unittest

from sources import CPP, LAYERS, ROOT, files, planted, without_comments

ENUM = re.compile(r"^( *)enum class (\w+)(?: *: *[\w:]+)?\s*\{(.*?)\}", re.MULTILINE | re.DOTALL)
TABLE = re.compile(r"\benum_names\(\s*(?:\w+::)*(\w+)[^)]*\)\s*\{.*?^ *\}$", re.MULTILINE | re.DOTALL)
# A value and right behind it a text: a case that returns it, a pair of a list.
PAIR = re.compile(r'\b(?:\w+::)*(\w+)::k(\w+)\s*(?::\s*return\s+|,\s*)(?:std::string(?:_view)?[({]\s*)?"([^"\s]*)"')
TEXTS = re.compile(r'\{\s*((?:"[^"]*"\s*,?\s*)+)\}')
END = re.compile(r"\b(\w+)::k\w+\)?\s*\+\s*1\b|\bk(?:Last|End|Count)<[\w:]+>\s*=")

# What never leaves the program and so has no name. Every other enumeration of shared and protocol has a table.
NAMELESS = {"Access", "DamageKind", "DatabaseState", "HexFloats", "Major", "MoveFault", "Numbers", "Presence",
            "RecordFault", "Scheme", "UnknownFields", "VerticalPart"}


def snake(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def line_of(text, at):
    return text.count("\n", 0, at) + 1


def declarations(root, sources):
    """{name: (place, path, what its values may be called, how many they are)} of the enumerations of shared and protocol
    that are not inside a class."""
    found = {}
    for path, text in sources.items():
        if path.relative_to(root).parts[0] not in ("shared", "protocol"):
            continue
        for indent, name, values in ((match[1], match[2], match[3]) for match in ENUM.finditer(text)):
            if not indent:
                place = f"{path.relative_to(root)}:{line_of(text, text.index(f'enum class {name}'))}"
                texts = {snake(value) for value in re.findall(r"\bk([A-Z]\w*)", values)}
                found[name] = (place, path, texts, len(texts))
    return found


def faults_of_tables(enums, tables):
    for name, (place, path, *_) in enums.items():
        if name in NAMELESS and name in tables:
            yield f"{place}: {name} has a table of names and is in NAMELESS (tests/tooling/enums_test.py), too"
        elif name not in NAMELESS and tables.get(name, []) != [path]:
            yield f"{place}: {name} needs one table enum_names(), beside it and nowhere else"


def faults_of_lists(name, text, enums):
    """Second places: names by switch or in pairs, lists of names, and what stands for the last value."""
    for match in PAIR.finditer(text):
        if match[1] in enums and (match[3] == snake(match[2]) or name.parts[0] in ("shared", "protocol")):
            yield f"{name}:{line_of(text, match.start())}: name() says what {match[1]}::k{match[2]} is called"
    for match in TEXTS.finditer(text):
        texts = re.findall(r'"([^"]*)"', match[1])
        for enum, (_, _, values, kinds) in enums.items():
            if len(texts) > 1 and len(texts) >= kinds - 1 and values >= set(texts):
                yield f"{name}:{line_of(text, match.start())}: lists the names of {enum}; kValues and name() have them"
                break
    for match in END.finditer(text):
        if not match[1] or match[1] in enums:
            yield f"{name}:{line_of(text, match.start())}: kCount says how many values there are"


def faults_in(root):
    sources = {path: without_comments(path.read_text()) for path in files(root, LAYERS, CPP)}
    enums, tables = declarations(root, sources), {}
    for path, text in sources.items():
        for match in TABLE.finditer(text):
            tables.setdefault(match[1], []).append(path)
            if match[1] in enums:
                enums[match[1]][2].update(re.findall(r'"([^"]*)"', match[0]))
    faults = [*faults_of_tables(enums, tables)]
    for path, text in sources.items():
        rest = TABLE.sub(lambda match: "\n" * match[0].count("\n"), text)
        faults += faults_of_lists(path.relative_to(root), rest, enums)
    return faults


GOOD = """enum class Motion : std::uint8_t {
    kAtRest,   ///< why
    kOffTable,
};

constexpr auto enum_names(Motion /*type*/) {
    return names_of<Motion>({{Motion::kAtRest, "at_rest"}, {Motion::kOffTable, "off_table"}});
}
"""


class EnumsTest(unittest.TestCase):
    def test_the_project_names_each_value_in_one_place(self):
        faults = faults_in(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_every_second_place_is_found(self):
        guilty = {
            "shared/forgotten.hpp": "enum class Phase { kOn, kOff };\n",
            "shared/apart.hpp": "enum class Apart { kOn, kOff };\n",
            "shared/case.cpp": 'switch (m) {\n    case Motion::kAtRest:\n        return "still";\n}\n',
            "protocol/pairs.cpp": 'constexpr Pair kPairs[] = {{a::Motion::kAtRest, "at_rest"}};\n',
            "server/case.cpp": 'switch (m) {\n    case Motion::kAtRest: return "at_rest";\n}\n',
            "client/list.cpp": 'const std::set<std::string> kAll{"off_table",\n    "at_rest"};\n',
            "protocol/last.hpp": "for (int i = 0; i < static_cast<int>(Motion::kOffTable) + 1; ++i) {}\n",
            "protocol/end.hpp": "template <>\ninline constexpr Motion kLast<Motion> = Motion::kOffTable;\n",
        }
        innocent = {
            "shared/good.hpp": GOOD,
            "shared/table_of_apart.hpp": 'constexpr auto enum_names(Apart) {\n    return names_of<Apart>({{Apart::kOn, "on"}});\n}\n',
            "shared/inside.hpp": "struct A {\n    enum class Kind { kOne, kTwo };\n};\n",
            "shared/nameless.hpp": "enum class Scheme { kOne, kTwo };\n",
            "client/sentence.cpp": 'switch (m) {\n    case Motion::kAtRest: return "The ball lies still.";\n}\n',
            "server/other.cpp": 'const char* kLevels[] = {"trace", "debug"};\n// {"at_rest", "off_table"}\n',
        }
        found = [fault.split(":")[0] for fault in planted(faults_in, {**guilty, **innocent})]
        self.assertEqual(sorted(guilty), sorted(found))


if __name__ == "__main__":
    unittest.main()
