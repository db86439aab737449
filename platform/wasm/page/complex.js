// The edges and triangles of a result with the radius at which each enters, for the picture: of alpha complexes by the
// triangulation, of filters on a mesh by the values of vertices, of Rips complexes by lengths.
// Edges and triangles of more cells, or of more distances, take longer than their picture is worth.
const cells_most = 150000, rips_points_most = 3000;
function can_draw(result, { count }) {
    if (result.filter === 9 || result.filter === 10 || result.figures.cells === 0) return count <= rips_points_most;
    return result.figures.cells <= cells_most;
}
// What is drawn then: the points, in their order.
function points_alone({ points, count }) {
    return { places: points, edges: [], triangles: [], vertex_values: null, inputs: count };
}
function complex_of(result, points) {
    const { dim, cells, has_values, values, figures } = result;
    if (result.filter === 9 || result.filter === 10 || cells.length === 0) return rips_edges(points, dim);
    const simplices = faces_of(cells, dim);
    if (has_values) {
        for (const list of simplices)
            for (const simplex of list.values())
                simplex.value = simplex.vertices.reduce((most, v) => Math.max(most, values[v]), 0);
    } else {
        alpha_values(simplices, result.places, dim);
    }
    const sorted = list => [...list.values()].sort((a, b) => a.value - b.value);
    return { places: result.places, edges: sorted(simplices[1]), triangles: sorted(simplices[2]),
        vertex_values: has_values ? values : null, inputs: figures.inputs };
}

const key_of = vertices => vertices.join(' ');

// lists[k]: simplices of k + 1 vertices by key, each with those of one vertex more that it is a face of.
function faces_of(cells, dim) {
    const lists = Array.from({ length: dim + 1 }, () => new Map());
    for (let c = 0; c < cells.length; c += dim + 1) {
        const vertices = [...cells.subarray(c, c + dim + 1)].sort((a, b) => a - b);
        lists[dim].set(key_of(vertices), { vertices, value: NaN });
    }
    for (let k = dim; k > 1; --k) {
        for (const simplex of lists[k].values()) {
            simplex.faces = simplex.vertices.map((_, i) => {
                const vertices = simplex.vertices.filter((_, j) => j !== i), key = key_of(vertices);
                let face = lists[k - 1].get(key);
                if (face === undefined) lists[k - 1].set(key, face = { vertices, value: NaN });
                return face;
            });
        }
    }
    return lists;
}

// Centre and squared radius of the smallest sphere through some places.
function sphere_through(vertices, places, dim) {
    const at = (v, k) => places[v * dim + k], o = vertices[0], n = vertices.length - 1;
    const edges = vertices.slice(1).map(v => Array.from({ length: dim }, (_, k) => at(v, k) - at(o, k)));
    const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
    const rows = edges.map((e, i) => [...edges.map(f => 2 * dot(e, f)), dot(e, e)]);
    for (let i = 0; i < n; ++i) {
        let best = i;
        for (let j = i + 1; j < n; ++j) if (Math.abs(rows[j][i]) > Math.abs(rows[best][i])) best = j;
        [rows[i], rows[best]] = [rows[best], rows[i]];
        for (let j = 0; j < n; ++j) {
            if (j === i) continue;
            const factor = rows[j][i] / rows[i][i];
            for (let k = i; k <= n; ++k) rows[j][k] -= factor * rows[i][k];
        }
    }
    const offset = new Array(dim).fill(0);
    rows.forEach((row, i) => edges[i].forEach((x, k) => { offset[k] += row[n] / row[i] * x; }));
    return { centre: offset.map((x, k) => x + at(o, k)), square: dot(offset, offset) };
}

// From the cells down: a face enters with the first simplex whose other vertex is in its ball, else by its own radius.
function alpha_values(lists, places, dim) {
    for (let k = dim; k > 0; --k) {
        for (const simplex of lists[k].values()) {
            if (Number.isNaN(simplex.value)) simplex.value = Math.sqrt(sphere_through(simplex.vertices, places, dim).square);
            if (k === 1) continue;
            for (const face of simplex.faces) {
                if (!Number.isNaN(face.value)) {
                    face.value = Math.min(face.value, simplex.value);
                    continue;
                }
                const other = simplex.vertices.find(v => !face.vertices.includes(v));
                const { centre, square } = sphere_through(face.vertices, places, dim);
                const distance = centre.reduce((sum, x, i) => sum + (x - places[other * dim + i]) ** 2, 0);
                if (distance < square) face.value = simplex.value;
            }
        }
    }
}

const rips_edges_most = 60000;

function rips_edges(points, dim) {
    const seen = new Set(), places = [];
    for (let i = 0; i < points.length; i += dim) {
        const row = points.subarray(i, i + dim), key = row.join(' ');
        if (!seen.has(key)) { seen.add(key); places.push(...row); }
    }
    const count = places.length / dim, edges = [];
    for (let i = 0; i < count; ++i) {
        for (let j = 0; j < i; ++j) {
            let square = 0;
            for (let k = 0; k < dim; ++k) square += (places[i * dim + k] - places[j * dim + k]) ** 2;
            edges.push({ vertices: [j, i], value: Math.sqrt(square) / 2 });
        }
    }
    edges.sort((a, b) => a.value - b.value);
    return { places: Float64Array.from(places), edges: edges.slice(0, rips_edges_most), triangles: [],
        vertex_values: null, inputs: count };
}
