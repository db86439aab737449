// node check.mjs netmesh.wasm [GOLDEN]: the module imports nothing and asks for no memory, its fingerprints are
// printed, or compared with a golden file.
import { readFileSync } from 'node:fs';

const fail = message => { console.log('FAULT ' + message); process.exit(1); };
const module = new WebAssembly.Module(readFileSync(process.argv[2]));
const imports = WebAssembly.Module.imports(module);
if (imports.length > 0) fail('imports ' + imports.map(i => i.module + '.' + i.name).join(' '));
const { exports } = new WebAssembly.Instance(module, {});
const block = exports.heap() >>> 0, block_bytes = 56 << 20;
const own_bytes = exports.memory.buffer.byteLength;
exports.memory.grow(Math.ceil((block + block_bytes - own_bytes) / 65536));
const bytes = exports.memory.buffer.byteLength;
const text = at => {
    const all = new Uint8Array(exports.memory.buffer);
    let end = at;
    while (all[end] !== 0) ++end;
    return new TextDecoder().decode(all.subarray(at, end));
};
const begin = performance.now();
const lines = text(exports.fingerprints(block, block_bytes));
const seconds = (performance.now() - begin) / 1000;
if (exports.memory.buffer.byteLength !== bytes) fail('the memory has grown by itself');
if (process.argv.length < 4) {
    process.stdout.write(lines);
} else if (lines !== readFileSync(process.argv[3], 'utf8')) {
    const golden = readFileSync(process.argv[3], 'utf8').split('\n');
    lines.split('\n').forEach((line, i) => { if (line !== golden[i]) console.log('- ' + golden[i] + '\n+ ' + line); });
    fail('fingerprints differ');
} else {
    const count = lines.trim().split('\n').length;
    console.log(`no imports, ${own_bytes} bytes of its own, a block of ${block_bytes}, ${count} lines equal, `
        + `${seconds.toFixed(2)} s`);
}
