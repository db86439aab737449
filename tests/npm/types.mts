// What the types of the package admit, and what they do not.
import { load, loadWorker, Diagram, Mesh, NetmeshError, Status } from 'netmesh';

const netmesh = await load();
const diagram: Diagram = netmesh.persist([[0, 0], [1, 0], [0, 1]], { filter: 'complete', ratio: 2, bounds: true });
const bars: Float64Array = diagram.intervals(1);
for (const { degree, birth, death } of diagram) console.log(degree + birth + death);
const mesh: Mesh = netmesh.mesh(new Float64Array(6), { dim: 2, progress: now => now.done > now.total });
const cells: Int32Array = mesh.cells;
const sure: Uint8Array | undefined = diagram.bounds?.certain;
const other: Diagram = await (await loadWorker()).rips(null, { distances: [[0, 1], [1, 0]], threshold: 1 });
const distance: number = netmesh.bottleneck(diagram, bars, { log: true }) + netmesh.wasserstein(other, bars).lower;
const status: Status = new NetmeshError().status;
console.log(cells, sure, distance, status);
// @ts-expect-error
netmesh.persist([[0, 0]], { filter: 'nothing' });
// @ts-expect-error
netmesh.persist([[0, 0]], { colour: 1 });
// @ts-expect-error
netmesh.persist('points');
// @ts-expect-error
diagram.length = 3;
