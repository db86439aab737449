/** Rows of numbers, or coordinates one row after the other with `dim`. */
export type Points = Float64Array | Float32Array | ArrayLike<number>[];
/** Kinds of errors. */
export type Status = 'invalid-argument' | 'out-of-memory' | 'cancelled' | 'not-finite' | 'out-of-range' | 'flat' | 'too-close'
    | 'no-result' | 'check-failed' | 'floating-point' | 'internal' | 'not-a-complex' | 'not-built';
export type MeshFilter = 'complete' | 'basic' | 'alpha' | 'knn' | 'kdistance' | 'tight' | 'function';
export type Filter = 'auto' | MeshFilter | 'scales' | 'rips' | 'cech' | 'barycentric-cech' | 'barycentric-rips';

export class NetmeshError extends Error {
    status: Status;
    /** The argument that it is about. */
    argument: string | null;
    /** The row of it, from 0 on. */
    row: number | null;
}

export interface Progress { stage: string; done: number; total: number; vertices: number; cells: number }

export interface RunOptions {
    /** Bytes of the block that the job happens in; by default as many as it takes. */
    memory?: number;
    /** Called about every tenth of a second; true stops the job (in a worker it only watches). */
    progress?: (progress: Progress) => unknown;
}
export interface PointOptions extends RunOptions {
    /** Coordinates of a point, for typed arrays. */
    dim?: number;
    /** Of every random choice; 1. */
    seed?: number;
}
export interface DiagramOptions {
    /** The highest degree of homology; by default D - 1, of complexes on points 1. */
    maxDegree?: number;
    /** Pairs of length zero are kept. */
    keepZeroPairs?: boolean;
    /** A cycle for each bar. */
    representatives?: boolean;
}
/** How a mesh is made; options that have the names of the engine's table. */
export interface MeshRules {
    /** The aspect ratio of cells, above 2. */
    tau?: number;
    method?: 'svr' | 'netmesh' | 'thesis' | 'refine' | 'certificate';
    finish?: boolean;
    wholeCells?: boolean;
    /** Radius of the ball that is meshed over that of the smallest one that holds the points. */
    domain_factor?: number;
    /** Of the method refine: spacing of its boundary net over the diameter of the points. */
    net_spacing?: number;
    /** No cell reaches farther than this times the distance to the second nearest input. */
    size_eps?: number;
    /** No cell reaches farther than this, and size_growth times its vertex's distance to the nearest input. */
    size_at_inputs?: number;
    size_growth?: number;
    /** Measures every intermediate mesh. */
    audit?: 'location' | 'quality' | ('location' | 'quality')[];
}
/** A function of x, Float64Array [D], of the filter "function". */
export interface FunctionOptions {
    /** With |f(x) - f(y)| <= lipschitz |x - y|, and at least `cut` outside of a ball around the points. */
    function?: (x: Float64Array) => number;
    lipschitz?: number;
    cut?: number;
    /** A c with f >= (distance to the second nearest point) / c. */
    distanceFactor?: number;
}
export interface MeshPersistOptions extends DiagramOptions, FunctionOptions {
    filter?: MeshFilter;
    /** Neighbours, of knn and kdistance; without it 1, the distance to the points, outliers and all. */
    k?: number;
    values?: 'certified' | 'thesis';
    /** Where each true birth and death surely is. */
    bounds?: boolean;
}
export interface PersistOptions extends PointOptions, MeshRules, Omit<MeshPersistOptions, 'filter'> {
    filter?: Filter;
    /** The certified ratio to refine to, 1.4143 or more. */
    ratio?: number;
    /** A better ratio at radii between two bounds: [ratio, from, to], with `fit` [from, to]; "auto": where bars are
     * undecided, until each is certified to exist or surely not `longerThan` times its birth, or `memory` is full. */
    focus?: [number, number, number] | [number, number] | 'auto';
    /** 1.5; goes with focus: "auto". */
    longerThan?: number;
    /** The best ratio (of a function: the least error) that `memory` holds. */
    fit?: boolean;
    /** Of a function: how far births and deaths may be off. */
    error?: number;
    eps?: number;
    theta?: number;
    /** Of the filter rips: a radius. */
    threshold?: number;
    /** Of the filter alpha: its triangulation is kept, which takes more memory. */
    keep_mesh?: boolean;
    /** Of the filter alpha: balls of different radii, one for each point, which grow together. Births and deaths are a,
     * with balls of radius sqrt(a^2 + r^2), below 0 of sqrt(r^2 - a^2). */
    radii?: Float64Array | Float32Array | number[];
    /** In place of radii their squares, of any sign. */
    weights?: Float64Array | Float32Array | number[];
    /** With these births and deaths are a^2 with the sign of a. */
    squares?: boolean;
    /** Of the filter alpha: points repeat by these vectors, 1 to D, as in a crystal or a box with periodic boundaries:
     * the diagram is that of the union of balls modulo them, to degree D; it has `copies` and `moved`. */
    lattice?: (Float64Array | Float32Array | number[])[];
}
export interface MeshOptions extends PointOptions, MeshRules {
    /** What it is for: itself, a diagram ("complete"), the filter "tight". */
    purpose?: 'mesh' | 'persist' | 'tight';
    /** Of purpose "tight" its accuracy, else `size_eps`. */
    eps?: number;
    ratio?: number;
    focus?: [number, number, number];
}
export interface DelaunayOptions extends PointOptions { purpose?: 'mesh' | 'persist' }
export interface RipsOptions extends RunOptions, DiagramOptions {
    dim?: number;
    /** [n, n] in place of points. */
    distances?: Float64Array | number[][];
    /** A radius: points farther apart than twice that are not joined. */
    threshold?: number;
}
export interface Bar { degree: number; birth: number; death: number }
export interface BarBounds {
    /** [m, 5]: least and largest birth, least and largest death, the death from which a bar is certain. */
    numbers: Float64Array;
    /** [m]: 1 for a bar that is certified to exist in the true diagram, however short. */
    certain: Uint8Array;
}

/** A persistence diagram. Births and deaths are radii; what never dies has Infinity. */
export class Diagram implements Iterable<Bar> {
    readonly filter: string;
    readonly certifiedRatio: number;
    /** Of the filter "function": births and deaths are off by at most this. */
    readonly certifiedError: number;
    /** Why this filter: what "auto" has found, or "it was asked for". */
    readonly why: string;
    /** 16 hexadecimal digits, the same on every platform. */
    readonly fingerprint: string;
    readonly peakBytes: number;
    readonly bounds: BarBounds | null;
    /** Of each bar the vertices of its simplices, degree + 1 each. */
    readonly representatives: Int32Array[] | null;
    /** With periods, of each vertex of a cycle how many of each vector of the cell take its row there: those of the
     * first of a simplex are 0. */
    readonly translations: Int32Array[] | null;
    /** Of points that repeat: how many were triangulated beside those given, and by how much numbers were moved at most
     * so that copies are exact. */
    readonly copies: number;
    readonly moved: number;
    readonly length: number;
    readonly maxDegree: number;
    /** [m, 2]: birth, death, birth, death ... of one degree. */
    intervals(degree: number): Float64Array;
    /** The longest bars of a degree (1), the longest first: [at most count, 2]; what never dies is the longest. */
    longest(degree?: number, count?: number): Float64Array;
    /** The first bar of a degree, and the first one behind it. */
    rows(degree: number): [number, number];
    [Symbol.iterator](): Iterator<Bar>;
}

export interface MeshVineyardOptions {
    /** [first, last]; [1, 2]. */
    k?: [number, number];
    filter?: 'knn' | 'kdistance';
    maxDegree?: number;
    values?: 'certified' | 'thesis';
}
export interface VineyardOptions extends Omit<MeshVineyardOptions, 'filter'>, PointOptions {
    filter?: 'knn' | 'kdistance' | 'barycentric-cech' | 'barycentric-rips';
    /** Of the mesh of knn and kdistance. */
    tau?: number;
    method?: 'svr' | 'refine' | 'certificate';
    /** In place of points: a complex, its values at each step, and whether these are of its vertices alone. */
    simplices?: ArrayLike<number>[];
    steps?: (Float64Array | number[])[];
    byVertex?: boolean;
}
export interface HomologyOptions extends RunOptions, DiagramOptions {}
/** Diagrams over a range of k, or of steps, and the vines through them: points of vines, sorted by vine and k. */
export class Vineyard {
    readonly filter: string;
    /** The first and the last k. */
    readonly k: [number, number];
    /** How many vines there are. */
    readonly count: number;
    readonly maxDegree: number;
    readonly vines: Int32Array;
    readonly degrees: Int32Array;
    readonly ks: Int32Array;
    /** [m, 2]: birth and death. */
    readonly intervals: Float64Array;
    /** The certified ratio of each k's diagram. */
    readonly ratios: Float64Array;
    readonly fingerprint: string;
    readonly peakBytes: number;
    readonly length: number;
    diagram(k: number): Diagram;
    vine(number: number): { ks: Int32Array; intervals: Float64Array };
}

export interface MeshData {
    readonly dim: number;
    readonly vertexCount: number;
    readonly inputCount: number;
    readonly cellCount: number;
    readonly isMesh: boolean;
    readonly aspectRatioMax: number;
    readonly fingerprint: string;
    /** [v, D], inputs first. */
    readonly vertices: Float64Array;
    /** [v]: 0 an input, 1 a Steiner point, 2 exempt from quality. */
    readonly markers: Uint8Array;
    /** [c, D + 1]. */
    readonly cells: Int32Array;
    /** [c, D + 1]: the cell opposite each vertex, -1 outside. */
    readonly neighbours: Int32Array;
    readonly domain: { centre: Float64Array; radius: number } | null;
}
/** A triangulation or mesh, and the memory that it lives in. */
export class Mesh implements MeshData {
    readonly dim: number;
    readonly vertexCount: number;
    readonly inputCount: number;
    readonly cellCount: number;
    readonly isMesh: boolean;
    readonly aspectRatioMax: number;
    readonly fingerprint: string;
    readonly vertices: Float64Array;
    readonly markers: Uint8Array;
    readonly cells: Int32Array;
    readonly neighbours: Int32Array;
    readonly domain: { centre: Float64Array; radius: number } | null;
    /** [v] after persist on a mesh, radii. */
    readonly values: Float64Array | null;
    persist(options?: MeshPersistOptions): Diagram;
    vineyard(options?: MeshVineyardOptions): Vineyard;
    check(): void;
}

export type Bars = Diagram | Float64Array;
export interface Transport { value: number; lower: number }

export class Netmesh {
    readonly version: string;
    readonly filters: string[];
    persist(points: Points, options?: PersistOptions): Diagram;
    mesh(points: Points, options?: MeshOptions): Mesh;
    delaunay(points: Points, options?: DelaunayOptions): Mesh;
    rips(points: Points | null, options?: RipsOptions): Diagram;
    /** Lists of vertices in any order, every face among them, and when each enters. */
    homology(simplices: ArrayLike<number>[], values: Float64Array | number[], options?: HomologyOptions): Diagram;
    vineyard(points: Points | null, options?: VineyardOptions): Vineyard;
    bottleneck(a: Bars, b: Bars, options?: { degree?: number; log?: boolean }): number;
    wasserstein(a: Bars, b: Bars, options?: { degree?: number; order?: number; error?: number }): Transport;
}
/** The same calls in a worker, as promises; functions do not cross to it. */
export interface NetmeshWorker {
    persist(points: Points, options?: PersistOptions): Promise<Diagram>;
    mesh(points: Points, options?: MeshOptions): Promise<MeshData>;
    delaunay(points: Points, options?: DelaunayOptions): Promise<MeshData>;
    rips(points: Points | null, options?: RipsOptions): Promise<Diagram>;
    homology(simplices: ArrayLike<number>[], values: Float64Array | number[], options?: HomologyOptions): Promise<Diagram>;
    vineyard(points: Points | null, options?: VineyardOptions): Promise<Vineyard>;
    bottleneck(a: Bars, b: Bars, options?: { degree?: number; log?: boolean }): Promise<number>;
    wasserstein(a: Bars, b: Bars, options?: { degree?: number; order?: number; error?: number }): Promise<Transport>;
    /** Stops what is on its way, which is rejected as "cancelled". */
    terminate(): void;
}

/** A table of numbers in text, read as the program `netmesh` reads it: with a header or without, in the dialects of
 * spreadsheets. */
export interface Table {
    /** [count, dim], of the columns that are taken. */
    points: Float64Array;
    dim: number;
    count: number;
    names: string[];
    /** Of each row the line of the text, from 1. */
    lines: number[];
    /** What was left out or understood. */
    notes: string[];
}
export interface TableOptions {
    /** Names of the header, numbers from 1, ranges "2-4"; all. */
    columns?: (string | number)[];
    /** What stands between columns, " " for blanks; told by the text. */
    delimiter?: string;
    /** Lines left out at the top. */
    skip?: number;
    /** Rows that lack a value are left out; else they are an error. */
    dropMissing?: boolean;
}
/** Throws an Error that names the line and says what to do. */
export function parseTable(text: string, options?: TableOptions): Table;

export type Source = string | URL | Response | Promise<Response> | BufferSource | WebAssembly.Module;
/** Loads the library into this thread; `source` where netmesh.wasm is not beside the module. */
export function load(source?: Source): Promise<Netmesh>;
/** Loads the library into a worker. */
export function loadWorker(source?: Source): Promise<NetmeshWorker>;
