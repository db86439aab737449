// The picture of points, complex, balls and a cycle at one radius; in more than two dimensions the first three turned
// by the mouse or the arrow keys. Of points in a box with periods: the box, and copies around it as far as the picture
// goes.
// Copies of the box in the picture; where more have room, as of a narrow one, it ends one period beside the box.
const boxes_most = 100;
const degree_colours = ['#1f2d4a', '#d5590e', '#1aa77d', '#c21dff', '#592710', '#9180be'];

// How many of a list that ascends have entered.
function entered(list, radius) {
    let low = 0, high = list.length;
    while (low < high) {
        const middle = (low + high) >> 1;
        if (list[middle].value <= radius) low = middle + 1; else high = middle;
    }
    return low;
}

class View {
    constructor(canvas) {
        this.canvas = canvas;
        this.turn = 0.6;
        this.tilt = 0.45;
        this.shown = null;
        let held = null;
        canvas.addEventListener('pointerdown', event => {
            held = [event.clientX, event.clientY];
            try { canvas.setPointerCapture(event.pointerId); } catch { /* no such pointer any more */ }
        });
        for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => { held = null; });
        canvas.addEventListener('pointermove', event => {
            if (held === null) return;
            // A finger that goes up or down scrolls the page.
            const up = event.pointerType === 'touch' ? 0 : event.clientY - held[1];
            this.rotate((event.clientX - held[0]) * 0.01, up * 0.01);
            held = [event.clientX, event.clientY];
        });
        canvas.addEventListener('keydown', event => {
            const steps = { ArrowLeft: [-.15, 0], ArrowRight: [.15, 0], ArrowUp: [0, -.15], ArrowDown: [0, .15] };
            if (!(event.key in steps)) return;
            event.preventDefault();
            this.rotate(...steps[event.key]);
        });
    }
    rotate(turn, tilt) {
        if (this.shown === null || this.shown.dim === 2) return;
        this.turn += turn;
        this.tilt = Math.max(-1.57, Math.min(1.57, this.tilt + tilt));
        this.draw();
    }
    // { dim, complex, radius, mode, cycle, box }; box: of parse_box, or null. A cycle has degree and vertices, with a
    // box degree and places.
    show(shown) {
        this.shown = shown;
        this.canvas.classList.toggle('turns', shown.dim > 2);
        this.canvas.tabIndex = shown.dim > 2 ? 0 : -1;
        this.draw();
    }

    // [x, y, depth] in pixels for each vertex; the inputs fill the picture.
    flatten() {
        const { dim, complex: { places, inputs }, box } = this.shown;
        const size = this.canvas.width, count = places.length / dim;
        const ct = Math.cos(this.turn), st = Math.sin(this.turn), cu = Math.cos(this.tilt), su = Math.sin(this.tilt);
        const flat = new Float64Array(3 * count);
        const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
        for (let i = 0; i < inputs; ++i) {
            for (let k = 0; k < Math.min(dim, 3); ++k) {
                low[k] = Math.min(low[k], places[i * dim + k]);
                high[k] = Math.max(high[k], places[i * dim + k]);
            }
        }
        for (let k = 0; k < 2; ++k) {
            if (box === null || !Number.isFinite(box.low[k])) continue;
            low[k] = box.low[k];
            high[k] = box.high[k];
        }
        const middle = low.map((x, k) => (x + high[k]) / 2);
        const span = dim === 2 ? Math.max(high[0] - low[0], high[1] - low[1])
            : Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
        this.scale = size / ((box !== null ? 2.1 : dim === 2 ? 1.2 : 1.02) * (span || 1));
        this.middle = middle;
        for (let i = 0; i < count; ++i) {
            const x = places[i * dim] - middle[0], y = places[i * dim + 1] - middle[1];
            const z = dim > 2 ? places[i * dim + 2] - middle[2] : 0;
            const right = dim > 2 ? ct * x - st * y : x, away = st * x + ct * y;
            const up = dim > 2 ? cu * z + su * away : y;
            flat[3 * i] = size / 2 + right * this.scale;
            flat[3 * i + 1] = size / 2 - up * this.scale;
            flat[3 * i + 2] = dim > 2 ? su * z - cu * away : 0;
        }
        return flat;
    }

    draw() {
        const { dim, complex, radius, mode, cycle } = this.shown, { canvas } = this;
        const g = canvas.getContext('2d'), flat = this.flatten();
        g.clearRect(0, 0, canvas.width, canvas.height);
        g.lineJoin = 'round';
        this.drawn = { dim, radius };
        if (this.shown.box !== null) {
            this.draw_box(g, flat, radius * this.scale, mode);
            return;
        }
        if (mode === 'balls' || mode === 'both') this.draw_balls(g, flat, radius);
        if (mode === 'complex' || mode === 'both') this.draw_complex(g, flat, radius);
        this.draw_points(g, flat);
        if (cycle !== null) this.draw_cycle(g, flat, cycle);
    }
    // A place of the plane in pixels, along x to the right or y upwards.
    pixel(value, axis) {
        return this.canvas.width / 2 + (axis === 0 ? 1 : -1) * (value - this.middle[axis]) * this.scale;
    }
    // The box in the picture: its sides and periods in pixels, y downwards. Without a period it fills the picture.
    sides() {
        const { box: { low, high } } = this.shown, size = this.canvas.width;
        return [0, 1].map(k => {
            if (!Number.isFinite(low[k])) return { from: 0, to: size, period: 0 };
            const [from, to] = [this.pixel(low[k], k), this.pixel(high[k], k)].sort((a, b) => a - b);
            return { from, to, period: to - from };
        });
    }
    // Points, complex, and the union of the balls of all copies, in the box; all around it the same in pale.
    draw_box(g, flat, ball, mode) {
        const { inputs } = this.shown.complex, size = this.canvas.width, sides = this.sides();
        const reach = mode === 'balls' || mode === 'both' ? ball : 0;
        // The first and the last copy of the box, along each axis, with something that near to what is shown.
        const steps = (shown, near) => sides.map(({ from, to, period }, k) => period === 0 ? [0, 0]
            : [Math.ceil((shown[k][0] - near[k] - to) / period), Math.floor((shown[k][1] + near[k] - from) / period)]);
        let shown = [[0, size], [0, size]];
        const boxes = steps(shown, [0, 0]).reduce((product, [first, last]) => product * (last - first + 1), 1);
        if (boxes > boxes_most)
            shown = sides.map(({ from, to, period }) => [Math.max(0, from - period), Math.min(size, to + period)]);
        const each_copy = (near, put) => {
            const [across, down] = steps(shown, near);
            for (let i = across[0]; i <= across[1]; ++i) {
                for (let j = down[0]; j <= down[1]; ++j) {
                    for (let v = 0; v < inputs; ++v) {
                        const x = flat[3 * v] + i * sides[0].period, y = flat[3 * v + 1] + j * sides[1].period;
                        if (x >= shown[0][0] - near[0] && x <= shown[0][1] + near[0] && y >= shown[1][0] - near[1] &&
                            y <= shown[1][1] + near[1]) put(x, y);
                    }
                }
            }
        };
        const rectangle = ([left, right], [top, bottom]) => g.rect(left, top, right - left, bottom - top);
        g.save();
        g.beginPath();
        rectangle(...shown);
        g.clip();
        if (reach > 0) {  // one path, so that the union has one shade
            g.fillStyle = 'rgba(31,45,74,.26)';
            g.beginPath();
            // Of a point's copies the nearest in x and in y is the nearest of all, no farther than half a period in each.
            const near = sides.map(({ period }) => period === 0 ? reach : Math.min(reach, period / 2 + 1));
            each_copy(near, (x, y) => {
                g.moveTo(x + reach, y);
                g.arc(x, y, reach, 0, 7);
            });
            g.fill();
        }
        if (mode === 'complex' || mode === 'both') this.draw_complex_copies(g, sides, shown);
        const dot = this.point_size(4 * inputs);
        g.fillStyle = '#1f2d4a';
        each_copy([dot, dot], (x, y) => this.draw_point(g, x, y, dot));
        if (this.shown.cycle !== null) this.draw_cycle_copies(g, sides, shown);
        g.fillStyle = 'rgba(255,255,255,.62)';
        g.beginPath();
        rectangle([0, size], [0, size]);
        rectangle(...sides.map(({ from, to }) => [from, to]));
        g.fill('evenodd');
        g.restore();
        g.strokeStyle = '#22262b';
        g.lineWidth = 2;
        g.beginPath();
        sides.forEach(({ from, to, period }, k) => {
            if (period === 0) return;
            const [start, end] = [sides[1 - k].from, sides[1 - k].to];
            for (const side of [from, to]) {
                if (k === 0) { g.moveTo(side, start); g.lineTo(side, end); }
                else { g.moveTo(start, side); g.lineTo(end, side); }
            }
        });
        g.stroke();
        g.fillStyle = '#1f2d4a';
        for (let i = 0; i < inputs; ++i) this.draw_point(g, flat[3 * i], flat[3 * i + 1], dot);
    }
    // The path of a simplex, and of its copies as far as the picture goes.
    add_copies(g, places, sides, shown) {
        const corners = Array.from(places, (value, i) => this.pixel(value, i % 2));
        const [across, down] = sides.map(({ period }, k) => {
            const along = corners.filter((_, i) => i % 2 === k);
            return period === 0 ? [0, 0] : [Math.ceil((shown[k][0] - Math.max(...along)) / period),
                Math.floor((shown[k][1] - Math.min(...along)) / period)];
        });
        for (let i = across[0]; i <= across[1]; ++i) {
            for (let j = down[0]; j <= down[1]; ++j) {
                for (let c = 0; c < corners.length; c += 2) {
                    const x = corners[c] + i * sides[0].period, y = corners[c + 1] + j * sides[1].period;
                    if (c === 0) g.moveTo(x, y); else g.lineTo(x, y);
                }
            }
        }
    }
    draw_complex_copies(g, sides, shown) {
        const { complex: { edges, triangles }, radius } = this.shown;
        this.counts = { edges: entered(edges, radius), triangles: entered(triangles, radius) };
        g.fillStyle = 'rgba(213,89,14,.28)';
        for (const { places } of triangles.slice(0, this.counts.triangles)) {
            g.beginPath();
            this.add_copies(g, places, sides, shown);
            g.fill();
        }
        g.strokeStyle = 'rgba(70,84,110,.9)';
        g.lineWidth = 1.6;
        g.beginPath();
        for (const { places } of edges.slice(0, this.counts.edges)) this.add_copies(g, places, sides, shown);
        g.stroke();
    }
    draw_cycle_copies(g, sides, shown) {
        const { degree, places } = this.shown.cycle, each = 2 * (degree + 1);
        g.strokeStyle = g.fillStyle = degree_colours[degree % 6];
        g.lineWidth = 6;
        g.globalAlpha = degree === 1 ? 1 : .3;
        for (let at = 0; at < places.length; at += each) {
            g.beginPath();
            this.add_copies(g, places.subarray(at, at + each), sides, shown);
            if (degree === 1) g.stroke(); else g.fill();
        }
        g.globalAlpha = 1;
    }
    draw_balls(g, flat, radius) {
        const { dim, complex: { inputs } } = this.shown, size = radius * this.scale;
        if (!(size > 0)) return;
        if (dim === 2) {  // one path, so that the union has one shade
            g.fillStyle = 'rgba(31,45,74,.18)';
            g.beginPath();
            for (let i = 0; i < inputs; ++i) {
                g.moveTo(flat[3 * i] + size, flat[3 * i + 1]);
                g.arc(flat[3 * i], flat[3 * i + 1], size, 0, 7);
            }
            g.fill();
            return;
        }
        const order = Array.from({ length: inputs }, (_, i) => i).sort((i, j) => flat[3 * i + 2] - flat[3 * j + 2]);
        for (const i of order) {
            const x = flat[3 * i], y = flat[3 * i + 1];
            const shade = g.createRadialGradient(x - size / 3, y - size / 3, size / 10, x, y, size);
            shade.addColorStop(0, '#dfe6f0');
            shade.addColorStop(1, '#6f86a8');
            g.fillStyle = shade;
            g.beginPath();
            g.arc(x, y, size, 0, 7);
            g.fill();
        }
    }
    draw_complex(g, flat, radius) {
        const { dim, complex: { edges, triangles } } = this.shown;
        const corner = v => [flat[3 * v], flat[3 * v + 1]];
        const triangle_count = entered(triangles, radius), edge_count = entered(edges, radius);
        const most = 40000;
        const depth = s => s.vertices.reduce((sum, v) => sum + flat[3 * v + 2], 0);
        const shown = triangles.slice(0, Math.min(triangle_count, most));
        if (dim > 2) shown.sort((a, b) => depth(a) - depth(b));
        const opacity = dim === 2 ? .28 : Math.max(.03, Math.min(.14, 3.3 / Math.sqrt(shown.length)));
        g.fillStyle = `rgba(213,89,14,${opacity})`;
        for (const { vertices } of shown) {
            g.beginPath();
            g.moveTo(...corner(vertices[0]));
            g.lineTo(...corner(vertices[1]));
            g.lineTo(...corner(vertices[2]));
            g.fill();
        }
        g.strokeStyle = 'rgba(70,84,110,' + (dim === 2 ? .9 : Math.min(.7, Math.max(.12, 1500 / edge_count))) + ')';
        g.lineWidth = 1.6;
        g.beginPath();
        for (const { vertices } of edges.slice(0, Math.min(edge_count, most))) {
            g.moveTo(...corner(vertices[0]));
            g.lineTo(...corner(vertices[1]));
        }
        g.stroke();
        this.counts = { edges: edge_count, triangles: triangle_count };
    }
    draw_points(g, flat) {
        const { inputs } = this.shown.complex, size = this.point_size(inputs);
        g.fillStyle = '#1f2d4a';
        for (let i = 0; i < inputs; ++i) this.draw_point(g, flat[3 * i], flat[3 * i + 1], size);
    }
    // Of very many as dots: a million circles take seconds.
    point_size(count) { return count > 20000 ? 0 : count > 2000 ? 2 : count > 500 ? 3 : 4.5; }
    draw_point(g, x, y, size) {
        if (size === 0) { g.fillRect(x, y, 1, 1); return; }
        g.beginPath();
        g.arc(x, y, size, 0, 7);
        g.fill();
    }
    draw_cycle(g, flat, { degree, vertices }) {
        g.strokeStyle = g.fillStyle = degree_colours[degree % 6];
        g.lineWidth = 6;
        for (let i = 0; i < vertices.length; i += degree + 1) {
            const simplex = vertices.subarray(i, i + degree + 1);
            g.beginPath();
            g.moveTo(flat[3 * simplex[0]], flat[3 * simplex[0] + 1]);
            for (const v of simplex.subarray(1)) g.lineTo(flat[3 * v], flat[3 * v + 1]);
            if (degree === 1) { g.stroke(); continue; }
            g.globalAlpha = .3;
            g.fill();
            g.globalAlpha = 1;
        }
    }
}
