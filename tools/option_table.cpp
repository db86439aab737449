#include "tools/option_table.hpp"

#include <algorithm>

#include "tools/engine_options.hpp"
#include "tools/filters.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/points.hpp"

namespace netmesh::tool {

const std::vector<CommandEntry>& command_entries() {
    static const std::vector<CommandEntry> table = {
        {Command::mesh, "mesh", "POINTS...", 1, "quality mesh",
         "Every vertex but the boundary's gets a Voronoi cell whose aspect ratio, clipped to the domain, is at most "
         "tau.\n",
         "sample circle -n 60 --noise .05 -o points.csv\n"
         "mesh points.csv -o mesh.vtu\n"
         "mesh points.csv --tau 3 --check --svg mesh.svg -o mesh.node\n"},
        {Command::delaunay, "delaunay", "POINTS...", 1, "Delaunay triangulation", "",
         "delaunay points.csv -o triangles.off\n"
         "delaunay points.csv -o triangles.node --analyse --json\n"},
        {Command::persist, "persist", "POINTS... | MESH.node --values-at FILE | FILE --distances", 1,
         "persistence diagram",
         "Prints lines `degree birth death`, radii, inf for the essential class, behind comments `# name value` that "
         "say how\n"
         "the diagram was made, by the names of these options, of what points, and what is certified of it.\n"
         "With --values-at FILE it is that of a function that is known at the vertices of MESH.node, a mesh that the\n"
         "command mesh has made; cells no larger than E / L (--cell-size) are for an error of E.\n",
         "persist points.csv -o diagram.pers --svg diagram.svg\n"
         "persist points.csv --filter alpha --top 3\n"
         "persist points.csv --fit --memory 2M --bounds -o bounded.pers\n"
         "persist distances.txt --distances --threshold 0.5\n"},
        {Command::homology, "homology", "FILE", 1, "persistent homology of a filtered complex",
         "One simplex a line: its vertices, whole numbers from 0, then the value at which it enters: `3 1 4 0.5` is a\n"
         "triangle. Any order; # starts a comment. Every face must be listed and enter no later. Prints `degree birth "
         "death`;\n"
         "the bars that never die are the Betti numbers.\n",
         "homology complex.txt\n"
         "homology complex.txt --representatives cycles.txt -o complex.pers\n"},
        {Command::distance, "distance", "A.pers B.pers", 2, "bottleneck or Wasserstein distance between two diagrams",
         "Prints a line `degree distance` for every degree of either diagram, inf where the numbers of essential "
         "classes\n"
         "differ. The bottleneck distance is exact; that of Wasserstein is what a matching costs, at most --error\n"
         "above what is proven to be the least; --json has both numbers. Ours are radii. What ripser prints are "
         "diameters,\n"
         "and halved beside a .pers; arrays of ripser.py and of GUDHI's Rips complexes are, too, and have to be halved "
         "first.\n",
         "distance a.pers b.pers\n"
         "distance a.pers b.pers --wasserstein 2 --error 0.01\n"},
        {Command::vineyard, "vineyard", "POINTS | COMPLEX --values FILE", 1,
         "diagrams of d_k for a range of k, or of a complex for any sequence of values, and their vines",
         "One mesh for all k. Prints lines `vine degree k birth death` behind comments with the certified ratio of "
         "each k; a "
         "vine\nfollows one class from k to k. Of barycentric filters it joins bars that the inclusion of k + 1 in k "
         "matches: where it\nis at (b, d) and then at (b', d'), the image has the bar (b', d). With --values FILE the "
         "complex is one as homology\nreads them, k numbers the lines of FILE, whose values take the place of its "
         "own, and all ratios are 1; between two\nlines all values move at once on straight lines.\n",
         "vineyard points.csv --k 1..5 -o points.vines --svg vines.svg\n"
         "vineyard complex.txt --values values.txt\n"},
        {Command::size, "size", nullptr, 0, "bytes of memory to plan for",
         "One integer: enough for N uniform points, an estimate for others. Without --filter it covers mesh and "
         "persist.\n",
         "size --dim 3 --points 10000\n"
         "size --dim 2 --points 500 --filter rips --max-degree 1\n"},
        {Command::check, "check", "MESH.node | DIAGRAM.pers | FILE.vines", 1,
         "recompute every certificate from the files alone",
         "MESH.node is read with its .ele and .neigh; --points says which inputs it must hold. A diagram or a vineyard "
         "is\n"
         "reproduced from --points or --mesh: the engine runs again, and all bars and bounds must come out. A diagram "
         "says\n"
         "itself how it was made, and options that contradict it are refused; without --points and --mesh nothing is "
         "checked\nand the exit code is 7; one that does not say carries no certificate "
         "unless options say it. Other code then gives a second opinion. With --points it makes exact diagrams again, "
         "in exact\n"
         "arithmetic: every bar, to the last bit; of too many points degree 0, or a sample of it. netmesh-verify or\n"
         "netmesh-verify-rips verifies the proof of an alpha, Rips or Cech diagram that stands beside it or that\n"
         "--proof names.\n"
         "With --mesh: filter values\n"
         "and ratios from the Voronoi cells, the pairs by a plain reduction. With --representatives cycles' births and "
         "deaths.\n"
         "What was not looked at is said.\n"
         "Alone, a file is only looked at for what every diagram must satisfy.\n",
         "check mesh.node --points points.csv\n"
         "check diagram.pers --points points.csv\n"},
        {Command::pieces, "pieces", "split POINTS DIR | leaf DIR NODE | join DIR NODE | collect DIR", 2,
         "the tasks of an alpha diagram in pieces, for schedulers",
         "`persist --pieces` does all of this on one machine. split writes the points in the order of a tree into the "
         "folder\n"
         "DIR, and a Makefile of all other tasks. leaf is for the nodes N to 2 N - 1 of N pieces; join, of N - 1 to 1, "
         "for\n"
         "a node NODE when those of 2 NODE and 2 NODE + 1 are done. Each reads files of DIR and writes DIR/piece-NODE, "
         "whole\n"
         "or not at all, and does nothing where that is there already. collect writes the diagram that persist "
         "writes.\n",
         "pieces split points.csv scratch --pieces 2\n"
         "pieces leaf scratch 2\n"
         "pieces leaf scratch 3\n"
         "pieces join scratch 1\n"
         "pieces collect scratch -o diagram.pers\n"},
        {Command::sample, "sample", "SHAPE", 1, "point sets by formula", nullptr,
         "sample torus -n 500 --noise 0.02 -o torus.csv\n"
         "sample clifford -n 100 --turns 1,5\n"},
    };
    return table;
}

const CommandEntry& entry_of(Command command) {
    const std::vector<CommandEntry>& table = command_entries();
    std::size_t i = 0;
    while (table[i].command != command) i++;
    return table[i];
}

namespace {

std::string apply_cell_size(Options& options, const std::string& text) {
    const std::size_t comma = text.find(',');
    const bool grows = comma != std::string::npos;
    netmesh_sizes& sizes = options.request.mesh.sizes;
    const bool good = parse_finite(text.substr(0, comma), &sizes.at_inputs) && sizes.at_inputs > 0 &&
                      (!grows || (parse_finite(text.substr(comma + 1), &sizes.growth) && sizes.growth >= 0));
    return good ? "" : "must be a finite number above 0, and may have another, 0 or more, behind a comma: 0.1,0.5";
}

std::string apply_pace_theta(Options& options, const std::string& text) {
    const bool good = parse_finite(text, &options.pace_theta) && options.pace_theta > 0 && options.pace_theta <= 1;
    return good ? "" : "must be a number above 0 and at most 1";
}

std::string apply_focus(Options& options, const std::string& text) {
    options.request.goal.focus_ratio = 0;
    options.focus_auto = options.command == Command::persist && text == "auto";
    if (options.focus_auto) return {};
    const std::string complaint = set_option(&options.request, "focus_ratio", text);
    return complaint.empty() || options.command != Command::persist ? complaint : complaint + ", or auto";
}

std::string apply_cages(Options& options, const std::string& text) {
    options.cages = text;
    return text == "compact" || text == "thesis" ? "" : "there are compact and thesis";
}

std::string apply_values(Options& options, const std::string& text) {
    const bool named = text == "certified" || text == "thesis";
    const bool may_be_file = options.command == Command::vineyard || options.command == Command::check;
    options.values_path.clear();
    if (named || !may_be_file) return set_option(&options.request, "values", text);
    options.values_path = text;
    return text.empty() ? "must be certified, thesis or a file name" : "";
}

std::string apply_range_of_k(Options& options, const std::string& text) {
    const std::size_t dots = text.find("..");
    const bool is_range = dots != std::string::npos;
    const bool good = set_option(&options.request, "k", text.substr(0, dots)).empty() &&
                      set_option(&options.request, "k_last", is_range ? text.substr(dots + 2) : text).empty();
    return good ? "" : "must be a range of numbers of neighbours from 1 on: 1..20";
}

std::string apply_memory(Options& options, const std::string& text) {
    const std::string complaint = "must be a size above 0: 65536, 64K, 512M, 2G";
    std::string digits = text;
    int shift = 0;
    if (!digits.empty()) {
        const std::string units = "KMGT";
        const char last = digits.back();
        const std::size_t unit = units.find(last >= 'a' && last <= 'z' ? static_cast<char>(last - 'a' + 'A') : last);
        if (unit != std::string::npos) {
            shift = 10 * (static_cast<int>(unit) + 1);
            digits.pop_back();
        }
    }
    std::uint64_t number;
    if (!parse_unsigned(digits, &number) || number == 0 || number > (SIZE_MAX >> shift)) return complaint;
    options.memory_bytes = static_cast<std::size_t>(number << shift);
    return {};
}

std::string apply_pieces(Options& options, const std::string& text) {
    std::uint64_t number = 0;
    options.pieces_auto = text == "auto";
    options.pieces = 0;
    if (options.pieces_auto) return {};
    const bool good =
        parse_unsigned(text, &number) && number > 0 && number <= (1u << 20) && (number & (number - 1)) == 0;
    if (good) options.pieces = static_cast<std::uint32_t>(number);
    return good ? "" : "must be auto or a power of 2: 1, 2, 4, 8, .. 1048576";
}
std::string apply_jobs(Options& options, const std::string& text) {
    std::uint64_t number = 0;
    const bool good = parse_unsigned(text, &number) && number > 0 && number <= 4096;
    if (good) options.jobs = static_cast<std::uint32_t>(number);
    return good ? "" : "must be a number of processes, 1 to 4096";
}

std::string apply_function(Options& options, const std::string& text) { return options.function.emplace().parse(text); }
std::string apply_lipschitz(Options& options, const std::string& text) {
    const bool good = parse_finite(text, &options.lipschitz.emplace()) && *options.lipschitz >= 0;
    return good ? "" : "must be a finite number, 0 or more";
}
std::string apply_cut(Options& options, const std::string& text) {
    return parse_finite(text, &options.cut.emplace()) ? "" : "must be a finite number";
}
std::string apply_order(Options& options, const std::string& text) {
    std::uint64_t order;
    if (!parse_unsigned(text, &order) || order < 1 || order > NETMESH_ORDER_MAX)
        return "must be a whole number, the order, from 1 to 16";
    options.order = static_cast<std::uint32_t>(order);
    return {};
}
std::string apply_relative_error(Options& options, const std::string& text) {
    return parse_finite(text, &options.relative_error) && options.relative_error >= 0x1p-30
               ? ""
               : "must be a finite number above 1e-9";
}
std::string apply_dim(Options& options, const std::string& text) {
    std::uint64_t dim;
    if (!parse_unsigned(text, &dim) || dim < dim_min || dim > dim_max) return "must be a dimension from 2 to 6";
    options.dim = static_cast<std::uint32_t>(dim);
    return {};
}

std::string apply_count(Options& options, const std::string& text) {
    if (parse_unsigned(text, &options.point_count) && options.point_count > 0 && options.point_count < 4294967296u) {
        return {};
    }
    return "must be a number of points, 1 or more";
}

std::string apply_noise(Options& options, const std::string& text) {
    if (parse_finite(text, &options.noise) && options.noise >= 0) return {};
    return "must be a finite number, 0 or more";
}

std::string apply_turns(Options& options, const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma != std::string::npos && parse_unsigned(text.substr(0, comma), &options.turns[0]) &&
        parse_unsigned(text.substr(comma + 1), &options.turns[1]) && options.turns[0] <= 1000000 &&
        options.turns[1] <= 1000000) {
        return {};
    }
    return "must be two whole numbers: 1,10";
}

std::string apply_least(Options& options, const std::string& text) {
    const bool good = parse_finite(text, &options.least) && options.least >= 0;
    return good ? "" : "must be a finite number, 0 or more";
}

std::string apply_top(Options& options, const std::string& text) {
    return parse_unsigned(text, &options.top) && options.top > 0 ? "" : "must be a number of bars, 1 or more";
}

std::string apply_columns(Options& options, const std::string& text) {
    return parse_columns(text, &options.table.columns);
}

template <bool are_radii> std::string apply_weights(Options& options, const std::string& text) {
    if (!options.table.weights.empty() && options.table.are_radii != are_radii)
        return "goes without " + std::string(are_radii ? "--weights" : "--radii") + ", which says the same otherwise";
    options.table.weights = text;
    options.table.are_radii = are_radii;
    return text.empty() ? "must be a column: a number from 1, or a name of the header" : "";
}

template <bool is_box> std::string apply_lattice(Options& options, const std::string& text) {
    Lattice& lattice = options.table.lattice;
    const char* const other = is_box ? "--cell" : "--box";
    if (lattice.kind != Lattice::none && lattice.option() == std::string(other))
        return "goes without " + std::string(other) + ", which says the same otherwise";
    return is_box ? parse_box(text, &lattice) : parse_cell(text, &lattice);
}

std::string apply_delimiter(Options& options, const std::string& text) {
    constexpr std::pair<const char*, char> names[] = {{"tab", '\t'},  {"\\t", '\t'},  {"blank", ' '},
                                                      {"space", ' '}, {"comma", ','}, {"semicolon", ';'}};
    for (const auto& [name, delimiter] : names)
        if (text == name) return options.table.delimiter = delimiter, "";
    const bool good = text.size() == 1 && text.find_first_of("0123456789+-.eE#\"\n\r") == std::string::npos;
    if (good) options.table.delimiter = text[0];
    return good ? "" : "must be one character that is part of no number, or tab or blank";
}

std::string apply_skip(Options& options, const std::string& text) {
    return parse_unsigned(text, &options.table.skip) ? "" : "must be a number of lines";
}

std::string apply_drop_missing(Options& options, const std::string&) {
    options.table.drop_missing = true;
    return {};
}

std::string apply_out(Options& options, const std::string& text) {
    options.out = text == "-" ? "" : text;
    return text.empty() ? "must be a file name" : "";
}

template <std::string Options::*path> std::string apply_path(Options& options, const std::string& text) {
    options.*path = text;
    return text.empty() ? "must be a file name" : "";
}

std::string apply_axis(Options& options, const std::string& text) {
    if (text == "log") options.axis = Axis::log;
    if (text == "linear") options.axis = Axis::linear;
    return options.axis == Axis::natural ? "is log or linear" : "";
}

template <bool Options::*flag> std::string apply_switch(Options& options, const std::string&) {
    options.*flag = true;
    return {};
}

constexpr unsigned mesh = bit(Command::mesh), delaunay = bit(Command::delaunay), persist = bit(Command::persist);
constexpr unsigned size = bit(Command::size), check = bit(Command::check), sample = bit(Command::sample);
constexpr unsigned homology = bit(Command::homology), distance = bit(Command::distance);
constexpr unsigned vineyard = bit(Command::vineyard), pieces = bit(Command::pieces);
constexpr unsigned engine = mesh | delaunay | persist;
constexpr unsigned points = engine | vineyard | check | pieces;  // commands that read points

constexpr const char* next_line = "\n                    ";  // of a help text

bool on_points(const netmesh_filter_info& info) { return info.is_on_points != 0; }

// The list says which filter is taken when none is named.
std::string with_default(std::string list, netmesh_filter_id filter) {
    const std::string name = filter_name(filter);
    return list.insert(list.find(name) + name.size(), " (default)");
}

std::string filter_help() {
    const auto others = [](const netmesh_filter_info& info) { return !on_points(info); };
    return list_filters(others, "or") + "; of few points" + next_line + list_filters(on_points, "or");
}

std::string auto_filter_help() {
    const std::string first =
        "auto (default): exact alpha where it is affordable, else complete; a line on stderr says ";
    return first + "which; or" + next_line + filter_help();
}

std::string vineyard_filter_help() { return with_default(list_filters(has_vineyard, "or"), NETMESH_FILTER_KNN); }

}  // namespace

const std::vector<OptionEntry>& option_entries() {
    static const std::vector<OptionEntry> table = {
        {"-o", mesh | delaunay, "OUT", apply_out,
         ".node (with .ele and .neigh) or .off; of D = 2, 3 also .vtu .msh .mesh, or triangles as .ply .obj; without\n"
         "                    it OFF on stdout; of several POINTS {} stands for the name of each: -o 'out/{}.vtu'"},
        {"-o", persist, "OUT", apply_out,
         "the diagram: .pers .csv .json or .npy; without it .pers on stdout; of several POINTS {} stands for the name\n"
         "                    of each: -o '{}.pers'"},
        {"-o", pieces, "OUT", apply_out,
         "of collect: the diagram: .pers .csv .json or .npy; without it .pers on stdout"},
        {"-o", homology, "OUT", apply_out, "the diagram: .pers .csv .json or .npy; without it .pers on stdout"},
        {"--least", persist | pieces | homology, "LENGTH", apply_least,
         "write bars at least so long alone (0); the file then says how many there were, and carries no certificate"},
        {"--min-persistence", persist | pieces | homology, "X", apply_least, "another name of --least"},
        {"--top", persist | pieces | homology, "N", apply_top,
         "write the N longest bars of each degree alone; likewise"},
        {"-o", vineyard, "OUT.vines", apply_out, "the vines; without it on stdout"},
        {"-o", sample, "OUT", apply_out, ".txt .xyz .csv or .npy; without it text on stdout"},
        {"--columns", points, "LIST", apply_columns,
         "the columns of a table or array that are coordinates: numbers from 1, ranges, names of the header: 2-4,z"},
        {"--delimiter", points, "C", apply_delimiter,
         "what stands between columns: , ; | tab or blank; commas in numbers are then decimal (told by the file:\n"
         "                    commas first, with blanks in cells and quotes as RFC 4180 has them)"},
        {"--skip", points, "N", apply_skip, "lines left out at the top of a table (none but a header)"},
        {"--drop-missing", points, nullptr, apply_drop_missing,
         "rows of a table that lack a value (empty, NA, nan, -) in a column that is taken are left out, and said"},
        {"--radii", delaunay | persist | check, "COLUMN", apply_weights<true>,
         "balls about the points, of filter alpha: the column of their radii, which grow together; of .pqr radius; of\n"
         "                    .xyz and .pdb vdw, van der Waals radii by element"},
        {"--weights", delaunay | persist | check, "COLUMN", apply_weights<false>,
         "the same by squares of radii, of any sign"},
        {"--squares", persist | check, nullptr, "squares",
         "with these: births and deaths are the squares that are added to those of all radii, not roots with a sign"},
        {"--box", persist, "LO:HI,...", apply_lattice<true>,
         "points repeat, for filter alpha: the box of one period, for each axis LO:HI, a length from 0 on, or a\n"
         "                    dash for no period: 0:10,5,-. The diagram is that of the box with opposite sides\n"
         "                    glued, to degree D; the report and the file's head say `copies`, points triangulated\n"
         "                    besides, and `moved`, by how much numbers were moved at most so that copies are exact"},
        {"--cell", persist, "VECTORS|file", apply_lattice<false>,
         "the same by D vectors: 4,0,0/1,4,0/0,0,5, a dash for one that is no period; in space by sides and angles in\n"
         "                    degrees, a along x, b in the plane of x and y: 4,4,5,90,90,120; file: by the cell that\n"
         "                    extended .xyz or .pdb says"},
        {"-n", sample, "N", apply_count, "number of points"},
        {"--dim", size | sample, "D", apply_dim, "dimension, 2 to 6"},
        {"--points", size, "N", apply_count, "number of points"},
        {"--points", check, "FILE", apply_path<&Options::points_path>,
         "the points that the mesh, diagram or vineyard was made of"},
        {"--mesh", check, "MESH.node", apply_path<&Options::mesh_path>,
         "the mesh that the diagram or vineyard was made of"},
        {"--mesh", persist, "MESH.node", apply_path<&Options::mesh_out>,
         "also write the mesh that is filtered, with the filter's values"},
        {"--proof", persist, "FILE", apply_path<&Options::proof>,
         "of filters alpha, rips and cech: also write what proves the diagram, for netmesh-verify or\n"
         "netmesh-verify-rips"},
        {"--proof", homology, "FILE", apply_path<&Options::proof>,
         "also write what proves the diagram, for netmesh-verify-rips"},
        {"--proof", check, "FILE", apply_path<&Options::proof_path>,
         "of filters alpha, rips and cech, with --points: the proof that is to be verified (DIAGRAM.proof, if it is\n"
         "there)"},
        {"--tau", mesh | persist | vineyard | size | check, "T", "tau",
         "bound on the aspect ratio of Voronoi cells, above 2 (2.5 for D = 2, 3; 3.08; 4 for D = 5, 6)"},
        {"--eps", mesh | size | check, "E", "size_eps",
         "also refine until no cell reaches farther than E times the distance to the second nearest input"},
        {"--cell-size", mesh | check, "A[,B]", apply_cell_size,
         "also refine until no cell reaches farther than A plus B times its vertex's distance to the nearest input"},
        {"--domain", mesh, "F", "domain_factor",
         "radius of the ball that is meshed over that of the smallest one that holds the points, 1 to 8 (1)"},
        {"--net", mesh | check, "S", "net_spacing",
         "spacing of the boundary net of refine over the diameter of the smallest ball around the points (1)"},
        {"--eps", persist, "E", "eps",
         "log distance that tight promises, above 0 and at most 1/2 (1/2; D > 3: --ratio); scales: 3 theta more"},
        {"--pace", mesh | delaunay, "FILE", apply_path<&Options::pace_path>,
         "the inputs in an order that begins far apart, each farthest from those before, and its theta: distance to\n"
         "                    the nearest of those over that to the second (3.8)"},
        {"--theta", mesh | delaunay, "T", apply_pace_theta,
         "with --pace: only inputs that are not T-medial, T above 0 and at most 1"},
        {"--weighted-cells", mesh, "FILE", apply_path<&Options::weighted_path>,
         "each cage's weight, in-radius, feature size and epsilon as an additively weighted cell (4.6)"},
        {"--theta", persist | check, "T", "theta", "how medial points of one scale are, above 0 and at most 1/9 (1/9)"},
        {"--ratio", persist | check, "C", "ratio",
         "refine by the certificate until this ratio is certified, from 1.4143 (sqrt(2 + tau)): complete filter; in\n"
         "                    place of --eps tight, and scales with both numbers 1 + 3 theta times as large"},
        {"--whole-cells", persist | check, nullptr, "whole_cells",
         "refine by the certificate for whole Voronoi cells, not for cells clipped to a ball around the points: more\n"
         "                    vertices for the same ratio"},
        {"--focus", persist, "C|auto", apply_focus,
         "certify this ratio, above 1, of what matters to radii --from to --to. auto: refine where bars are undecided "
         "until\n"
         "                    each is certified to exist or is short, or --memory is full; the file says C, A and B"},
        {"--focus", check, "C", apply_focus, "certify this ratio, above 1, of what matters to radii --from to --to"},
        {"--longer-than", persist, "L", "longer_than",
         "with --focus auto: bars that may die after L times their birth, L above 1, are to be decided (1.5)"},
        {"--from", persist | check, "A", "focus_from", "least radius of interest"},
        {"--to", persist | check, "B", "focus_to", "largest radius of interest"},
        {"--fit", persist, nullptr, "fit",
         "the least ratio that fits in --memory, of the radii --from to --to if given, for any filter on a mesh but "
         "tight; --ratio C is where it begins (4); of filter function the least error"},
        {"--method", persist | check, "M", "method",
         "of a quality mesh to filter, in place of refinement by the certificate: svr, netmesh with --finish, refine"},
        {"--method", mesh | size, "M", "method",
         "svr (default); netmesh: hierarchical, of linear size whatever the points' spread; refine: the thesis's 3.2"},
        {"--finish", mesh | persist | size | check, nullptr, "finish",
         "go on from a hierarchical mesh to one of quality tau without cages"},
        {"--cages", mesh | size, "KIND", apply_cages,
         "of --method netmesh: compact (default); thesis: those of its 4.5, grown and released, D = 2, 3, 4 (--tau 7)"},
        {"--audit", mesh | persist | size, "WHAT", "audit",
         "location: points stored in all D-balls, inserted in rounds of range nets (not for persist); quality: aspect\n"
         "                    ratios, degrees and invariants after each insertion; or all. Figures go to the report"},
        {"--filter", vineyard, "F", "filter", vineyard_filter_help()},
        {"--filter", persist | size, "F", "filter", auto_filter_help()},
        {"--filter", check, "F", "filter", with_default(filter_help(), NETMESH_FILTER_COMPLETE)},
        {"--distances", persist, nullptr, apply_switch<&Options::distances>,
         "POINTS is a file of distances, for --filter rips: a symmetric matrix, a lower triangle as ripser has it, or "
         ".npy or .npz of a matrix or of what scipy's pdist gives; inf: never joined"},
        {"--sparse", persist, nullptr, apply_switch<&Options::sparse>,
         "with --distances: lines `i j distance` of points from 0 on; pairs that are not listed are never joined"},
        {"--threshold", persist, "R", "threshold",
         "of filter rips: points are joined to radius R, which is half of their distance; ripser's are diameters, "
         "2 R"},
        {"--k", persist | size | check, "K", "k",
         "neighbours of knn and kdistance, the point itself counted (1); kdistance is their root mean square; points "
         "in\n"
         "                    every set of a barycentric filter, at least"},
        {"--values", persist, "V", apply_values, "certified (default) or thesis: the filter's own"},
        {"--values", vineyard, "V|FILE", apply_values,
         "certified (default) or thesis: the filter's own; or a file of vectors of values, one a line, each a value\n"
         "                    for every simplex of COMPLEX, or for every vertex, in the order of its lines"},
        {"--values", check, "V|FILE", apply_values,
         "certified or thesis: the filter's own; or the values that a vineyard of a complex was made of"},
        {"--complex", check, "COMPLEX", apply_path<&Options::complex_path>,
         "with --values FILE: the complex that the vineyard was made of"},
        {"--function", persist | check, "EXPR", apply_function,
         "of filter function: numbers, x y z w or x1 .. x6, + - * / ^N ( ) sqrt abs min max: 'sqrt(x*x + y*y) - 1'"},
        {"--values-at", persist | check, "FILE", apply_path<&Options::values_at>,
         "of filter function, in place of --function: its values at the vertices of the mesh, one a line;\n"
         "                    those outside of the domain count as --cut, whatever they are"},
        {"--lipschitz", persist | check, "L", apply_lipschitz,
         "the function changes by at most L a unit of length in the domain; neighbouring vertices are looked at"},
        {"--cut", persist | check, "C", apply_cut,
         "the function is at least C outside of the domain, the ball around the points; values are cut there, and "
         "sublevel\n"
         "                    sets from there on must be contractible"},
        {"--error", persist | check, "E", "error",
         "refine until each birth and death of the function's diagram is off by at most E"},
        {"--k", vineyard, "A..B", apply_range_of_k, "the numbers of neighbours, the point itself counted"},
        {"--max-degree", persist | pieces | vineyard | size | check, "P", "max_degree",
         "highest homology degree (D-1, of points that repeat D; 1 for " + list_filters(on_points, "and") + ")"},
        {"--max-degree", homology, "P", "max_degree", "highest homology degree (the dimension of the complex)"},
        {"--representatives", persist | homology, "FILE", apply_path<&Options::representatives>,
         ".vtu or .obj: a cycle for each bar to look at; .svg: of bars that stand apart by their length, or that\n"
         "                    --top or --least choose; .txt or .cycles: a line `bar DEGREE BIRTH DEATH N`,\n"
         "                    then N simplices, one a line: by vertices of the\n"
         "                    mesh, or of scales, rips and cech by the different points in their order"},
        {"--representatives", check, "FILE", apply_path<&Options::representatives>,
         "the diagram's cycles, as persist wrote them: with --mesh, or with --points for scales, rips and cech, each\n"
         "                    is one, is born with its bar and dies with it"},
        {"--pieces", persist | pieces, "N|auto", apply_pieces,
         "of filter alpha: in N pieces, a power of 2: the same diagram in the memory of a piece; auto: of the best "
         "size"},
        {"--jobs", persist, "J", apply_jobs,
         "with --pieces or several POINTS: processes at a time, each with --memory (of pieces as processors, else 1)"},
        {"--scratch", persist, "DIR", apply_path<&Options::scratch>,
         "with --pieces: the folder for their files, which stay there: the same command goes on with what it finds"},
        {"--memory", engine | pieces | vineyard | homology | check, "SIZE", apply_memory,
         "the block that the engine works in: 64K, 512M, 2G; reserved lazily until the job fits if not given. Points,\n"
         "                    results and the program are beside it: the summary says what the whole process took"},
        {"--seed", engine | vineyard | check | sample, "S", "seed", "of every random choice (1)"},
        {"--noise", sample, "X", apply_noise, "standard deviation of a normal offset of every coordinate (0)"},
        {"--turns", sample, "A,B", apply_turns, "of the Clifford winding about its two circles (1,10)"},
        {"--svg", mesh | delaunay, "FILE", apply_path<&Options::svg>,
         "picture of a mesh in 2 dimensions, of a cut through it in 3; - is stdout, for it alone"},
        {"--voronoi", mesh | delaunay, nullptr, apply_switch<&Options::voronoi>,
         "the picture shows Voronoi cells, coloured by how fine they are, in 2 dimensions"},
        {"--svg", persist | pieces | homology, "FILE", apply_path<&Options::svg>,
         "picture of barcode and diagram; - is stdout, for it alone"},
        {"--svg", vineyard, "FILE", apply_path<&Options::svg>,
         "picture of the vines, k against radius; - is stdout, for it alone"},
        {"--axis", persist | pieces | homology | vineyard, "A", apply_axis,
         "log or linear, of the picture (log for radii, linear for values that are none)"},
        {"--analyse", mesh | delaunay, nullptr, apply_switch<&Options::analyse>,
         "report degrees, ply and fatness of the result and, for a mesh, bounds on its size"},
        {"--wasserstein", distance, "P", apply_order,
         "Wasserstein distance of order P, 1 to 16: the P-th root of the least sum of P-th powers of moves"},
        {"--error", distance, "E", apply_relative_error, "relative error of the Wasserstein distance (0.001)"},
        {"--log", distance, nullptr, apply_switch<&Options::log>,
         "distance of natural logarithms; births at 0 are matched to births at 0 alone"},
        {"--check", engine | vineyard, nullptr, apply_switch<&Options::check>,
         "run the independent checkers on the result"},
        {"--check", homology, nullptr, apply_switch<&Options::check>,
         "check that each cycle is one, is born with its bar and dies with it"},
        {"--bounds", persist, nullptr, "bounds",
         "where each birth and death surely is and which bars are certified to exist, however short, behind the bars, "
         "and the\n"
         "                    certified ratio by scale, in front of them; both in JSON and in the picture"},
        {"--all", persist | pieces | homology | check, nullptr, "keep_zero_pairs", "keep bars of length zero"},
        {"--json", engine | pieces | vineyard | homology | distance | size | check, nullptr,
         apply_switch<&Options::json>,
         "report as JSON on stdout; data then goes to -o only, but bars without -o stand in the JSON"},
        {"--quiet", engine | pieces | vineyard | homology | distance | size | check | sample, nullptr,
         apply_switch<&Options::quiet>,
         "no progress, no summary; of notes on the data those alone that say what may be a slip"},
    };
    return table;
}

std::vector<std::string> words_of(const OptionEntry& option, Command command) {
    const std::string name = option.name;
    if (name == "--method") return {"svr", "netmesh", "refine"};
    if (name == "--cages") return {"compact", "thesis"};
    if (name == "--values") return engine_words("values");
    if (name == "--delimiter") return {"tab", "blank", "comma", "semicolon"};
    if (name == "--axis") return {"log", "linear"};
    if (name == "--focus" && command == Command::persist) return {"auto"};
    if (name == "--pieces") return {"auto"};
    if (name == "--cell") return {"file"};
    std::vector<std::string> words;
    if (name == "--audit") {
        words = engine_words("audit");
        words.emplace_back("all");
    }
    if (name != "--filter") return words;
    if (command == Command::persist || command == Command::size) words.push_back("auto");
    for (const netmesh_filter_info& filter : filters())
        if (command != Command::vineyard || has_vineyard(filter)) words.push_back(filter.name);
    return words;
}

bool names_file(const OptionEntry& option) {
    if (option.value == nullptr) return false;
    const std::string value = option.value;
    for (const char* const file : {"FILE", "OUT", "OUT.vines", "MESH.node", "COMPLEX", "V|FILE"})
        if (value == file) return true;
    return false;
}

std::vector<std::string> option_names(netmesh_field field) {
    // What options of the tool's own set, and others than they are called by.
    static constexpr struct {
        netmesh_field field;
        const char* option;
    } others[] = {{NETMESH_FIELD_SIZE_AT_INPUTS, "--cell-size"},
                  {NETMESH_FIELD_SIZE_GROWTH, "--cell-size"},
                  {NETMESH_FIELD_SIZES, "--eps"},
                  {NETMESH_FIELD_SIZES, "--cell-size"},
                  {NETMESH_FIELD_FOCUS_FROM, "--focus"},
                  {NETMESH_FIELD_FOCUS_RATIO, "--focus"},
                  {NETMESH_FIELD_FOCUS_RATIO, "--from"},
                  {NETMESH_FIELD_FOCUS_RATIO, "--to"},
                  {NETMESH_FIELD_FOCUS_FROM, "--to"},
                  {NETMESH_FIELD_FOCUS_TO, "--from"},
                  {NETMESH_FIELD_LONGER_THAN, "--focus"},
                  {NETMESH_FIELD_FOCUS_TO, "--focus"},
                  {NETMESH_FIELD_FIT, "--focus"},
                  {NETMESH_FIELD_VALUES, "--values"},
                  {NETMESH_FIELD_FUNCTION, "--function"},
                  {NETMESH_FIELD_FUNCTION, "--values-at"},
                  {NETMESH_FIELD_LIPSCHITZ, "--lipschitz"},
                  {NETMESH_FIELD_CUT, "--cut"},
                  {NETMESH_FIELD_K_LAST, "--k"},
                  {NETMESH_FIELD_VINES, "--filter"},
                  {NETMESH_FIELD_CYCLES, "--representatives"},
                  {NETMESH_FIELD_KEEP_MESH, "--mesh"},
                  {NETMESH_FIELD_WEIGHTING, "--radii"},
                  {NETMESH_FIELD_WEIGHTING, "--weights"},
                  {NETMESH_FIELD_PERIODS, "--box"},
                  {NETMESH_FIELD_PERIODS, "--cell"},
                  {NETMESH_FIELD_LATTICE, "--box"},
                  {NETMESH_FIELD_LATTICE, "--cell"},
                  {NETMESH_FIELD_LATTICE_COUNT, "--box"},
                  {NETMESH_FIELD_LATTICE_COUNT, "--cell"}};
    std::vector<std::string> names;
    const auto add = [&](const char* name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
    };
    for (const OptionEntry& entry : option_entries())
        if (entry.effect.member != nullptr && engine_option(entry.effect.member).field == field) add(entry.name);
    for (const auto& row : others)
        if (row.field == field) add(row.option);
    return names;
}

}  // namespace netmesh::tool
