#include "tools/option_table.hpp"

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
         "above what is proven to be the least; --json has both numbers.\n",
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
         "itself how it was made, and options that contradict it are refused; one that does not say carries no "
         "certificate\n"
         "unless options say it. Other code then gives a second opinion. With --points it makes exact diagrams again, "
         "in exact\n"
         "arithmetic: every bar, to the last bit; of too many points degree 0, or a sample of it. With --mesh: filter "
         "values\n"
         "and ratios from the Voronoi cells, the pairs by a plain reduction. With --representatives cycles' births and "
         "deaths.\n"
         "What was not looked at is said.\n"
         "Alone, a file is only looked at for what every diagram must satisfy.\n",
         "check mesh.node --points points.csv\n"
         "check diagram.pers --points points.csv\n"},
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

std::string apply_tau(Options& options, const std::string& text) {
    double tau;
    if (!parse_finite(text, &tau) || !(tau > 2)) return "must be a finite number above 2";
    options.tau = tau;
    return {};
}

std::string apply_eps(Options& options, const std::string& text) {
    return parse_finite(text, &options.eps) && options.eps > 0 ? "" : "must be a finite number above 0";
}

std::string apply_cell_size(Options& options, const std::string& text) {
    const std::size_t comma = text.find(',');
    const bool grows = comma != std::string::npos;
    const bool good =
        parse_finite(text.substr(0, comma), &options.size_at_inputs) && options.size_at_inputs > 0 &&
        (!grows || (parse_finite(text.substr(comma + 1), &options.size_growth) && options.size_growth >= 0));
    return good ? "" : "must be a finite number above 0, and may have another, 0 or more, behind a comma: 0.1,0.5";
}

std::string apply_domain_factor(Options& options, const std::string& text) {
    const bool good =
        parse_finite(text, &options.domain_factor) && options.domain_factor >= 1 && options.domain_factor <= 8;
    return good ? "" : "must be a number from 1 to 8";
}

std::string apply_net(Options& options, const std::string& text) {
    const bool good =
        parse_finite(text, &options.net_spacing) && options.net_spacing >= 1.0 / 64 && options.net_spacing <= 8;
    return good ? "" : "must be a number from 1/64 = 0.015625 to 8";
}

std::string apply_theta(Options& options, const std::string& text) {
    const bool good = parse_finite(text, &options.theta) && options.theta > 0 && options.theta <= 1.0 / 9;
    return good ? "" : "must be a number above 0 and at most 1/9";
}

std::string apply_pace_theta(Options& options, const std::string& text) {
    const bool good = parse_finite(text, &options.pace_theta) && options.pace_theta > 0 && options.pace_theta <= 1;
    return good ? "" : "must be a number above 0 and at most 1";
}

std::string apply_ratio(Options& options, const std::string& text) {
    double ratio;
    if (!parse_finite(text, &ratio) || !(ratio * ratio > 2)) return "must be a finite number above the root of 2";
    options.ratio = ratio;
    return {};
}

std::string apply_focus(Options& options, const std::string& text) {
    const bool persists = options.command == Command::persist;
    options.focus = 0;
    options.focus_auto = persists && text == "auto";
    if (options.focus_auto || (parse_finite(text, &options.focus) && options.focus > 1)) return {};
    return persists ? "must be a finite number above 1, or auto" : "must be a finite number above 1";
}
std::string apply_longer_than(Options& options, const std::string& text) {
    return parse_finite(text, &options.longer_than) && options.longer_than > 1 ? "" : "must be a finite number above 1";
}
std::string apply_from(Options& options, const std::string& text) {
    return parse_finite(text, &options.from) && options.from > 0 ? "" : "must be a finite radius above 0";
}
std::string apply_threshold(Options& options, const std::string& text) {
    double threshold;
    if (!parse_finite(text, &threshold) || threshold < 0) return "must be a finite radius, 0 or more";
    options.threshold = threshold;
    return {};
}
std::string apply_to(Options& options, const std::string& text) {
    return parse_finite(text, &options.to) && options.to > 0 ? "" : "must be a finite radius above 0";
}

std::string apply_method(Options& options, const std::string& text) {
    for (const netmesh_method method : {NETMESH_METHOD_SVR, NETMESH_METHOD_HIERARCHY, NETMESH_METHOD_REFINE}) {
        if (text != method_name(method)) continue;
        options.method = method;
        return {};
    }
    return "there are svr, netmesh and refine";
}

std::string apply_cages(Options& options, const std::string& text) {
    if (text != "compact" && text != "thesis") return "there are compact and thesis";
    options.cages = text == "thesis" ? NETMESH_CAGES_THESIS : NETMESH_CAGES_COMPACT;
    return {};
}

std::string apply_filter(Options& options, const std::string& text) {
    const bool has_auto = options.command == Command::persist || options.command == Command::size;
    if (has_auto && text == "auto") {
        options.filter.reset();
        return {};
    }
    for (const netmesh_filter_info& info : filters()) {
        if (text != info.name) continue;
        options.filter = info.filter;
        return {};
    }
    return std::string("the filters are ") + (has_auto ? "auto, " : "") +
           list_filters([](const netmesh_filter_info&) { return true; }, "and");
}

std::string apply_values(Options& options, const std::string& text) {
    const bool named = text == "certified" || text == "thesis";
    options.values_path.clear();
    if (!named && options.command != Command::vineyard && options.command != Command::check)
        return "there are certified and thesis";
    if (!named) {
        options.values_path = text;
        return text.empty() ? "must be certified, thesis or a file name" : "";
    }
    options.values = text == "thesis" ? NETMESH_VALUES_THESIS : NETMESH_VALUES_CERTIFIED;
    return {};
}

std::string apply_k(Options& options, const std::string& text) {
    const std::size_t dots = options.command == Command::vineyard ? text.find("..") : std::string::npos;
    std::uint64_t first, last;
    const bool good = parse_unsigned(text.substr(0, dots), &first) &&
                      (dots == std::string::npos || parse_unsigned(text.substr(dots + 2), &last));
    if (dots == std::string::npos) last = first;
    if (!good || first == 0 || last < first || last >= 4294967295u) {
        return options.command == Command::vineyard ? "must be a range of numbers of neighbours from 1 on: 1..20"
                                                    : "must be a number of neighbours, 1 or more";
    }
    options.k = static_cast<std::uint32_t>(first);
    if (options.command == Command::vineyard) options.k_last = static_cast<std::uint32_t>(last);
    return {};
}

std::string apply_max_degree(Options& options, const std::string& text) {
    std::uint64_t degree;
    if (!parse_unsigned(text, &degree) || degree > 1000) return "must be a degree: 0, 1, 2, ...";
    options.max_degree = static_cast<std::uint32_t>(degree);
    return {};
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

std::string apply_seed(Options& options, const std::string& text) {
    return parse_unsigned(text, &options.seed) ? "" : "must be a whole number from 0 to 2^64 - 1";
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
    return parse_finite(text, &options.error) && options.error >= 0x1p-30 ? "" : "must be a finite number above 1e-9";
}
std::string apply_error(Options& options, const std::string& text) {
    return parse_finite(text, &options.error) && options.error > 0 ? "" : "must be a finite number above 0";
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

std::string apply_audit(Options& options, const std::string& value) {
    constexpr std::pair<const char*, unsigned> names[] = {{"location", NETMESH_AUDIT_LOCATION},
                                                          {"quality", NETMESH_AUDIT_QUALITY},
                                                          {"all", NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY}};
    for (const auto& [name, what] : names)
        if (value == name) return options.audit = what, "";
    return "not location, quality or all";
}

std::string apply_min_persistence(Options& options, const std::string& text) {
    const bool good = parse_finite(text, &options.min_persistence) && options.min_persistence >= 0;
    return good ? "" : "must be a finite number, 0 or more";
}

std::string apply_top(Options& options, const std::string& text) {
    return parse_unsigned(text, &options.top) && options.top > 0 ? "" : "must be a number of bars, 1 or more";
}

std::string apply_columns(Options& options, const std::string& text) {
    return parse_columns(text, &options.table.columns);
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
constexpr unsigned vineyard = bit(Command::vineyard);
constexpr unsigned engine = mesh | delaunay | persist;
constexpr unsigned points = engine | vineyard | check;  // commands that read points

constexpr const char* next_line = "\n                    ";  // of a help text

bool on_points(const netmesh_filter_info& info) { return info.source == NETMESH_SOURCE_POINTS; }

// The list says which filter is taken when none is named.
std::string with_default(std::string list, netmesh_filter filter) {
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

std::string vineyard_filter_help() {
    return with_default(list_filters(has_vineyard, "or"), default_filter(Command::vineyard));
}

}  // namespace

const std::vector<OptionEntry>& option_entries() {
    static const std::vector<OptionEntry> table = {
        {"-o", mesh | delaunay, "OUT", apply_out,
         ".node (with .ele and .neigh) or .off; of D = 2, 3 also .vtu .msh .mesh, or triangles as .ply .obj; without\n"
         "                    it OFF on stdout; of several POINTS {} stands for the name of each: -o 'out/{}.vtu'"},
        {"-o", persist, "OUT", apply_out,
         "the diagram: .pers .csv .json or .npy; without it .pers on stdout; of several POINTS {} stands for the name\n"
         "                    of each: -o '{}.pers'"},
        {"-o", homology, "OUT", apply_out, "the diagram: .pers .csv .json or .npy; without it .pers on stdout"},
        {"--min-persistence", persist | homology, "X", apply_min_persistence,
         "write bars no shorter than X alone (0); the file then carries no certificate"},
        {"--top", persist | homology, "N", apply_top, "write the N longest bars of each degree alone; likewise"},
        {"-o", vineyard, "OUT.vines", apply_out, "the vines; without it on stdout"},
        {"-o", sample, "OUT", apply_out, ".txt .xyz .csv or .npy; without it text on stdout"},
        {"--columns", points, "LIST", apply_columns,
         "the columns of a table or array that are coordinates: numbers from 1, ranges, names of the header: 2-4,z"},
        {"--delimiter", points, "C", apply_delimiter,
         "what stands between columns: , ; | tab or blank; commas in numbers are then decimal (told by the file)"},
        {"--skip", points, "N", apply_skip, "lines left out at the top of a table (none but a header)"},
        {"-n", sample, "N", apply_count, "number of points"},
        {"--dim", size | sample, "D", apply_dim, "dimension, 2 to 6"},
        {"--points", size, "N", apply_count, "number of points"},
        {"--points", check, "FILE", apply_path<&Options::points_path>,
         "the points that the mesh, diagram or vineyard was made of"},
        {"--mesh", check, "MESH.node", apply_path<&Options::mesh_path>,
         "the mesh that the diagram or vineyard was made of"},
        {"--mesh", persist, "MESH.node", apply_path<&Options::mesh_out>,
         "also write the mesh that is filtered, with the filter's values"},
        {"--tau", mesh | persist | vineyard | size | check, "T", apply_tau,
         "bound on the aspect ratio of Voronoi cells, above 2 (2.5 for D = 2, 3; 3.08; 4 for D = 5, 6)"},
        {"--eps", mesh | size | check, "E", apply_eps,
         "also refine until no cell reaches farther than E times the distance to the second nearest input"},
        {"--cell-size", mesh | check, "A[,B]", apply_cell_size,
         "also refine until no cell reaches farther than A plus B times its vertex's distance to the nearest input"},
        {"--domain", mesh, "F", apply_domain_factor,
         "radius of the ball that is meshed over that of the smallest one that holds the points, 1 to 8 (1)"},
        {"--net", mesh | check, "S", apply_net,
         "spacing of the boundary net of refine over the diameter of the smallest ball around the points (1)"},
        {"--eps", persist, "E", apply_eps,
         "log distance that tight promises, above 0 and at most 1/2 (1/2; D > 3: --ratio); scales: 3 theta more"},
        {"--pace", mesh | delaunay, "FILE", apply_path<&Options::pace_path>,
         "the inputs in an order that begins far apart, each farthest from those before, and its theta: distance to\n"
         "                    the nearest of those over that to the second (3.8)"},
        {"--theta", mesh | delaunay, "T", apply_pace_theta,
         "with --pace: only inputs that are not T-medial, T above 0 and at most 1"},
        {"--weighted-cells", mesh, "FILE", apply_path<&Options::weighted_path>,
         "each cage's weight, in-radius, feature size and epsilon as an additively weighted cell (4.6)"},
        {"--theta", persist | check, "T", apply_theta,
         "how medial points of one scale are, above 0 and at most 1/9 (1/9)"},
        {"--ratio", persist | check, "C", apply_ratio,
         "refine by the certificate until this ratio is certified, above 1.4142 (sqrt(2 + tau)): complete filter; in\n"
         "                    place of --eps tight, and scales with both numbers 1 + 3 theta times as large"},
        {"--whole-cells", persist | check, nullptr, apply_switch<&Options::whole_cells>,
         "refine by the certificate for whole Voronoi cells, not for cells clipped to a ball around the points: more\n"
         "                    vertices for the same ratio"},
        {"--focus", persist, "C|auto", apply_focus,
         "certify this ratio, above 1, of what matters to radii --from to --to. auto: refine where bars are undecided "
         "until\n"
         "                    each surely is real or surely short, or --memory is full; the file says C, A and B"},
        {"--focus", check, "C", apply_focus, "certify this ratio, above 1, of what matters to radii --from to --to"},
        {"--longer-than", persist, "L", apply_longer_than,
         "with --focus auto: bars that may die after L times their birth, L above 1, are to be decided (1.5)"},
        {"--from", persist | check, "A", apply_from, "least radius of interest"},
        {"--to", persist | check, "B", apply_to, "largest radius of interest"},
        {"--fit", persist, nullptr, apply_switch<&Options::fit>,
         "the least ratio that fits in --memory, of the radii --from to --to if given, for any filter on a mesh but "
         "tight; --ratio C is where it begins (4); of filter function the least error"},
        {"--method", persist | check, "M", apply_method,
         "of a quality mesh to filter, in place of refinement by the certificate: svr, netmesh with --finish, refine"},
        {"--method", mesh | size, "M", apply_method,
         "svr (default); netmesh: hierarchical, of linear size whatever the points' spread; refine: the thesis's 3.2"},
        {"--finish", mesh | persist | size | check, nullptr, apply_switch<&Options::finish>,
         "go on from a hierarchical mesh to one of quality tau without cages"},
        {"--cages", mesh | size, "KIND", apply_cages,
         "of --method netmesh: compact (default); thesis: those of its 4.5, grown and released, D = 2, 3, 4 (--tau 7)"},
        {"--audit", mesh | persist | size, "WHAT", apply_audit,
         "location: points stored in all D-balls, inserted in rounds of range nets (not for persist); quality: aspect\n"
         "                    ratios, degrees and invariants after each insertion; or all. Figures go to the report"},
        {"--filter", vineyard, "F", apply_filter, vineyard_filter_help()},
        {"--filter", persist | size, "F", apply_filter, auto_filter_help()},
        {"--filter", check, "F", apply_filter, with_default(filter_help(), default_filter(Command::check))},
        {"--distances", persist, nullptr, apply_switch<&Options::distances>,
         "POINTS is a file of distances, for --filter rips: a symmetric matrix, a lower triangle as ripser has it, or "
         ".npy or .npz of a matrix or of what scipy's pdist gives; inf: never joined"},
        {"--sparse", persist, nullptr, apply_switch<&Options::sparse>,
         "with --distances: lines `i j distance` of points from 0 on; pairs that are not listed are never joined"},
        {"--threshold", persist, "R", apply_threshold,
         "of filter rips: points are joined to radius R, which is half of their distance; ripser's are diameters, "
         "2 R"},
        {"--k", persist | size | check, "K", apply_k,
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
        {"--error", persist | check, "E", apply_error,
         "refine until each birth and death of the function's diagram is off by at most E"},
        {"--k", vineyard, "A..B", apply_k, "the numbers of neighbours, the point itself counted"},
        {"--max-degree", persist | vineyard | size | check, "P", apply_max_degree,
         "highest homology degree (D-1; 1 for " + list_filters(on_points, "and") + ")"},
        {"--max-degree", homology, "P", apply_max_degree, "highest homology degree (the dimension of the complex)"},
        {"--representatives", persist | homology, "FILE", apply_path<&Options::representatives>,
         ".vtu, .obj or .svg: a cycle for each bar to look at; .txt or .cycles: a line `bar DEGREE BIRTH DEATH N`,\n"
         "                    then N simplices, one a line: by vertices of the\n"
         "                    mesh, or of scales, rips and cech by the different points in their order"},
        {"--representatives", check, "FILE", apply_path<&Options::representatives>,
         "the diagram's cycles, as persist wrote them: with --mesh, or with --points for scales, rips and cech, each\n"
         "                    is one, is born with its bar and dies with it"},
        {"--memory", engine | vineyard | homology | check, "SIZE", apply_memory,
         "the block that the engine works in: 64K, 512M, 2G; reserved lazily until the job fits if not given"},
        {"--seed", engine | vineyard | check | sample, "S", apply_seed, "of every random choice (1)"},
        {"--noise", sample, "X", apply_noise, "standard deviation of a normal offset of every coordinate (0)"},
        {"--turns", sample, "A,B", apply_turns, "of the Clifford winding about its two circles (1,10)"},
        {"--svg", mesh | delaunay, "FILE", apply_path<&Options::svg>,
         "picture of a mesh in 2 dimensions, of a cut through it in 3; - is stdout, for it alone"},
        {"--voronoi", mesh | delaunay, nullptr, apply_switch<&Options::voronoi>,
         "the picture shows Voronoi cells, coloured by how fine they are, in 2 dimensions"},
        {"--svg", persist | homology, "FILE", apply_path<&Options::svg>,
         "picture of barcode and diagram; - is stdout, for it alone"},
        {"--svg", vineyard, "FILE", apply_path<&Options::svg>,
         "picture of the vines, k against radius; - is stdout, for it alone"},
        {"--axis", persist | homology | vineyard, "A", apply_axis,
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
        {"--bounds", persist, nullptr, apply_switch<&Options::bounds>,
         "where each birth and death surely is and which bars surely are real, behind the bars, and the certified "
         "ratio by\n"
         "                    scale, in front of them; both in JSON and in the picture"},
        {"--all", persist | homology | check, nullptr, apply_switch<&Options::all>, "keep bars of length zero"},
        {"--json", engine | vineyard | homology | distance | size | check, nullptr, apply_switch<&Options::json>,
         "report as JSON on stdout; data then goes to -o only, but bars without -o stand in the JSON"},
        {"--quiet", engine | vineyard | homology | distance | size | check | sample, nullptr,
         apply_switch<&Options::quiet>, "no progress, no summary"},
    };
    return table;
}

std::vector<std::string> words_of(const OptionEntry& option, Command command) {
    const std::string name = option.name;
    if (name == "--method") return {"svr", "netmesh", "refine"};
    if (name == "--cages") return {"compact", "thesis"};
    if (name == "--values") return {"certified", "thesis"};
    if (name == "--audit") return {"location", "quality", "all"};
    if (name == "--delimiter") return {"tab", "blank", "comma", "semicolon"};
    if (name == "--axis") return {"log", "linear"};
    if (name == "--focus" && command == Command::persist) return {"auto"};
    std::vector<std::string> words;
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

const char* option_name(netmesh_field field) {
    static constexpr struct {
        netmesh_field field;
        const char* option;
    } table[] = {{NETMESH_FIELD_TAU, "--tau"},
                 {NETMESH_FIELD_SIZES, "--eps"},
                 {NETMESH_FIELD_SIZE_AT_INPUTS, "--cell-size"},
                 {NETMESH_FIELD_CAGE_KIND, "--cages"},
                 {NETMESH_FIELD_SIZE_GROWTH, "--cell-size"},
                 {NETMESH_FIELD_DOMAIN_FACTOR, "--domain"},
                 {NETMESH_FIELD_NET_SPACING, "--net"},
                 {NETMESH_FIELD_TIGHT_EPS, "--eps"},
                 {NETMESH_FIELD_EPS, "--eps"},
                 {NETMESH_FIELD_THETA, "--theta"},
                 {NETMESH_FIELD_RATIO, "--ratio"},
                 {NETMESH_FIELD_FOCUS_RATIO, "--focus"},
                 {NETMESH_FIELD_FOCUS_FROM, "--from"},
                 {NETMESH_FIELD_FOCUS_TO, "--to"},
                 {NETMESH_FIELD_LONGER_THAN, "--longer-than"},
                 {NETMESH_FIELD_METHOD, "--method"},
                 {NETMESH_FIELD_AUDIT, "--audit"},
                 {NETMESH_FIELD_FILTER, "--filter"},
                 {NETMESH_FIELD_VALUES, "--values"},
                 {NETMESH_FIELD_FUNCTION, "--function"},
                 {NETMESH_FIELD_LIPSCHITZ, "--lipschitz"},
                 {NETMESH_FIELD_CUT, "--cut"},
                 {NETMESH_FIELD_K, "--k"},
                 {NETMESH_FIELD_K_FIRST, "--k"},
                 {NETMESH_FIELD_K_LAST, "--k"},
                 {NETMESH_FIELD_MAX_DEGREE, "--max-degree"}};
    for (const auto& row : table)
        if (row.field == field) return row.option;
    return nullptr;
}

}  // namespace netmesh::tool
