const $ = id => document.getElementById(id);
const MiB = 1 << 20;
const module_bytes = Uint8Array.from(atob($('module').textContent), c => c.charCodeAt(0));
// Compiled in place: a second thread's compiler is nothing that a browser without a screen waits for.
const module = new WebAssembly.Module(module_bytes);
const worker_url = URL.createObjectURL(new Blob([$('worker').textContent], { type: 'text/javascript' }));
const view = new View($('view'));
let worker = null, last = null, chosen = null;
let box_from = 'extent';  // who wrote the box: 'extent', this page; 'sample'; 'user'

function say(words, bad = false) {
    $('status').className = bad ? 'bad' : '';
    $('status').textContent = words;
}
function advise(title, items) {
    $('advice').hidden = items.length === 0;
    if (items.length === 0) return;
    const list = document.createElement('ul');
    list.append(...items.map(item => {
        const li = document.createElement('li');
        li.append(item);
        return li;
    }));
    $('advice').replaceChildren(title, list);
}
const size_text = bytes => bytes >= 1024 * MiB ? `${(bytes / 1024 / MiB).toFixed(1)} GiB`
    : bytes < MiB ? `${Math.ceil(bytes / 1024)} KiB` : `${(bytes / MiB).toFixed(bytes < 10 * MiB ? 1 : 0)} MiB`;

const points_text = count => `${count.toLocaleString('en')} point${count === 1 ? '' : 's'}`;

// What the options ask for, of so many points; degree 6: all. Throws a sentence.
function asked_for() {
    const limit = Number($('memory').value) * MiB;
    const number = (id, otherwise) => $(id).value === '' ? otherwise : Number($(id).value);
    for (const id of ['k', 'ratio', 'degree']) {
        const field = $(id);
        if (!field.closest('label').hidden && (field.validity.badInput || field.validity.rangeUnderflow ||
            field.validity.rangeOverflow)) throw new Error(`${id}: ${field.validationMessage}`);
    }
    const has_bounds = $('bounds').checked && !$('bounds-label').hidden;
    const asked = { filter: Number($('filter').value), k: number('k', 1),
        ratio: $('ratio-label').hidden ? 0 : number('ratio', 0), degree: number('degree', 6),
        bounds: has_bounds ? 1 : 0, cycles: 1 };
    let note = '';
    if (asked.filter === 0 && asked.ratio > 0) {
        asked.filter = 1;
        note = 'auto: complete, as a ratio is asked for';
    }
    if (asked.filter === 9 || asked.filter === 10) asked.degree = Math.min(number('degree', 1), 30);
    return { asked, limit, note };
}
const uses = { k: [4, 5], ratio: [0, 1, 4, 5], bounds: [0, 1, 4, 5] };
const has_periods = () => $('period-x').checked || $('period-y').checked;
function show_options() {
    const chosen = Number($('filter').value), filter = chosen === 0 && has_periods() ? 3 : chosen;
    $('box-label').hidden = !has_periods();
    $('show-label').hidden = last !== null && last.box !== null && !last.has_complex;
    for (const [id, filters] of Object.entries(uses)) $(id + '-label').hidden = !filters.includes(filter);
}
const filter_name = id => [...$('filter').options].find(o => Number(o.value) === id).textContent.split(':')[0];

// The box of the options, null: no periods. Throws a sentence.
function box_of(cloud) {
    if (!has_periods()) return null;
    if (cloud.dim !== 2)
        throw new Error(`box: this page takes periods in the plane, and the points have ${cloud.dim} coordinates: choose two ` +
            'columns, switch the periods off, or take "netmesh persist --box"');
    const repeats = axes.map(axis => $('period-' + axis).checked), text = box_from === 'extent' ? '' : $('box').value;
    $('box').value = box_text(text, repeats, cloud);
    return parse_box($('box').value, box_from === 'extent');
}
function set_box(text, from) {
    const entries = box_entries(text);
    if (entries.length === axes.length) axes.forEach((axis, k) => { $('period-' + axis).checked = entries[k] !== '-'; });
    $('box').value = text;
    box_from = text.trim() === '' ? 'extent' : from;
    show_options();
}

function stop() {
    if (worker !== null) worker.terminate();
    worker = null;
    $('run').disabled = false;
    $('cancel').disabled = true;
    $('progress').hidden = true;
    $('status').setAttribute('aria-busy', false);
}

function compute() {
    stop();
    advise('', []);
    let cloud, wanted, box;
    try {
        $('read').textContent = '';  // what was read before is gone
        cloud = parse_points($('text').value, { columns: $('columns').value, drop_missing: $('missing').checked });
        $('read').textContent = `${points_text(cloud.count)} in ${cloud.dim} dimensions` +
            cloud.notes.map(note => `; ${note}`).join('');
        box = box_of(cloud);
        wanted = asked_for();
    } catch (error) {
        say(error.message, true);
        return;
    }
    worker = new Worker(worker_url);
    $('run').disabled = true;
    $('cancel').disabled = false;
    $('progress').hidden = false;
    $('progress').value = 0;
    $('status').setAttribute('aria-busy', true);  // what comes is said when it is over, not each step of it
    say('starting');
    worker.onmessage = ({ data }) => {
        if (data.progress !== undefined) { show_progress(data.progress); return; }
        stop();
        take_result(data.result, cloud, wanted, box);
    };
    worker.onerror = event => { stop(); say(`the computation broke off: ${event.message}`, true); };
    worker.postMessage({ module, points: cloud.points, dim: cloud.dim, lattice: box === null ? [] : box.lattice,
        asked: wanted.asked, limit: wanted.limit });
}

// The bar goes one way: through the stages of a run, and where a run needs more memory and is made again, through what
// is left of it.
function show_progress({ share, stage, vertices, bytes, again }) {
    $('progress').value = Math.max($('progress').value, share);
    const count = vertices > 0 ? `, ${vertices.toLocaleString('en')} vertices` : '';
    say(`${stage}${count}, in a block of ${size_text(bytes)}${again ? ', as a smaller one did not do' : ''}`);
}

function take_result(result, cloud, wanted, box = null) {
    if (result.fault !== undefined) {
        say(result.fault, true);
        if (result.kind === 'memory') advise_memory(result, cloud, wanted, box);
        return;
    }
    if (wanted.asked.filter === 0) {  // what the engine has chosen
        wanted.note = `auto: ${result.why}`;
        wanted.asked.filter = result.filter;
    }
    const is_drawn = box === null ? can_draw(result, cloud) : cloud.count <= box_points_most;
    const in_box = box === null ? null : points_in_box(cloud, box);
    const rows = box === null ? null : distinct_rows(in_box.places, cloud, result.figures.inputs);
    const quotient = box === null || !is_drawn ? null : box_complex(result, cloud, box, rows);
    last = { result, cloud, wanted, box, is_drawn, rows, has_complex: box === null ? is_drawn : quotient !== null,
        complex: box !== null ? { ...points_alone({ ...cloud, points: in_box.places }), ...quotient }
            : is_drawn ? complex_of(result, cloud.points) : points_alone(cloud),
        described: `filter ${filter_name(wanted.asked.filter)}, ${points_text(cloud.count)} in ${cloud.dim} dimensions` +
            (box === null ? '' : `, box ${box.text}`) };
    if (box !== null && in_box.outside > 0)
        $('read').textContent += `; ${in_box.outside.toLocaleString('en')} outside of the box, each drawn as its copy in it`;
    const merged = cloud.count - result.figures.inputs;
    if (merged > 0) $('read').textContent += `; ${merged.toLocaleString('en')} duplicate${merged === 1 ? '' : 's'} merged`;
    chosen = null;
    const seconds = (result.milliseconds / 1000).toFixed(2);
    say(`${last.described}: done in ${seconds} s${wanted.note === '' ? '' : '; ' + wanted.note}`);
    $('results').hidden = false;
    show_options();
    const certificate = result.ratio === 1 ? 'exact' : `certified ratio ${(Math.ceil(1e4 * result.ratio) / 1e4).toFixed(4)}: births and deaths are ` +
        'within that factor of the exact ones';
    const shown = { pairs: result.pairs, ratio: result.ratio, has_bounds: wanted.asked.bounds === 1 };
    const title = `Barcode: ${last.described}, ${certificate}`;
    last.barcode = barcode_svg(shown, title, { buttons: true, narrow: $('barcode').clientWidth < 480 });
    last.picture = barcode_svg(shown, title).svg;
    $('barcode').innerHTML = last.barcode.svg;
    $('barcode-note').textContent = `${certificate}${box === null ? '' : ', modulo the periods'}. Choose a bar, by a click or ` +
        'by arrow keys and Enter, to see its cycle.';
    $('link-note').textContent = '';
    show_figures(result, certificate);
    let from = 0, longest = 0;  // of as many bars as there are: no call takes them all as arguments
    for (const p of result.pairs) {
        if (p.degree === 0) continue;
        const length = p.death - p.birth;
        if (box === null) {
            from = Math.max(from, p.birth + .35 * Math.min(length, last.barcode.end));
        } else if (length < Infinity && length > longest) {  // a class of the torus says little of where to look
            longest = length;
            from = p.birth + .35 * length;
        }
    }
    $('radius').value = Math.round(1000 * Math.min(1, (from || last.barcode.end / 4) / last.barcode.end));
    show_radius();
}

// What can be done when the memory does not suffice, each a click where it can be.
function advise_memory({ bytes, planned }, cloud, { asked, limit }, box) {
    const action = (words, change) => {
        const button = document.createElement('button');
        button.textContent = words;
        button.addEventListener('click', () => { change(); show_options(); compute(); });
        return button;
    };
    const items = [];
    const larger = [...$('memory').options].map(o => Number(o.value)).find(m => m * MiB > limit);
    if (larger !== undefined)
        items.push(action(`try again with ${size_text(larger * MiB)}`, () => { $('memory').value = larger; }));
    if (box === null && ![0, 1, 9].includes(asked.filter) || (asked.filter === 9 && cloud.dim <= 3))
        items.push(action('try the certified filter', () => { $('filter').value = 1; }));
    if (cloud.dim > 3) items.push(action('degrees 0 and 1 only', () => { $('degree').value = 1; }));
    if (box === null && [0, 1].includes(asked.filter))
        items.push(action('a coarser certificate: ratio 3', () => { $('ratio').value = 3; }));
    const half = Math.ceil(cloud.count / 2);
    items.push(action(`every other point: ${half}`, () => {
        const { points, dim } = cloud, rows = [];
        for (let i = 0; i < cloud.count; i += 2) rows.push([...points.subarray(i * dim, (i + 1) * dim)].join(', '));
        $('text').value = rows.join('\n');
        $('sample').value = $('columns').value = '';
    }));
    items.push('or the program netmesh, which takes as much memory as the machine has');
    advise(`${size_text(bytes)} were not enough; about ${size_text(planned)} are planned for such points. What helps:`, items);
}

function show_figures({ figures, bytes }, certificate) {
    const rows = [['certificate', certificate], ['vertices', figures.vertices],
        [figures.vertices > 0 ? 'of them input points' : 'different points', figures.inputs],
        ['copies of points triangulated', figures.copies],
        ['farthest move of a coordinate', figures.moved && short_number(figures.moved)],
        ['cells', figures.cells], ['simplices', figures.simplices], ['memory of the engine',
            `${size_text(figures.peak_bytes)} of a block of ${size_text(bytes)}`], ['fingerprint', figures.fingerprint]];
    if (figures.aspect_ratio > 0) rows.splice(6, 0, ['worst aspect ratio', figures.aspect_ratio.toFixed(3)]);
    $('figures').replaceChildren(...rows.filter(([, value]) => value !== 0).map(([name, value]) => {
        const tr = document.createElement('tr'), head = document.createElement('th');
        head.scope = 'row';
        head.textContent = name;
        tr.append(head);
        tr.insertCell().textContent = value;
        return tr;
    }));
    $('figures').createCaption().textContent = 'Figures of this result';
}

// Whether a cycle of the bar can be drawn.
const has_cycle = pair => pair.cycle !== null && (last.box === null || last.rows !== null);

function show_radius() {
    if (last === null) return;
    const { result, cloud, complex, barcode, box } = last;
    const radius = Number($('radius').value) / 1000 * barcode.end;
    $('radius-value').textContent = short_number(radius);
    $('radius').setAttribute('aria-valuetext', short_number(radius));
    const x = barcode.left + radius / barcode.end * (barcode.width - barcode.left - barcode.right);
    const line = document.querySelector('#barcode .radius');
    line.setAttribute('d', line.getAttribute('d').replace(/^M[\d.]+/, 'M' + x.toFixed(2)));
    const cycle = chosen === null || !has_cycle(result.pairs[chosen]) ? null
        : { degree: result.pairs[chosen].degree, ...box === null ? { vertices: result.pairs[chosen].cycle }
            : { places: cycle_places(result.pairs[chosen], cloud, box, last.rows) } };
    view.show({ dim: cloud.dim, complex, radius, cycle, box,
        mode: !last.is_drawn ? 'points' : last.has_complex ? $('show').value : 'balls' });
    const degrees = [...new Set(result.pairs.map(p => p.degree))].sort();
    const alive = new Map(degrees.map(degree => [degree, 0]));
    for (const p of result.pairs)
        if (p.birth <= radius && radius < p.death) alive.set(p.degree, alive.get(p.degree) + 1);
    $('betti').textContent = 'holes at this radius: ' + degrees.map(degree => `H${sub(degree)} ${alive.get(degree)}`)
        .join(', ');
    const turned = cloud.dim > 2 ? `; drag or take arrow keys to turn it${cloud.dim > 3 ? ', of more than three coordinates the first three' : ''}`
        : '';
    $('view-note').textContent = box !== null ? box_note() : `${complex.inputs} points` + (!last.is_drawn
        ? `: too large to draw more of it (${result.figures.cells.toLocaleString('en')} cells); the barcode is complete`
        : $('show').value === 'balls' ? '' : `, ${view.counts.edges} edges, ${view.counts.triangles} triangles at this radius`) + turned;
    $('view').setAttribute('aria-label', `Picture at radius ${short_number(radius)}: ${$('view-note').textContent}`);
}

// More points, and their balls take longer than their picture is worth.
const box_points_most = 5000;
function box_note() {
    const { box, cloud, is_drawn, has_complex, rows } = last, { edges, triangles } = view.counts ?? {};
    return `${points_text(cloud.count)}; box ${box.text}; copies are pale` + (!is_drawn
        ? ': too many points to draw more; the barcode is complete'
        : !has_complex ? '; the union is of the balls of all copies. Edges and triangles are not drawn' +
            (rows === null ? ', as it is not told here which points are duplicates' : ': that takes two periods and degrees to 2')
        : $('show').value === 'balls' ? '; the union is of the balls of all copies'
        : `; ${edges} edges, ${triangles} triangles at this radius, modulo the periods`);
}

const bars_shown = () => [...document.querySelectorAll('#barcode .bar')];
function go_to(bar) {
    for (const other of bars_shown()) other.setAttribute('tabindex', other === bar ? 0 : -1);
    bar.focus();
}
function choose(bar) {
    const pair = Number(bar.dataset.pair);
    chosen = chosen === pair ? null : pair;
    for (const other of bars_shown()) {
        const is_chosen = chosen !== null && other === bar;
        other.classList.toggle('chosen', is_chosen);
        other.setAttribute('aria-pressed', is_chosen);
    }
    const p = last.result.pairs[pair];
    if (chosen !== null) $('radius').value = Math.ceil(1000 * Math.min(p.birth, last.barcode.end) / last.barcode.end);
    $('barcode-note').textContent = chosen === null ? '' : `H${sub(p.degree)}, from ${short_number(p.birth)} to ` +
        `${short_number(p.death)}` + (!has_cycle(p) ? ': no cycle is kept of it' : `: a cycle of ` +
        `${p.cycle.length / (p.degree + 1)} pieces is drawn`);
    show_radius();
}
$('barcode').addEventListener('click', event => {
    const bar = event.target.closest('.bar');
    if (bar === null) return;
    go_to(bar);
    choose(bar);
});
$('barcode').addEventListener('keydown', event => {
    const bar = event.target.closest('.bar');
    if (bar === null) return;
    const all = bars_shown(), at = all.indexOf(bar);
    const next = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: all.length - 1 }[event.key];
    if (next !== undefined) go_to(all[Math.max(0, Math.min(next, all.length - 1))]);
    else if (event.key === 'Enter' || event.key === ' ') choose(bar);
    else return;
    event.preventDefault();
});

function save(name, type, text) {
    const a = document.createElement('a');
    a.href = URL.createObjectURL(new Blob([text], { type }));
    a.download = name;
    a.click();
    setTimeout(() => URL.revokeObjectURL(a.href), 10000);
}
$('save-pers').addEventListener('click', () => save('netmesh.pers', 'text/plain', pers_text(last.result, last.described)));
$('save-svg').addEventListener('click', () => save('netmesh.svg', 'image/svg+xml', last.picture));

// A link has the options and either the sample's name or the points themselves, squeezed.
const option_ids = ['columns', 'filter', 'k', 'ratio', 'degree', 'memory', 'show', 'radius'];
const link_most = 60000;
async function piped(bytes, stream) {
    return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}
async function link() {
    const state = Object.fromEntries(option_ids.map(id => [id, $(id).value]));
    state.bounds = $('bounds').checked;
    state.missing = $('missing').checked;
    state.periods = axes.map(axis => $('period-' + axis).checked);
    if (has_periods()) [state.box, state.box_from] = [box_from === 'extent' ? '' : $('box').value, box_from];
    if ($('sample').value !== '') state.sample = $('sample').value; else state.text = $('text').value;
    const bytes = await piped(new TextEncoder().encode(JSON.stringify(state)), new CompressionStream('deflate-raw'));
    const packed = btoa(Array.from(bytes, b => String.fromCharCode(b)).join('')).replaceAll('+', '-').replaceAll('/', '_')
        .replaceAll('=', '');
    if (packed.length > link_most) {
        $('link-note').textContent = 'too many points for a link: save the diagram instead';
        return;
    }
    history.replaceState(null, '', '#' + packed);
    let copied = false;
    try { await navigator.clipboard.writeText(location.href); copied = true; } catch { /* not allowed */ }
    $('link-note').textContent = copied ? 'copied, and in the address' : 'it is in the address now';
}
async function follow(packed) {
    const bytes = Uint8Array.from(atob(packed.replaceAll('-', '+').replaceAll('_', '/')), c => c.charCodeAt(0));
    const state = JSON.parse(new TextDecoder().decode(await piped(bytes, new DecompressionStream('deflate-raw'))));
    for (const id of option_ids) if (typeof state[id] === 'string') $(id).value = state[id];
    $('bounds').checked = state.bounds === true;
    $('missing').checked = state.missing === true;
    axes.forEach((axis, k) => { $('period-' + axis).checked = state.periods?.[k] === true; });
    $('box').value = String(state.box ?? '');
    box_from = ['sample', 'user'].includes(state.box_from) ? state.box_from : 'extent';
    $('sample').value = state.sample in samples ? state.sample : '';
    $('text').value = $('sample').value !== '' ? sample_text(state.sample) : String(state.text ?? '');
    show_options();
    compute();
}
$('link').addEventListener('click', link);

async function take_file(file) {
    $('sample').value = '';
    if (box_from === 'sample') set_box('-,-', 'extent');
    const bytes = new Uint8Array(await file.arrayBuffer());
    $('read').textContent = $('columns').value = '';
    if (bytes.subarray(0, 4096).includes(0)) { say(`${file.name}: this page reads text, one point a line`, true); return; }
    $('text').value = new TextDecoder().decode(bytes);
    compute();
}
for (const name of Object.keys(samples)) $('sample').append(new Option(name, name));
$('sample').addEventListener('change', () => {
    if ($('sample').value === '') return;
    $('text').value = sample_text($('sample').value);
    $('columns').value = '';
    const box = sample_boxes[$('sample').value];
    if (box !== undefined || box_from === 'sample') set_box(box ?? '-,-', box !== undefined ? 'sample' : 'extent');
    compute();
});
$('text').addEventListener('input', () => { $('sample').value = ''; });
$('columns').addEventListener('change', compute);
$('missing').addEventListener('change', compute);
for (const axis of axes) {
    $('period-' + axis).addEventListener('change', () => {
        show_options();
        if ($('text').value.trim() !== '') compute();
    });
}
$('box').addEventListener('change', () => {
    set_box($('box').value, 'user');
    compute();
});
$('text').addEventListener('paste', () => setTimeout(compute, 0));
$('file').addEventListener('change', event => { if (event.target.files.length > 0) take_file(event.target.files[0]); });
document.addEventListener('dragover', event => { event.preventDefault(); document.body.classList.add('over'); });
document.addEventListener('dragleave', () => document.body.classList.remove('over'));
document.addEventListener('drop', event => {
    event.preventDefault();
    document.body.classList.remove('over');
    if (event.dataTransfer.files.length > 0) take_file(event.dataTransfer.files[0]);
});
$('run').addEventListener('click', compute);
$('cancel').addEventListener('click', () => { stop(); say('cancelled'); });
$('filter').addEventListener('change', show_options);
$('radius').addEventListener('input', show_radius);
$('show').addEventListener('change', show_radius);
show_options();
if (location.hash.length > 1) follow(location.hash.slice(1)).catch(() => say('this link cannot be read', true));
