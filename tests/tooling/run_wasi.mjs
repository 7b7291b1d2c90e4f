// Runs a WebAssembly program that needs no more than WASI preview 1: node run_wasi.mjs PROGRAM
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";

// Node 18 and 20 differ in the defaults of both options.
const wasi = new WASI({ version: "preview1", returnOnExit: true });
const { instance } = await WebAssembly.instantiate(await readFile(process.argv[2]), {
    wasi_snapshot_preview1: wasi.wasiImport,
});
process.exitCode = wasi.start(instance);
