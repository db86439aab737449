// The other side of loadWorker.
import { Diagram, Mesh, Netmesh, Vineyard } from './index.mjs';

const inNode = Boolean(globalThis.process?.versions?.node);
const port = inNode ? (await import('node:worker_threads')).parentPort : globalThis;
let netmesh = null;

// What crosses to another thread of a result.
function plain(result) {
    if (result instanceof Diagram || result instanceof Vineyard) return result.toObject();
    if (!(result instanceof Mesh)) return result;
    const { dim, vertexCount, inputCount, cellCount, isMesh, aspectRatioMax } = result;
    return { dim, vertexCount, inputCount, cellCount, isMesh, aspectRatioMax, fingerprint: result.fingerprint,
        vertices: result.vertices, markers: result.markers, cells: result.cells, neighbours: result.neighbours,
        domain: result.domain };
}

function take({ id, name, values, watched, module }) {
    try {
        netmesh ??= new Netmesh(module);
        if (watched) values.at(-1).progress = progress => { port.postMessage({ id, progress }); };
        const given = values.map(value => value?.intervals && value.starts ? Diagram.from(value) : value);
        port.postMessage({ id, result: plain(netmesh[name](...given)) });
    } catch ({ message, status, argument, row }) {
        port.postMessage({ id, error: { message, status, argument, row } });
    }
}

if (inNode) port.on('message', take);
else port.onmessage = event => take(event.data);
