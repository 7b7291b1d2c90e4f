"""The include lines keep the layers apart: shared <- protocol <- {server, client}, and tests may see everything."""

import re
import unittest
from pathlib import Path

from sources import CPP, LAYERS, ROOT, files, includes, planted

MAY_INCLUDE = {
    "shared": {"shared"},
    "protocol": {"shared", "protocol"},
    "server": {"shared", "protocol", "server"},
    "client": {"shared", "protocol", "client"},
    "tests": {*LAYERS, "tests"},
}
# The simulation has no clock, no I/O, no thread, and its own random generator.
NOT_IN_SHARED = {
    "chrono", "ctime", "cstdio", "iostream", "fstream", "filesystem", "thread", "mutex", "condition_variable", "atomic",
    "future", "random", "locale", "clocale",
}
# The request that becomes a WebSocket goes from one .cpp to another, as what Beast has parsed.
BEAST_HEADERS = {Path("server/session/session.hpp")}
# Windows, sound, text and sockets: what a browser has in its own way.
NOT_IN_PLAY = re.compile(r"SDL|boost/|pango|cairo|fontconfig|CLI/|filesystem$|fstream$|thread$|sys/|unistd")


def fault_of(root, path, bracket, header):
    """What is wrong with one include line, or None."""
    name = path.relative_to(root)
    layer = name.parts[0]
    if bracket == '"':
        target = header.split("/")[0]
        if not (root / header).is_file():
            return f'"{header}" is no file of the project, seen from its root'
        return None if target in MAY_INCLUDE[layer] else f'{layer} may not include "{header}"'
    if layer == "shared" and not re.fullmatch(r"[a-z_]+", header):
        return f"shared uses the standard library only, not <{header}>"
    if layer == "shared" and header in NOT_IN_SHARED:
        return f"shared has no clock, no I/O, no thread and no foreign random numbers: not <{header}>"
    if header.startswith("boost/beast") and path.suffix != ".cpp" and name not in BEAST_HEADERS:
        return f"<{header}> belongs in a .cpp: it takes seconds to compile"
    if name.is_relative_to("client/play") and NOT_IN_PLAY.match(header):
        return f"client/play is for the browser, too: not <{header}>"
    return None


def faults_in(root):
    """Every fault below root as 'file:line: what'."""
    faults = []
    for path in files(root, MAY_INCLUDE, CPP):
        for number, bracket, header in includes(path):
            if fault := fault_of(root, path, bracket, header):
                faults.append(f"{path.relative_to(root)}:{number}: {fault}")
    return faults


class IncludesTest(unittest.TestCase):
    def test_the_project_keeps_its_layers_apart(self):
        self.assertEqual([], faults_in(ROOT))

    def test_every_kind_of_violation_is_found(self):
        guilty = {
            "shared/a.hpp": '#include "protocol/a.hpp"\n',
            "shared/b.hpp": "#include <boost/asio.hpp>\n",
            "shared/c.cpp": "#include <chrono>\n",
            "protocol/a.hpp": '#include "server/a.hpp"\n',
            "protocol/b.cpp": ' #  include "client/a.hpp"\n',
            "server/a.hpp": '#include "client/a.hpp"\n',
            "server/b.hpp": "#include <boost/beast/http.hpp>\n",
            "client/a.hpp": '#include "server/a.hpp"\n',
            "client/b.cpp": '#include "nowhere.hpp"\n',
            "client/play/c.cpp": "#include <SDL2/SDL.h>\n",
        }
        innocent = {
            "shared/d.cpp": '#include "shared/a.hpp"\n#include <cmath>\n',
            "server/c.cpp": '#include "protocol/a.hpp"\n#include <boost/beast/http.hpp>\n',
            "client/desktop/d.cpp": "#include <SDL2/SDL.h>\n",
            "tests/x_test.cpp": '#include "server/a.hpp"\n#include "client/a.hpp"\n',
        }
        found = [fault.split(":")[0] for fault in planted(faults_in, {**guilty, **innocent})]
        self.assertEqual(sorted(guilty), sorted(found))


if __name__ == "__main__":
    unittest.main()
