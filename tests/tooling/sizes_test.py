"""Files and functions stay short enough to be read at once."""

import ast
import re
import unittest

from sources import CPP, LAYERS, ROOT, files, planted, without_comments

MOST_LINES_OF_A_FILE = 400
MOST_LINES_OF_A_FUNCTION = 60
NO_FUNCTION = re.compile(r'namespace\b|extern "C"|class\b|struct\b|union\b|enum\b')


def blocks(text):
    """(line, first words, number of lines) of what stands in braces in C++ as clang-format leaves it: what a `}` alone in its
    line ends began in the last line above that stands no deeper. So all functions are among them; a class ends with `};`
    and a namespace with a comment. A lambda that a variable keeps ends like a class."""
    raw, lines = text.splitlines(), without_comments(text).splitlines()
    depths = [len(line) - len(line.lstrip()) if line.strip() and line.lstrip()[0] != "#" else None for line in lines]
    for last, line in enumerate(lines):
        if depths[last] is None or not re.fullmatch(r" *\}(\(\))?;?", raw[last]):
            continue
        first = next((i for i in range(last - 1, -1, -1) if depths[i] is not None and depths[i] <= depths[last]), last)
        words = lines[first].strip()
        if line.strip() == "}" or re.search(r"= \[.*\{$", words):
            yield first + 1, words, last - first + 1


def functions_of(path):
    if path.suffix in CPP:
        yield from (block for block in blocks(path.read_text()) if not NO_FUNCTION.match(block[1]))
        return
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.name, node.end_lineno - node.lineno + 1


def faults_in(root):
    faults = []
    for path in files(root, [*LAYERS, "tests"], {*CPP, ".py"}):
        name = path.relative_to(root)
        count = len(path.read_text().splitlines())
        if count > MOST_LINES_OF_A_FILE:
            faults.append(f"{name}: {count} lines; {MOST_LINES_OF_A_FILE} are the most")
        for line, words, length in functions_of(path):
            if length > MOST_LINES_OF_A_FUNCTION:
                faults.append(f"{name}:{line}: {length} lines, of a function {MOST_LINES_OF_A_FUNCTION} are the most: {words}")
    return faults


def long_body(indent, lines):
    return f"{' ' * indent}do_something();\n" * lines


class SizesTest(unittest.TestCase):
    def test_files_and_functions_of_the_project_are_short(self):
        faults = faults_in(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_what_is_too_long_is_found_in_every_form(self):
        body = long_body(4, 60)
        guilty = {
            "shared/long.hpp": "\n" * (MOST_LINES_OF_A_FILE + 1),
            "shared/plain.cpp": f"namespace a {{\n\nint f(int a) {{\n{body}}}\n\n}}  // namespace a\n",
            "shared/wrapped.cpp": f"template <class T>\nstd::optional<T> f(int a,\n                  int b) {{  // why\n{body}}}\n",
            "shared/constructor.cpp": f"Thing::Thing(int a)\n    : a_{{a}},\n      b_(a) {{\n{body}}}\n",
            "shared/member.hpp": "class A {\n  public:\n    int f() const {\n" + long_body(8, 60) + "    }\n};\n",
            "shared/lambda.cpp": f"const auto f = [](int a) {{\n{body}}};\n",
            "shared/conditional.cpp": f"int f() {{\n#ifdef A\n{body}#endif\n}}\n",
            "tests/long.py": "def f():\n" + long_body(4, 60).replace(";", ""),
        }
        innocent = {
            "server/short.cpp": f"int f() {{\n{long_body(4, 58)}}}\n\nint g() {{\n    return 1;\n}}\n",
            "server/table.hpp": "constexpr int kTable[] = {\n" + "    1,\n" * 99 + "};\n",
            "server/many.hpp": "struct A {\n" + "    int f() {\n        return 1;\n    }\n\n" * 20 + "};\n",
            "server/text.cpp": 'const char* kText = R"(\n' + "}\n" * 99 + ')";\n',
        }
        found = [fault.split(":")[0] for fault in planted(faults_in, {**guilty, **innocent})]
        self.assertEqual(sorted(guilty), sorted(found))


if __name__ == "__main__":
    unittest.main()
