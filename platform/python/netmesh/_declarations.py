"""What the C headers declare. Written by platform/python/declare, not by hand."""
from ctypes import (CFUNCTYPE, Structure, c_char_p, c_double, c_int, c_int32, c_int64, c_size_t, c_uint32, c_uint64,
                    c_void_p)

NETMESH_VERSION_MAJOR = 0
NETMESH_VERSION_MINOR = 3
NETMESH_VERSION_PATCH = 0
NETMESH_DIM_MIN = 2
NETMESH_DIM_MAX = 6
NETMESH_DEGREE_MAX = 31
NETMESH_NONE = 0xFFFFFFFF
NETMESH_POINTS_MAX = 1 << 28
NETMESH_OK = 0
NETMESH_INVALID_ARGUMENT = 1
NETMESH_OUT_OF_MEMORY = 2
NETMESH_CANCELLED = 3
NETMESH_NOT_FINITE = 4
NETMESH_OUT_OF_RANGE = 5
NETMESH_FLAT = 6
NETMESH_TOO_CLOSE = 7
NETMESH_NO_RESULT = 8
NETMESH_CHECK_FAILED = 9
NETMESH_FLOATING_POINT = 10
NETMESH_INTERNAL = 11
NETMESH_NOT_A_COMPLEX = 12
NETMESH_NOT_BUILT = 13
NETMESH_PAUSED = 14
NETMESH_STACK_OVERFLOW = 15
NETMESH_POINTS_FLOAT64 = 0
NETMESH_POINTS_FLOAT32 = 1
NETMESH_FIELD_NONE = 0
NETMESH_FIELD_REQUEST = 1
NETMESH_FIELD_STRUCT_BYTES = 2
NETMESH_FIELD_RESULT = 3
NETMESH_FIELD_POINTS = 4
NETMESH_FIELD_DIM = 5
NETMESH_FIELD_POINT_COUNT = 6
NETMESH_FIELD_POINT_FORMAT = 7
NETMESH_FIELD_POINT_STRIDE_BYTES = 8
NETMESH_FIELD_DISTANCES = 9
NETMESH_FIELD_LAYOUT = 10
NETMESH_FIELD_NUMBERS = 11
NETMESH_FIELD_ENTRIES = 12
NETMESH_FIELD_ENTRY_COUNT = 13
NETMESH_FIELD_EVALUATE = 14
NETMESH_FIELD_SIMPLICES = 15
NETMESH_FIELD_VERTICES = 16
NETMESH_FIELD_VERTEX_COUNT = 17
NETMESH_FIELD_STARTS = 18
NETMESH_FIELD_SIMPLEX_COUNT = 19
NETMESH_FIELD_STEP_COUNT = 20
NETMESH_FIELD_FILTER = 21
NETMESH_FIELD_VALUES = 22
NETMESH_FIELD_K = 23
NETMESH_FIELD_K_LAST = 24
NETMESH_FIELD_MAX_DEGREE = 25
NETMESH_FIELD_KEEP_ZERO_PAIRS = 26
NETMESH_FIELD_THRESHOLD = 27
NETMESH_FIELD_SEED = 28
NETMESH_FIELD_FUNCTION = 29
NETMESH_FIELD_LIPSCHITZ = 30
NETMESH_FIELD_DISTANCE_FACTOR = 31
NETMESH_FIELD_CUT = 32
NETMESH_FIELD_RATIO = 33
NETMESH_FIELD_EPS = 34
NETMESH_FIELD_THETA = 35
NETMESH_FIELD_ERROR = 36
NETMESH_FIELD_FOCUS_RATIO = 37
NETMESH_FIELD_FOCUS_FROM = 38
NETMESH_FIELD_FOCUS_TO = 39
NETMESH_FIELD_LONGER_THAN = 40
NETMESH_FIELD_METHOD = 41
NETMESH_FIELD_TAU = 42
NETMESH_FIELD_DOMAIN_FACTOR = 43
NETMESH_FIELD_NET_SPACING = 44
NETMESH_FIELD_SIZES = 45
NETMESH_FIELD_SIZE_EPS = 46
NETMESH_FIELD_SIZE_AT_INPUTS = 47
NETMESH_FIELD_SIZE_GROWTH = 48
NETMESH_FIELD_FINISH = 49
NETMESH_FIELD_WHOLE_CELLS = 50
NETMESH_FIELD_AUDIT = 51
NETMESH_FIELD_BOUNDS = 52
NETMESH_FIELD_CYCLES = 53
NETMESH_FIELD_VINES = 54
NETMESH_FIELD_FIT = 55
NETMESH_FIELD_KEEP_MESH = 56
NETMESH_FIELD_PROMISED = 57
NETMESH_FIELD_MARKERS = 58
NETMESH_FIELD_CELLS = 59
NETMESH_FIELD_CELL_COUNT = 60
NETMESH_FIELD_DOMAIN = 61
NETMESH_FIELD_CAGES = 62
NETMESH_FIELD_CAGE_COUNT = 63
NETMESH_FIELD_CAGE_BYTES = 64
NETMESH_FIELD_WHAT = 65
NETMESH_FIELD_TOLERANCE = 66
NETMESH_FIELD_ORDER = 67
NETMESH_FIELD_THETAS = 68
NETMESH_FIELD_SCALE = 69
NETMESH_FIELD_SCRATCH = 70
NETMESH_FIELD_PAIRS_A = 71
NETMESH_FIELD_PAIRS_B = 72
NETMESH_FIELD_PAIR_BYTES = 73
NETMESH_FIELD_RELATIVE_ERROR = 74
NETMESH_FIELD_MATES = 75
NETMESH_FIELD_POTENTIALS = 76
NETMESH_FIELD_SOURCE = 77
NETMESH_FIELD_PIECES = 78
NETMESH_FIELD_NODE = 79
NETMESH_FIELD_ONE = 80
NETMESH_FIELD_OTHER = 81
NETMESH_FIELD_MONITOR = 82
NETMESH_FIELD_WEIGHTS = 83
NETMESH_FIELD_WEIGHT_STRIDE_BYTES = 84
NETMESH_FIELD_WEIGHTING = 85
NETMESH_FIELD_SQUARES = 86
NETMESH_FIELD_LATTICE = 87
NETMESH_FIELD_LATTICE_COUNT = 88
NETMESH_FIELD_PERIODS = 89
NETMESH_FIELD_COUNT = 90
NETMESH_FAULT_NONE = 0
NETMESH_FAULT_SIZE = 1
NETMESH_FAULT_TOO_MANY = 2
NETMESH_FAULT_VERTEX_TWICE = 3
NETMESH_FAULT_LISTED_TWICE = 4
NETMESH_FAULT_FACE_MISSING = 5
NETMESH_FAULT_FACE_LATER = 6
NETMESH_STAGE_NONE = 0
NETMESH_STAGE_SORT = 1
NETMESH_STAGE_DELAUNAY = 2
NETMESH_STAGE_REFINE = 3
NETMESH_STAGE_CERTIFY = 4
NETMESH_STAGE_FILTER = 5
NETMESH_STAGE_GRADIENT = 6
NETMESH_STAGE_REDUCE = 7
NETMESH_STAGE_CHECK = 8
NETMESH_STAGE_ANALYSE = 9
NETMESH_STAGE_COUNT = 10
NETMESH_RIPS_DIM_MAX = 65536
NETMESH_DISTANCES_FULL = 0
NETMESH_DISTANCES_LOWER = 1
NETMESH_DISTANCES_SPARSE = 2
NETMESH_DISTANCES_FUNCTION = 3
NETMESH_DISTANCES_COUNT = 4
NETMESH_OPEN = 0xFFFFFFFF
NETMESH_WEIGHTING_NONE = 0
NETMESH_WEIGHTING_RADII = 1
NETMESH_WEIGHTING_WEIGHTS = 2
NETMESH_VALUES_CERTIFIED = 0
NETMESH_VALUES_THESIS = 1
NETMESH_VALUES_OPEN = 2
NETMESH_AUDIT_LOCATION = 1
NETMESH_AUDIT_QUALITY = 2
NETMESH_OPTION_FLAG = 1
NETMESH_OPTION_UINT32 = 2
NETMESH_OPTION_UINT64 = 3
NETMESH_OPTION_DOUBLE = 4
NETMESH_OPTION_NAME = 5
NETMESH_OPTION_NAMES = 6
NETMESH_FILTER_NONE = 0
NETMESH_FILTER_COMPLETE = 1
NETMESH_FILTER_BASIC = 2
NETMESH_FILTER_ALPHA = 3
NETMESH_FILTER_KNN = 4
NETMESH_FILTER_KDISTANCE = 5
NETMESH_FILTER_FUNCTION = 6
NETMESH_FILTER_TIGHT = 7
NETMESH_FILTER_SCALES = 8
NETMESH_FILTER_RIPS = 9
NETMESH_FILTER_CECH = 10
NETMESH_FILTER_BARYCENTRIC_CECH = 11
NETMESH_FILTER_BARYCENTRIC_RIPS = 12
NETMESH_FILTER_AUTO = 255
NETMESH_WHY_ASKED = 0
NETMESH_WHY_AFFORDABLE = 1
NETMESH_WHY_NO_MESH = 2
NETMESH_WHY_CELLS = 3
NETMESH_WHY_MEMORY = 4
NETMESH_WHY_FLAT = 5
NETMESH_WHY_RANGE = 6
NETMESH_WHY_ALONE = 7
NETMESH_METHOD_SVR = 0
NETMESH_METHOD_NETMESH = 1
NETMESH_METHOD_REFINE = 2
NETMESH_METHOD_CERTIFICATE = 3
NETMESH_METHOD_THESIS = 4
NETMESH_METHOD_DELAUNAY = 5
NETMESH_CHECK_COMBINATORIAL = 1
NETMESH_CHECK_GEOMETRIC = 2
NETMESH_CHECK_DELAUNAY = 4
NETMESH_CHECK_QUALITY = 8
NETMESH_CHECK_BOUNDS = 16
NETMESH_CHECK_ALL = 31
NETMESH_ROUNDS_MAX = 32
NETMESH_PREDICATE_CACHED = 0
NETMESH_PREDICATE_FLOAT = 1
NETMESH_PREDICATE_INTEGER = 2
NETMESH_PREDICATE_EXACT = 3
NETMESH_PREDICATE_TIE = 4
NETMESH_PREDICATE_STAGES = 5
NETMESH_FIGURE_FLAG = 1
NETMESH_FIGURE_UINT32 = 2
NETMESH_FIGURE_UINT64 = 3
NETMESH_FIGURE_DOUBLE = 4
NETMESH_FIGURE_FINGERPRINT = 5
NETMESH_FIGURE_NAME = 6
NETMESH_ALL_DEGREES = 0xFFFFFFFF
NETMESH_ORDER_MAX = 16
NETMESH_SCALE_PLAIN = 0
NETMESH_SCALE_LOG = 1
NETMESH_PIECES_POINTS_MAX = 0x7FFFFFFF
NETMESH_ANALYSE_SIZE = 1
NETMESH_ANALYSE_STRUCTURE = 2
NETMESH_ANALYSE_FATNESS = 4
NETMESH_ANALYSE_ALL = 7


class netmesh_detail(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("status", c_int), ("field", c_int), ("fault", c_int),
                ("index_a", c_uint64), ("index_b", c_uint64), ("bytes_wanted", c_uint64), ("message", c_char_p),
                ("step", c_uint64)]


class netmesh_progress(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("stage", c_int), ("done", c_uint64), ("total", c_uint64),
                ("vertices", c_uint64), ("cells", c_uint64)]


class netmesh_monitor(Structure):
    _fields_ = [("poll", c_void_p), ("user", c_void_p)]


class netmesh_points(Structure):
    _fields_ = [("coordinates", c_void_p), ("count", c_size_t), ("dim", c_uint32), ("format", c_int),
                ("stride_bytes", c_size_t), ("weights", c_void_p), ("weight_stride_bytes", c_size_t),
                ("lattice", c_void_p), ("lattice_count", c_uint32)]


class netmesh_distance_entry(Structure):
    _fields_ = [("i", c_uint32), ("j", c_uint32), ("distance", c_double)]


class netmesh_distances(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("layout", c_int), ("numbers", c_void_p), ("entries", c_void_p),
                ("entry_count", c_uint64), ("evaluate", c_void_p), ("user", c_void_p), ("count", c_uint64)]


class netmesh_simplices(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("by_vertex", c_uint32), ("vertices", c_void_p), ("starts", c_void_p),
                ("entries", c_void_p), ("simplex_count", c_uint64), ("vertex_count", c_uint64),
                ("step_count", c_uint64)]


class netmesh_function(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("evaluate", c_void_p), ("user", c_void_p), ("lipschitz", c_double),
                ("distance_factor", c_double), ("cut", c_double)]


class netmesh_goal(Structure):
    _fields_ = [("ratio", c_double), ("eps", c_double), ("theta", c_double), ("error", c_double),
                ("focus_ratio", c_double), ("focus_from", c_double), ("focus_to", c_double),
                ("longer_than", c_double)]


class netmesh_sizes(Structure):
    _fields_ = [("eps", c_double), ("at_inputs", c_double), ("growth", c_double), ("size", c_void_p),
                ("user", c_void_p)]


class netmesh_mesh_rules(Structure):
    _fields_ = [("method", c_void_p), ("tau", c_double), ("domain_factor", c_double), ("net_spacing", c_double),
                ("sizes", netmesh_sizes), ("finish", c_uint32), ("whole_cells", c_uint32), ("audit", c_uint32),
                ("reserved", c_uint32)]


class netmesh_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("max_degree", c_uint32), ("monitor", netmesh_monitor),
                ("points", netmesh_points), ("distances", c_void_p), ("simplices", c_void_p), ("filter", c_void_p),
                ("values", c_int), ("k", c_uint32), ("k_last", c_uint32), ("keep_zero_pairs", c_uint32),
                ("function", c_void_p), ("threshold", c_double), ("seed", c_uint64), ("goal", netmesh_goal),
                ("mesh", netmesh_mesh_rules), ("bounds", c_void_p), ("cycles", c_void_p), ("vines", c_void_p),
                ("fit", c_void_p), ("keep_mesh", c_uint32), ("squares", c_uint32), ("weighting", c_void_p),
                ("periods", c_void_p)]


class netmesh_option(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("type", c_int), ("field", c_int), ("offset", c_uint32),
                ("name", c_char_p), ("range", c_char_p), ("default_is", c_char_p), ("sentence", c_char_p),
                ("object", c_void_p)]


class netmesh_option_word(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("value", c_uint32), ("name", c_char_p), ("object", c_void_p)]


class netmesh_filter_info(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("id", c_int), ("filter", c_void_p), ("is_on_mesh", c_uint32),
                ("is_on_triangulation", c_uint32), ("is_on_points", c_uint32), ("is_by_scales", c_uint32),
                ("name", c_char_p), ("reference", c_char_p), ("needs_k", c_uint32), ("needs_function", c_uint32),
                ("has_eps", c_uint32), ("has_theta", c_uint32), ("has_values", c_uint32), ("has_vineyard", c_uint32),
                ("has_goal", c_uint32), ("has_representatives", c_uint32), ("bounds_by_scale", c_uint32),
                ("clips_cells", c_uint32)]


class netmesh_pair(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("degree", c_uint32), ("birth", c_double), ("death", c_double)]


class netmesh_bar_bounds(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("certain", c_uint32), ("birth_low", c_double), ("birth_high", c_double),
                ("death_low", c_double), ("death_high", c_double), ("certain_after", c_double)]


class netmesh_scale_step(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("from", c_double), ("low", c_double), ("high", c_double),
                ("reach", c_double), ("ratio", c_double), ("error", c_double)]


class netmesh_simplex(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("degree", c_uint32), ("value", c_double),
                ("vertices", c_uint32 * (NETMESH_DEGREE_MAX + 1)),
                ("translations", c_int32 * (NETMESH_DIM_MAX) * (NETMESH_DIM_MAX + 1))]


class netmesh_vine_point(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("vine", c_uint32), ("degree", c_uint32), ("k", c_uint32),
                ("birth", c_double), ("death", c_double)]


class netmesh_load_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("dim", c_uint32), ("monitor", netmesh_monitor), ("vertices", c_void_p),
                ("markers", c_void_p), ("vertex_count", c_size_t), ("cells", c_void_p), ("cell_count", c_size_t),
                ("domain", c_void_p), ("promised", c_void_p)]


class netmesh_cage(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("centre", c_uint32), ("parent", c_uint32), ("radius", c_double)]


class netmesh_cages_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("cage_bytes", c_uint32), ("monitor", netmesh_monitor),
                ("cages", c_void_p), ("cage_count", c_size_t)]


class netmesh_vertex(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("marker", c_uint32), ("coordinates", c_double * (NETMESH_DIM_MAX)),
                ("has_value", c_uint32), ("value", c_double)]


class netmesh_cell(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("vertices", c_uint32 * (NETMESH_DIM_MAX + 1)),
                ("neighbours", c_uint32 * (NETMESH_DIM_MAX + 1))]


class netmesh_check_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("what", c_uint32), ("monitor", netmesh_monitor), ("promised", c_void_p)]


class netmesh_input_report(Structure):
    _fields_ = [("present", c_uint32), ("dim", c_uint32), ("points", c_uint64), ("duplicates", c_uint64),
                ("distinct", c_uint64), ("fingerprint", c_uint64), ("hidden", c_uint64), ("weighting", c_int),
                ("squares", c_uint32), ("periods", c_uint32), ("copies", c_uint64), ("moved", c_double)]


class netmesh_sizes_report(Structure):
    _fields_ = [("eps", c_double), ("ratio_max", c_double)]


class netmesh_hierarchy_report(Structure):
    _fields_ = [("present", c_uint32), ("cages", c_uint64), ("cages_made", c_uint64), ("reserved", c_uint64 * (3))]


class netmesh_audit_report(Structure):
    _fields_ = [("what", c_uint32), ("rounds", c_uint32), ("nets", c_uint32), ("nets_max", c_uint32),
                ("load", c_uint32 * (NETMESH_ROUNDS_MAX)), ("ply_max", c_uint32), ("touches_max", c_uint32),
                ("ply_mean", c_double), ("touches_mean", c_double), ("tests_mean", c_double), ("meshes", c_uint64),
                ("aspect_ratio_max", c_double), ("feature_ratio", c_double), ("cage_ratio", c_double),
                ("steiner_ratio", c_double), ("input_ratio", c_double), ("degree_max", c_uint64),
                ("reserved", c_uint64 * (1))]


class netmesh_mesh_report(Structure):
    _fields_ = [("present", c_uint32), ("is_mesh", c_uint32), ("vertices", c_uint64), ("inputs", c_uint64),
                ("steiner", c_uint64), ("exempt", c_uint64), ("cells", c_uint64), ("cells_created", c_uint64),
                ("method", c_int), ("domain", c_double * (NETMESH_DIM_MAX + 1)), ("aspect_ratio_max", c_double),
                ("tau", c_double), ("goal", netmesh_goal), ("sizes", netmesh_sizes_report),
                ("hierarchy", netmesh_hierarchy_report), ("audit", netmesh_audit_report), ("touches", c_uint64),
                ("clipped", c_uint32), ("reserved_word", c_uint32), ("reserved", c_uint64 * (2))]


class netmesh_diagram_report(Structure):
    _fields_ = [("present", c_uint32), ("filter", c_int), ("values", c_int), ("max_degree", c_uint32),
                ("k", c_uint32), ("representatives", c_uint32), ("pairs", c_uint64 * (NETMESH_DEGREE_MAX + 1)),
                ("essential", c_uint64 * (NETMESH_DEGREE_MAX + 1)), ("simplices", c_uint64),
                ("certified_ratio", c_double), ("certified_ratio_best", c_double), ("certified_from", c_double),
                ("certified_focus", c_double), ("certified_error", c_double), ("fitted_error", c_double),
                ("why", c_int), ("reserved_word", c_uint32), ("tried_points", c_uint64), ("tried_cells", c_uint64)]


class netmesh_bounds_report(Structure):
    _fields_ = [("present", c_uint32), ("max_degree", c_uint32), ("certain", c_uint64 * (NETMESH_DEGREE_MAX + 1)),
                ("steps", c_uint64), ("reserved", c_uint64 * (2))]


class netmesh_decision_report(Structure):
    _fields_ = [("present", c_uint32), ("max_degree", c_uint32), ("longer_than", c_double),
                ("undecided", c_uint64 * (NETMESH_DEGREE_MAX + 1)), ("undecided_to", c_double),
                ("decided_from", c_double), ("reserved", c_uint64 * (2))]


class netmesh_scales_report(Structure):
    _fields_ = [("present", c_uint32), ("count", c_uint32), ("points_max", c_uint64), ("vertices_max", c_uint64),
                ("vertices", c_uint64), ("separation", c_double), ("reserved", c_uint64 * (2))]


class netmesh_vineyard_report(Structure):
    _fields_ = [("present", c_uint32), ("filter", c_int), ("values", c_int), ("max_degree", c_uint32),
                ("k_first", c_uint32), ("k_last", c_uint32), ("vines", c_uint64), ("points", c_uint64),
                ("transpositions", c_uint64), ("simplices", c_uint64), ("certified_ratio", c_double),
                ("reserved", c_uint64 * (2))]


class netmesh_complex_report(Structure):
    _fields_ = [("present", c_uint32), ("vertices", c_uint64), ("reserved", c_uint64 * (2))]


class netmesh_memory_report(Structure):
    _fields_ = [("block_bytes", c_uint64), ("peak_bytes", c_uint64), ("used_bytes", c_uint64),
                ("reserved", c_uint64 * (2))]


class netmesh_predicates_report(Structure):
    _fields_ = [("in_ball", c_uint64 * (NETMESH_PREDICATE_STAGES)), ("orient", c_uint64 * (NETMESH_PREDICATE_STAGES)),
                ("reserved", c_uint64 * (2))]


class netmesh_report(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("complete", c_uint32), ("fingerprint", c_uint64),
                ("input", netmesh_input_report), ("mesh", netmesh_mesh_report), ("diagram", netmesh_diagram_report),
                ("bounds", netmesh_bounds_report), ("scales", netmesh_scales_report),
                ("vineyard", netmesh_vineyard_report), ("simplicial_complex", netmesh_complex_report),
                ("memory", netmesh_memory_report), ("predicates", netmesh_predicates_report),
                ("decision", netmesh_decision_report)]


class netmesh_figure(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("type", c_int), ("path", c_char_p), ("values", c_void_p),
                ("is_array", c_uint32), ("count", c_uint32), ("applies", c_uint32), ("on_request", c_uint32),
                ("in_fingerprint", c_uint32), ("text", c_char_p)]


class netmesh_bottleneck_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("pair_bytes", c_uint32), ("monitor", netmesh_monitor),
                ("pairs_a", c_void_p), ("pairs_b", c_void_p), ("count_a", c_uint64), ("count_b", c_uint64),
                ("degree", c_uint32), ("scale", c_int), ("scratch", c_void_p), ("scratch_bytes", c_size_t)]


class netmesh_distance(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("exponent", c_int32), ("value", c_double)]


class netmesh_wasserstein_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("pair_bytes", c_uint32), ("monitor", netmesh_monitor),
                ("pairs_a", c_void_p), ("pairs_b", c_void_p), ("count_a", c_uint64), ("count_b", c_uint64),
                ("degree", c_uint32), ("order", c_uint32), ("relative_error", c_double), ("scratch", c_void_p),
                ("scratch_bytes", c_size_t), ("mates_a", c_void_p), ("potentials_a", c_void_p),
                ("potentials_b", c_void_p)]


class netmesh_wasserstein_distance(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("exponent", c_int32), ("value", c_double), ("lower", c_double)]


class netmesh_source(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("dim", c_uint32), ("levels", c_uint32), ("reserved", c_uint32),
                ("count", c_uint64), ("rows", c_uint64), ("fingerprint", c_uint64), ("read", c_void_p),
                ("box", c_void_p), ("user", c_void_p)]


class netmesh_split_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("pieces", c_uint32), ("points", netmesh_points),
                ("monitor", netmesh_monitor)]


class netmesh_split_result(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("dim", c_uint32), ("count", c_uint64), ("rows", c_uint64),
                ("fingerprint", c_uint64), ("order", c_void_p), ("boxes", c_void_p), ("box_count", c_uint64),
                ("levels", c_uint32), ("reserved", c_uint32)]


class netmesh_leaf_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("pieces", c_uint32), ("source", c_void_p), ("node", c_uint32),
                ("max_degree", c_uint32), ("keep_zero_pairs", c_uint32), ("reserved", c_uint32),
                ("monitor", netmesh_monitor)]


class netmesh_piece(Structure):
    _fields_ = [("bytes", c_void_p), ("count", c_size_t)]


class netmesh_join_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("one", netmesh_piece), ("other", netmesh_piece),
                ("monitor", netmesh_monitor)]


class netmesh_piece_info(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("look_at_all", c_uint32), ("node", c_uint32), ("pieces", c_uint32),
                ("dim", c_uint32), ("max_degree", c_uint32), ("keep_zero_pairs", c_uint32), ("reserved", c_uint32),
                ("points", c_uint64), ("rows", c_uint64), ("fingerprint", c_uint64), ("simplices", c_uint64),
                ("bars", c_uint64), ("bytes", c_uint64), ("head_bytes", c_uint64), ("join_bytes", c_uint64),
                ("fault", c_char_p)]


class netmesh_collect_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("pieces", c_void_p), ("open", c_void_p), ("user", c_void_p),
                ("count", c_size_t), ("monitor", netmesh_monitor)]


class netmesh_voronoi(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("bounded", c_uint32), ("piece", c_uint32), ("corners", c_uint32),
                ("degree", c_uint32), ("nearest", c_double), ("reach", c_double),
                ("in_ball", c_double * (NETMESH_DIM_MAX + 1)), ("out_ball", c_double * (NETMESH_DIM_MAX + 1)),
                ("beta", c_double)]


class netmesh_ball(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("ply", c_uint32), ("meets", c_uint32),
                ("ball", c_double * (NETMESH_DIM_MAX + 1)), ("error", c_double)]


class netmesh_weighted_cell(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("weight", c_double), ("in_radius", c_double), ("feature_size", c_double),
                ("epsilon", c_double), ("cage_in_radius", c_double), ("cage_out_radius", c_double)]


class netmesh_analyse_request(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("what", c_uint32), ("monitor", netmesh_monitor), ("tolerance", c_double),
                ("promised", c_void_p)]


class netmesh_size_analysis(Structure):
    _fields_ = [("present", c_uint32), ("vertices", c_uint64), ("lower", c_double), ("upper", c_double),
                ("feature_ratio", c_double), ("feature_ratio_bound", c_double), ("theta", c_double),
                ("theta_limit", c_double), ("theta_log_sum", c_double), ("radii", c_double * (3)),
                ("integral_lower", c_double * (3)), ("integral_upper", c_double * (3)), ("pace_lower", c_double),
                ("pace_upper", c_double), ("boxes", c_uint64), ("upper_over_lower", c_double), ("domains", c_uint64)]


class netmesh_structure_analysis(Structure):
    _fields_ = [("present", c_uint32), ("degree_max", c_uint64), ("star_max", c_uint64), ("degree_mean", c_double),
                ("star_mean", c_double), ("ply_points", c_uint64), ("ply_max", c_uint64), ("ply_mean", c_double),
                ("balls", c_uint64), ("intersections_max", c_uint64), ("intersections_mean", c_double),
                ("ply_stride", c_uint64), ("balls_stride", c_uint64)]


class netmesh_boundary_analysis(Structure):
    _fields_ = [("present", c_uint32), ("vertices", c_uint64), ("degree_max", c_uint64), ("balls", c_uint64),
                ("intersections_max", c_uint64), ("reserved", c_uint64 * (2))]


class netmesh_fatness(Structure):
    _fields_ = [("cells", c_uint64), ("beta_max", c_double), ("beta_mean", c_double), ("aspect_ratio_max", c_double),
                ("edges", c_uint64), ("degree_max", c_uint64), ("edges_bound", c_double), ("faces", c_double),
                ("faces_bound", c_double), ("degree_share", c_double), ("planar_share", c_double),
                ("corners_share", c_double)]


class netmesh_fatness_analysis(Structure):
    _fields_ = [("present", c_uint32), ("bounded", netmesh_fatness), ("inside", netmesh_fatness),
                ("clipped_cells", c_uint64), ("clipped_beta_max", c_double), ("clipped_beta_mean", c_double),
                ("reserved", c_uint64 * (2))]


class netmesh_all_cells_analysis(Structure):
    _fields_ = [("present", c_uint32), ("cells", netmesh_fatness), ("left_out", c_uint64), ("radius", c_double),
                ("reserved", c_uint64 * (4))]


class netmesh_analysis(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("what", c_uint32), ("fingerprint", c_uint64),
                ("size", netmesh_size_analysis), ("structure", netmesh_structure_analysis),
                ("fatness", netmesh_fatness_analysis), ("boundary", netmesh_boundary_analysis),
                ("all_cells", netmesh_all_cells_analysis)]


class netmesh_point_arrays(Structure):
    _fields_ = [("points", c_void_p), ("rows", c_void_p), ("boxes", c_void_p), ("dim", c_uint32)]


class netmesh_python_watch(Structure):
    _fields_ = [("ensure", c_void_p), ("release", c_void_p), ("check_signals", c_void_p), ("fetch", c_void_p),
                ("call", c_void_p), ("signals_every", c_int64), ("progress_every", c_int64),
                ("signals_next", c_int64), ("progress_next", c_int64), ("error_type", c_void_p),
                ("error_value", c_void_p), ("error_traceback", c_void_p), ("answer", c_int32), ("stop", c_int32)]


netmesh_poll = CFUNCTYPE(c_int, c_void_p, c_void_p)
netmesh_distance_function = CFUNCTYPE(c_double, c_void_p, c_uint32, c_uint32)
netmesh_size = CFUNCTYPE(c_double, c_void_p, c_void_p)
netmesh_read_points = CFUNCTYPE(c_int, c_void_p, c_uint64, c_uint32, c_void_p, c_void_p)
netmesh_read_box = CFUNCTYPE(c_int, c_void_p, c_uint32, c_void_p)
netmesh_open_piece = CFUNCTYPE(c_int, c_void_p, c_size_t, c_void_p)
netmesh_task = CFUNCTYPE(c_int, c_void_p)

STRUCTS = [netmesh_detail, netmesh_progress, netmesh_monitor, netmesh_points, netmesh_distance_entry,
           netmesh_distances, netmesh_simplices, netmesh_function, netmesh_goal, netmesh_sizes, netmesh_mesh_rules,
           netmesh_request, netmesh_option, netmesh_option_word, netmesh_filter_info, netmesh_pair,
           netmesh_bar_bounds, netmesh_scale_step, netmesh_simplex, netmesh_vine_point, netmesh_load_request,
           netmesh_cage, netmesh_cages_request, netmesh_vertex, netmesh_cell, netmesh_check_request,
           netmesh_input_report, netmesh_sizes_report, netmesh_hierarchy_report, netmesh_audit_report,
           netmesh_mesh_report, netmesh_diagram_report, netmesh_bounds_report, netmesh_decision_report,
           netmesh_scales_report, netmesh_vineyard_report, netmesh_complex_report, netmesh_memory_report,
           netmesh_predicates_report, netmesh_report, netmesh_figure, netmesh_bottleneck_request, netmesh_distance,
           netmesh_wasserstein_request, netmesh_wasserstein_distance, netmesh_source, netmesh_split_request,
           netmesh_split_result, netmesh_leaf_request, netmesh_piece, netmesh_join_request, netmesh_piece_info,
           netmesh_collect_request, netmesh_voronoi, netmesh_ball, netmesh_weighted_cell, netmesh_analyse_request,
           netmesh_size_analysis, netmesh_structure_analysis, netmesh_boundary_analysis, netmesh_fatness,
           netmesh_fatness_analysis, netmesh_all_cells_analysis, netmesh_analysis, netmesh_point_arrays,
           netmesh_python_watch]

# Result, arguments.
FUNCTIONS = {
    "netmesh_version": (c_uint32, []),
    "netmesh_version_text": (c_char_p, []),
    "netmesh_status_text": (c_char_p, [c_int]),
    "netmesh_field_text": (c_char_p, [c_int]),
    "netmesh_init": (c_int, [c_void_p, c_size_t, c_void_p]),
    "netmesh_adopt": (c_int, [c_void_p, c_void_p]),
    "netmesh_get_detail": (c_int, [c_void_p, c_void_p]),
    "netmesh_default_request": (netmesh_request, []),
    "netmesh_settle": (c_int, [c_void_p, c_void_p, c_void_p]),
    "netmesh_plan": (c_size_t, [c_void_p]),
    "netmesh_plan_mesh": (c_size_t, [c_void_p]),
    "netmesh_plan_polls": (c_uint64, [c_void_p, c_void_p]),
    "netmesh_plan_mesh_polls": (c_uint64, [c_void_p, c_void_p]),
    "netmesh_persist": (c_int, [c_void_p, c_void_p]),
    "netmesh_mesh": (c_int, [c_void_p, c_void_p]),
    "netmesh_get_option": (c_int, [c_uint32, c_void_p]),
    "netmesh_get_option_word": (c_int, [c_uint32, c_uint32, c_void_p]),
    "netmesh_why_text": (c_char_p, [c_int]),
    "netmesh_get_filter_info": (c_int, [c_uint32, c_void_p]),
    "netmesh_get_pair": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_get_bar_bounds": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_get_scale_step": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_get_cycle": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_get_cycle_simplex": (c_int, [c_void_p, c_uint64, c_uint64, c_void_p]),
    "netmesh_get_vine_point": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_get_vine_ratio": (c_int, [c_void_p, c_uint32, c_void_p]),
    "netmesh_load": (c_int, [c_void_p, c_void_p]),
    "netmesh_load_cages": (c_int, [c_void_p, c_void_p]),
    "netmesh_get_vertex": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_get_cell": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_get_cage": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_get_hidden": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_check": (c_int, [c_void_p, c_void_p]),
    "netmesh_get_report": (c_int, [c_void_p, c_void_p]),
    "netmesh_get_report_figure": (c_int, [c_void_p, c_uint32, c_void_p]),
    "netmesh_default_bottleneck": (netmesh_bottleneck_request, []),
    "netmesh_bottleneck_bytes": (c_size_t, [c_void_p]),
    "netmesh_bottleneck": (c_int, [c_void_p, c_void_p, c_void_p]),
    "netmesh_default_wasserstein": (netmesh_wasserstein_request, []),
    "netmesh_wasserstein_bytes": (c_size_t, [c_void_p]),
    "netmesh_wasserstein": (c_int, [c_void_p, c_void_p, c_void_p]),
    "netmesh_split": (c_int, [c_void_p, c_void_p]),
    "netmesh_get_split": (c_int, [c_void_p, c_void_p]),
    "netmesh_leaf": (c_int, [c_void_p, c_void_p]),
    "netmesh_plan_leaf": (c_size_t, [c_uint32, c_uint64, c_uint32]),
    "netmesh_join": (c_int, [c_void_p, c_void_p]),
    "netmesh_get_piece": (c_int, [c_void_p, c_void_p]),
    "netmesh_read_piece": (c_int, [c_void_p, c_void_p]),
    "netmesh_collect": (c_int, [c_void_p, c_void_p]),
    "netmesh_job_init": (c_int, [c_void_p, c_size_t, c_void_p, c_void_p, c_void_p]),
    "netmesh_resume": (c_int, [c_void_p]),
    "netmesh_cancel": (c_int, [c_void_p]),
    "netmesh_pause": (c_int, [c_void_p]),
    "netmesh_poll_pause": (c_int, [c_void_p, c_void_p]),
    "netmesh_job_ended": (c_int, [c_void_p]),
    "netmesh_stack_used": (c_size_t, [c_void_p]),
    "netmesh_measure_cells": (c_int, [c_void_p, c_void_p, c_void_p]),
    "netmesh_measure_voronoi": (c_int, [c_void_p, c_void_p]),
    "netmesh_measure_balls": (c_int, [c_void_p, c_void_p]),
    "netmesh_weighted_cells": (c_int, [c_void_p, c_void_p]),
    "netmesh_analyse": (c_int, [c_void_p, c_void_p, c_void_p]),
    "netmesh_well_paced_order": (c_int, [c_void_p, c_void_p, c_void_p]),
    "netmesh_pace": (c_int, [c_void_p, c_void_p, c_void_p]),
    "netmesh_get_analysis_figure": (c_int, [c_void_p, c_uint32, c_void_p]),
    "netmesh_array_vertices": (c_int, [c_void_p, c_uint32, c_uint64, c_void_p, c_void_p, c_void_p]),
    "netmesh_array_cells": (c_int, [c_void_p, c_uint32, c_uint64, c_void_p, c_void_p]),
    "netmesh_array_cages": (c_int, [c_void_p, c_uint64, c_void_p, c_void_p, c_void_p]),
    "netmesh_array_pairs": (c_int, [c_void_p, c_uint64, c_void_p, c_void_p]),
    "netmesh_array_bounds": (c_int, [c_void_p, c_uint64, c_void_p, c_void_p]),
    "netmesh_array_steps": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_array_cycle_starts": (c_int, [c_void_p, c_uint64, c_void_p]),
    "netmesh_array_cycle": (c_int, [c_void_p, c_uint64, c_uint32, c_uint64, c_void_p, c_void_p]),
    "netmesh_array_cycle_translations": (c_int, [c_void_p, c_uint64, c_uint32, c_uint64, c_uint32, c_void_p]),
    "netmesh_array_vines": (c_int, [c_void_p, c_uint64, c_void_p, c_void_p, c_void_p, c_void_p]),
    "netmesh_array_source": (c_int, [c_void_p, c_void_p]),
    "netmesh_python_poll": (c_int, [c_void_p, c_void_p]),
}
