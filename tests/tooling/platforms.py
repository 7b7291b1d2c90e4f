"""The compilers and processors that must give one hash, and how each builds and runs the golden program."""

import os
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from glob import glob
from pathlib import Path

from sources import ROOT, files

PROGRAM = [ROOT / "tests/shared/golden_hashes.cpp", ROOT / "client/lab/corpora/corpora.cpp"]
COMMON = ["-std=c++20", "-ffp-contract=off", "-fno-tree-slp-vectorize", "-I", str(ROOT), "-c"]
RUN_LIMIT_S = 300  # many times what the slowest, qemu, takes: only a hang reaches it

GCC = {"g++": "g++"}
CLANG = {"clang++": "clang"}
AARCH64 = {"aarch64-linux-gnu-g++": "g++-aarch64-linux-gnu", "qemu-aarch64": "qemu-user"}
WASM = {
    "/usr/lib/wasm32-wasi/libc.a": "wasi-libc",
    "/usr/lib/wasm32-wasi/libc++.a": "libc++-dev-wasm32",
    "/usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a": "libclang-rt-dev-wasm32",
    "wasm-ld": "lld",
    "node": "nodejs",
}


@dataclass(frozen=True)
class Platform:
    name: str
    needs: dict  # programs on the PATH, or patterns of files, each with its Debian package
    compiler: str  # the command; all of it compiles and links
    linker_flags: str = ""
    runner: tuple = ()  # the command that runs the program, if it does not run by itself

    @property
    def fma(self):
        return "-march=haswell" in self.compiler

    def missing_packages(self):
        return [package for need, package in self.needs.items() if not (shutil.which(need) or glob(need))]


# Without FMA every x86-64 build agrees even if contraction is left on; the haswell builds, and aarch64, which always has
# FMA, are the ones that prove it.
NATIVE = (
    Platform("gcc-O0", GCC, "g++ -O0"),
    Platform("gcc-O2", GCC, "g++ -O2"),
    Platform("gcc-O3", GCC, "g++ -O3"),
    Platform("gcc-O3-fma", GCC, "g++ -O3 -march=haswell"),
    Platform("clang-O2", CLANG, "clang++ -O2"),
    Platform("clang-O3", CLANG, "clang++ -O3"),
    Platform("clang-O3-fma", CLANG, "clang++ -O3 -march=haswell"),
)
FOREIGN = (
    # Linked statically, so that qemu needs no libraries of the other processor.
    Platform("aarch64-gcc-O2", AARCH64, "aarch64-linux-gnu-g++ -O2", "-static", ("qemu-aarch64",)),
    Platform("aarch64-clang-O3", CLANG | AARCH64, "clang++ --target=aarch64-linux-gnu -O3", "-static",
             ("qemu-aarch64",)),
    # The default stack, 64 KiB, would overflow into the data unseen; put first, an overflow of it traps.
    Platform("wasm32-clang-O2", CLANG | WASM, "clang++ --target=wasm32-wasi -O2 -fno-exceptions",
             "-Wl,--stack-first,-z,stack-size=1048576",
             ("node", "--no-warnings", str(Path(__file__).with_name("run_wasi.mjs")))),
)
PLATFORMS = NATIVE + FOREIGN


def has_fma():
    return "fma" in Path("/proc/cpuinfo").read_text().split()


def build(platform, folder):
    """Compiles the simulation and the golden program; returns the program and the simulation's objects."""
    compiler = platform.compiler.split()
    command = [*filter(None, [shutil.which("ccache")]), compiler[0], *COMMON, *compiler[1:]]
    folder.mkdir(parents=True, exist_ok=True)

    def compile_one(source):
        target = folder / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")
        subprocess.run([*command, str(source), "-o", str(target)], check=True)
        return str(target)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = [*pool.map(compile_one, [*PROGRAM, *files(ROOT, ["shared"], {".cpp"})])]
    simulation = objects[len(PROGRAM):]
    program = folder / "golden_hashes"
    subprocess.run([*compiler, *platform.linker_flags.split(), *objects, "-o", str(program)], check=True)
    return program, simulation


def output_of(platform, program):
    return subprocess.run([*platform.runner, str(program)], check=True, stdout=subprocess.PIPE, text=True,
                          timeout=RUN_LIMIT_S).stdout
