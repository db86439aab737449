// What the types of the package admit, and what they do not.
import { load, loadWorker, parseTable, Diagram, Mesh, NetmeshError, Status, Vineyard } from 'netmesh';

const netmesh = await load();
const diagram: Diagram = netmesh.persist([[0, 0], [1, 0], [0, 1]], { filter: 'complete', ratio: 2, bounds: true });
const bars: Float64Array = diagram.longest(1, 2);
const { points, dim } = parseTable('x,y\n1,2\n', { columns: ['x', 2], dropMissing: true });
netmesh.persist(points, { dim });
for (const { degree, birth, death } of diagram) console.log(degree + birth + death);
const mesh: Mesh = netmesh.mesh(new Float64Array(6), { dim: 2, progress: now => now.done > now.total });
const cells: Int32Array = mesh.cells;
const sure: Uint8Array | undefined = diagram.bounds?.certain;
const other: Diagram = await (await loadWorker()).rips(null, { distances: [[0, 1], [1, 0]], threshold: 1 });
const repeating: Diagram = netmesh.persist([[0, 0]], { lattice: [[1, 0], new Float64Array([0, 1])] });
const distance: number = netmesh.bottleneck(diagram, bars, { log: true }) + netmesh.wasserstein(other, bars).lower;
const vines: Vineyard = netmesh.vineyard([[0, 0], [1, 0]], { k: [1, 2], filter: 'kdistance' });
const path: Float64Array = vines.vine(0).intervals;
const filled: Diagram = netmesh.homology([[0], [1], [0, 1]], [0, 0, 1], { maxDegree: 1 });
netmesh.persist([[0, 0]], { filter: 'function', function: x => x[0], lipschitz: 1, cut: 1, fit: true, memory: 1e6 });
netmesh.persist([[0, 0]], { focus: 'auto', longerThan: 2, memory: 1e6 });
console.log(path, filled.why, mesh.vineyard({ k: [1, 2] }).count);
const status: Status = new NetmeshError().status;
console.log(cells, sure, distance, status);
netmesh.mesh([[0, 0]], { method: 'thesis', domain_factor: 2, audit: ['quality'] });
// @ts-expect-error
netmesh.persist([[0, 0]], { filter: 'nothing' });
// @ts-expect-error
netmesh.vineyard([[0, 0]], { k: 2 });
// @ts-expect-error
netmesh.persist([[0, 0]], { filter: 'function', function: () => 'x' });
// @ts-expect-error
netmesh.persist([[0, 0]], { colour: 1 });
// @ts-expect-error
netmesh.persist('points');
// @ts-expect-error
diagram.length = 3;
