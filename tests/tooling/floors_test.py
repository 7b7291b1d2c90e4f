"""Folders stand on floors: within each of shared, protocol, server and client they include each other in no circle, and no
folder includes one of a floor above its own. A folder is the directory of a file, and an include line is an arrow."""

import unittest

from sources import CPP, LAYERS, ROOT, files, includes, planted

# From top to bottom. A folder that stands here before it has a file is none yet; one that has files has to stand here.
FLOORS = {
    "protocol": [{"archive"}, {"replay"}, {"intake"}, {"codec"}, {"wire"}, {"."}],
    "server": [{"."}, {"app"}, {"http"}, {"session"}, {"room"}, {"delivery"}, {"config", "store", "net"}, {"base"}],
    "client/desktop": [{"."}, {"app"}, {"screens"}, {"view"}, {"render", "audio", "net"}],
}
# Which folders of the client each may include besides itself and what is in it. Programs never include each other.
CLIENT_MAY_INCLUDE = {
    "desktop": {"compare", "play", "text", "files"},
    "lab": {"analysis", "compare", "text", "files"},
    "replay": {"files"},
    "play": set(),
}


def arrows(root, layer):
    """{(folder, folder): "file:line"} of the include lines between folders of a layer, the first of each pair."""
    found = {}
    for path in files(root, [layer], CPP):
        name = path.relative_to(root)
        for number, bracket, header in includes(path):
            target = header.rpartition("/")[0]
            if bracket == '"' and header.split("/")[0] == layer and target != str(name.parent):
                found.setdefault((str(name.parent), target), f"{name}:{number}")
    return found


def reachable(graph, start):
    seen, waiting = set(), [start]
    while waiting:
        new = graph.get(waiting.pop(), set()) - seen
        seen |= new
        waiting += new
    return seen


def circles(found):
    """The sets of folders that reach each other, each sorted."""
    graph = {}
    for source, target in found:
        graph.setdefault(source, set()).add(target)
    reach = {folder: reachable(graph, folder) for folder in graph}
    return sorted({tuple(sorted({other for other in reach[folder] if folder in reach.get(other, ())}))
                   for folder in graph if folder in reach[folder]})


def faults_of_circles(root):
    for layer in LAYERS:
        found = arrows(root, layer)
        for circle in circles(found):
            inside = [f"{place} -> {target}" for (source, target), place in found.items()
                      if source in circle and target in circle]
            yield f"{' '.join(circle)}: these folders include each other in a circle:\n    " + "\n    ".join(inside)


def floor_of(floors, base, folder):
    """The place from the top of the floor of a folder, or of the nearest folder around it that has one."""
    inner = folder[len(base):].strip("/") or "."
    names = [inner, *(inner.rsplit("/", cut)[0] for cut in range(1, inner.count("/") + 1))]
    return next((i for name in names for i, floor in enumerate(floors) if name in floor), None)


def faults_of_floors(root):
    for base, floors in FLOORS.items():
        def within(folder, base=base):
            return f"{folder}/".startswith(f"{base}/")
        for folder in sorted({str(path.parent.relative_to(root)) for path in files(root, [base], CPP)}):
            if floor_of(floors, base, folder) is None:
                yield f"{folder}: stands on no floor; FLOORS in tests/tooling/floors_test.py must say where"
        for (source, target), place in arrows(root, base.split("/")[0]).items():
            if not (within(source) and within(target)):
                continue
            above, below = floor_of(floors, base, source), floor_of(floors, base, target)
            if None not in (above, below) and below < above:
                yield f"{place}: {source} may not include {target}, a floor above it"


def faults_of_programs(root):
    for (source, target), place in arrows(root, "client").items():
        one, other = (folder.split("/")[1] if "/" in folder else "" for folder in (source, target))
        if one != other and one in CLIENT_MAY_INCLUDE and other not in CLIENT_MAY_INCLUDE[one]:
            yield f"{place}: client/{one} may not include {target}"


def faults_in(root):
    return [*faults_of_circles(root), *faults_of_floors(root), *faults_of_programs(root)]


class FloorsTest(unittest.TestCase):
    def test_the_project_keeps_its_floors(self):
        faults = faults_in(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_a_circle_of_folders_is_found_however_long(self):
        texts = {
            "shared/a/a.hpp": '#include "shared/b/b.hpp"\n',
            "shared/b/b.hpp": '#include "shared/c.hpp"\n',
            "shared/c.hpp": '#include "shared/a/other.hpp"\n',
            "shared/a/other.hpp": "",
            "shared/d/d.hpp": '#include "shared/d/e.hpp"\n#include "shared/a/a.hpp"\n',
            "shared/d/e.hpp": '#include "shared/d/d.hpp"\n',
        }
        (fault,) = planted(faults_in, texts)
        self.assertIn("shared shared/a shared/b: ", fault)
        self.assertIn("shared/c.hpp:1 -> shared/a", fault)

    def test_an_include_of_a_floor_above_is_found(self):
        guilty = {
            "server/base/a.hpp": '#include "server/net/b.hpp"\n',
            "server/room/a.hpp": '#include "server/session/b.hpp"\n',
            "server/app/a.hpp": '#include "server/main.hpp"\n',
            "protocol/messages.hpp": '#include "protocol/archive/b.hpp"\n',
            "client/desktop/view/a.hpp": '#include "client/desktop/screens/lobby/b.hpp"\n',
            "client/play/a.hpp": '#include "client/desktop/net/b.hpp"\n',
            "client/lab/a.hpp": '#include "client/replay/b.hpp"\n',
        }
        innocent = {
            "server/main.hpp": '#include "server/base/a.hpp"\n#include "shared/a.hpp"\n',
            "server/session/b.hpp": '#include "server/net/b.hpp"\n',
            "protocol/archive/b.hpp": '#include "protocol/replay/b.hpp"\n',
            "client/desktop/screens/lobby/b.hpp": '#include "client/desktop/render/b.hpp"\n',
            "client/desktop/app/b.hpp": '#include "client/play/a.hpp"\n',
        }
        found = [fault for fault in planted(faults_in, {**guilty, **innocent}) if "circle" not in fault]
        self.assertEqual(sorted(guilty), sorted(fault.split(":")[0] for fault in found))

    def test_a_folder_without_a_floor_is_found(self):
        (fault,) = planted(faults_in, {"server/cellar/a.hpp": "", "server/net/a.hpp": ""})
        self.assertIn("server/cellar: stands on no floor", fault)


if __name__ == "__main__":
    unittest.main()
