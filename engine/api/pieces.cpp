// Alpha diagrams in pieces.
#include "api/call.hpp"
#include "api/plan.hpp"
#include "api/settle.hpp"
#include "pieces/collect.hpp"
#include "pieces/join.hpp"
#include "pieces/leaf.hpp"
#include "pieces/split.hpp"

namespace netmesh {
namespace {

bool is_power(std::uint32_t pieces) { return pieces != 0 && (pieces & (pieces - 1)) == 0; }
constexpr char not_a_power[] = "pieces is not a power of 2";

// Flags and numbers of a source; its struct has been read.
Complaint complaint_about_source(const netmesh_source& source) {
    const Complaint dim = complaint_about_dim(source.dim);
    if (dim.text != nullptr) return dim;
    if (source.read == nullptr || source.box == nullptr) return {NETMESH_FIELD_SOURCE, "a function of source is null"};
    if (source.count == 0) return {NETMESH_FIELD_POINT_COUNT, "there are no points"};
    if (source.count > NETMESH_PIECES_POINTS_MAX) return {NETMESH_FIELD_POINT_COUNT, "more than 2^31 - 1 points"};
    const auto last = static_cast<std::uint32_t>(source.count - 1);
    if (source.levels > 30 || last >> source.levels >= piece_points_most || 1u << source.levels > source.count)
        return {NETMESH_FIELD_SOURCE, "source.levels do not go with source.count"};
    if (source.rows < source.count) return {NETMESH_FIELD_POINT_COUNT, "source.rows are fewer than its points"};
    return {};
}

Complaint complaint_about_leaf(const netmesh_leaf_request& r, netmesh_source* source) {
    if (r.source == nullptr) return {NETMESH_FIELD_SOURCE, "source is null"};
    const netmesh_field fault = read_struct(r.source, source, sizeof *source);
    if (fault != NETMESH_FIELD_NONE) return complaint_about_struct(fault);
    const Complaint complaint = complaint_about_source(*source);
    if (complaint.text != nullptr) return complaint;
    if (!is_power(r.pieces)) return {NETMESH_FIELD_PIECES, not_a_power};
    if (depth_of(r.pieces) > source->levels)
        return {NETMESH_FIELD_PIECES, "more pieces than the points were split for"};
    if (r.node < r.pieces || r.node - r.pieces >= r.pieces)
        return {NETMESH_FIELD_NODE, "node is not one of pieces .. 2 pieces - 1"};
    if (r.reserved != 0 || source->reserved != 0)
        return {NETMESH_FIELD_STRUCT_BYTES, "reserved is not 0: the struct was not cleared"};
    if (r.keep_zero_pairs > 1) return {NETMESH_FIELD_KEEP_ZERO_PAIRS, "keep_zero_pairs is not 0 or 1"};
    return {};
}

// Ends a call that leaves a piece or nothing.
netmesh_status keep_piece(netmesh_context* context, Status status, const PieceBytes& bytes, const char* text,
                          std::uint64_t at) {
    if (status != Status::ok) return fail_and_clear(context, status, text, at);
    context->piece = Slice<unsigned char>::of(context->arena, bytes.first, bytes.count);
    return finish(context, Status::ok);
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_split(netmesh_context* context, const netmesh_split_request* request) {
    netmesh_split_request r;
    const netmesh_status begun = begin(context, request, &r);
    if (begun != NETMESH_OK) return begun;
    Complaint complaint = complaint_about_dim(r.points.dim);
    if (complaint.text == nullptr) complaint = complaint_about_rows(r.points);
    if (complaint.text == nullptr) complaint = complaint_about_coordinates(r.points);
    if (complaint.text == nullptr && (r.points.lattice != nullptr || r.points.lattice_count != 0))
        complaint = {NETMESH_FIELD_LATTICE, "there are no pieces with periods yet; leave them out"};
    if (complaint.text == nullptr && (r.points.weights != nullptr || r.points.weight_stride_bytes != 0))
        complaint = {NETMESH_FIELD_WEIGHTS, "there are no pieces with weights yet; leave them out"};
    if (r.pieces == 0) r.pieces = 1;
    if (complaint.text == nullptr && !is_power(r.pieces)) complaint = {NETMESH_FIELD_PIECES, not_a_power};
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    SplitPoints made;
    const Status status =
        watch.heed(split_points(rows_of(r.points), static_cast<std::uint32_t>(r.points.count),
                                static_cast<int>(r.points.dim), r.pieces, {context->arena, monitor}, &made));
    if (status == Status::invalid_argument) {
        clear(context);
        return refuse(context, NETMESH_FIELD_PIECES, "more pieces than there are different points");
    }
    if (status != Status::ok) return fail_and_clear(context, status, nullptr, made.culprit);
    context->input = {true,      true, r.points.dim, r.points.count, r.points.count - made.count, made.fingerprint,
                      made.count};
    const std::uint64_t boxes = (std::uint64_t{2} << made.levels) - 1;
    context->split = {true, made.levels, Slice<std::uint32_t>::of(context->arena, made.order, made.count),
                      Slice<double>::of(context->arena, made.boxes, boxes * 2 * r.points.dim)};
    return finish(context, Status::ok);
}

netmesh_status netmesh_get_split(const netmesh_context* context, netmesh_split_result* result) {
    if (!usable(context) || !has_room(result)) return NETMESH_INVALID_ARGUMENT;
    if (!context->split.present) return NETMESH_NO_RESULT;
    netmesh_split_result found = {};
    found.dim = context->input.dim;
    found.count = context->split.order.count;
    found.rows = context->input.points;
    found.fingerprint = context->input.fingerprint;
    found.order = context->split.order.in(context);
    found.boxes = context->split.boxes.in(context);
    found.levels = context->split.levels;
    found.box_count = context->split.boxes.count / (2 * std::uint64_t{found.dim});
    write_struct(&found, sizeof found, result);
    return NETMESH_OK;
}

netmesh_status netmesh_leaf(netmesh_context* context, const netmesh_leaf_request* request) {
    netmesh_leaf_request r;
    const netmesh_status begun = begin(context, request, &r);
    if (begun != NETMESH_OK) return begun;
    LeafRequest wanted = {};
    const Complaint complaint = complaint_about_leaf(r, &wanted.source.from);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    wanted.pieces = r.pieces;
    wanted.node = r.node;
    wanted.diagram = {r.max_degree, r.keep_zero_pairs != 0};
    PieceBytes made = {};
    StarsReport stars = {};
    const Status status = watch.heed(make_leaf(wanted, {context->arena, monitor}, &made, &stars));
    return keep_piece(context, status, made, nullptr, 0);
}

size_t netmesh_plan_leaf(uint32_t dim, uint64_t points, uint32_t pieces) {
    if (complaint_about_dim(dim).text != nullptr || !is_power(pieces) || points < pieces) return 0;
    return whole_bytes(plan_of_leaf(dim, points, pieces));
}

netmesh_status netmesh_join(netmesh_context* context, const netmesh_join_request* request) {
    netmesh_join_request r;
    const netmesh_status begun = begin(context, request, &r);
    if (begun != NETMESH_OK) return begun;
    if (!is_piece_aligned(r.one)) return refuse(context, NETMESH_FIELD_ONE, piece_not_aligned);
    if (!is_piece_aligned(r.other)) return refuse(context, NETMESH_FIELD_OTHER, piece_not_aligned);
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    PieceBytes made = {};
    const char* fault = nullptr;
    int at = 0;
    const Status status = watch.heed(join_pieces(r.one, r.other, {context->arena, monitor}, &made, &fault, &at));
    if (fault == nullptr) return keep_piece(context, status, made, nullptr, 0);
    clear(context);
    return refuse(context, at == 0 ? NETMESH_FIELD_ONE : NETMESH_FIELD_OTHER, fault);
}

netmesh_status netmesh_get_piece(const netmesh_context* context, netmesh_piece* piece) {
    if (!usable(context) || piece == nullptr) return NETMESH_INVALID_ARGUMENT;
    if (context->piece.count == 0) return NETMESH_NO_RESULT;
    *piece = {context->piece.in(context), static_cast<std::size_t>(context->piece.count)};
    return NETMESH_OK;
}

netmesh_status netmesh_read_piece(const netmesh_piece* piece, netmesh_piece_info* info) {
    if (piece == nullptr || !is_piece_aligned(*piece) || !has_room(info)) return NETMESH_INVALID_ARGUMENT;
    Piece read;
    netmesh_piece_info found = {};
    PieceSize size = {};
    found.look_at_all = info->look_at_all;
    found.fault = read_piece_head(piece->bytes, piece->count, &read, &size);
    if (found.fault == nullptr && found.look_at_all != 0) found.fault = check_piece_body(piece->bytes, piece->count);
    if (found.fault == nullptr) {
        const PieceJob& job = read.job;
        found.node = read.node;
        found.pieces = job.pieces;
        found.dim = job.dim;
        found.max_degree = job.max_degree;
        found.keep_zero_pairs = job.keep_zero;
        found.points = job.points;
        found.rows = job.rows;
        found.fingerprint = job.fingerprint;
        found.simplices = read.simplices;
        found.bytes = size.whole;
        found.head_bytes = size.head;
        found.join_bytes = size.whole / 2 * 5 + 16384;  // joins of uniform points take 1.4 to 2.3 times their pieces
        found.bars = read.bar_count;
    }
    write_struct(&found, sizeof found, info);
    return found.fault == nullptr ? NETMESH_OK : NETMESH_CHECK_FAILED;
}

netmesh_status netmesh_collect(netmesh_context* context, const netmesh_collect_request* request) {
    netmesh_collect_request r;
    const netmesh_status begun = begin(context, request, &r);
    if (begun != NETMESH_OK) return begun;
    if ((r.pieces == nullptr && r.open == nullptr) || r.count == 0)
        return refuse(context, NETMESH_FIELD_PIECES, "there are no pieces");
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    PieceJob job = {};
    CountedPairs made = {};
    const char* fault = nullptr;
    std::size_t at = 0;
    const Status status = watch.heed(collect_pieces(r, {context->arena, monitor}, &job, &made, &fault, &at));
    if (fault != nullptr) {
        clear(context);
        return refuse(context, {NETMESH_FIELD_PIECES, fault}, at);
    }
    if (status != Status::ok) return fail_and_clear(context, status, nullptr, at);
    context->complete = true;
    context->input = {
        true, true, job.dim, job.rows, job.rows - job.points, job.fingerprint, static_cast<std::uint32_t>(job.points)};
    KeptDiagram& diagram = context->diagram;
    diagram.present = true;
    diagram.filter = NETMESH_FILTER_ALPHA;
    diagram.keeps_zero = job.keep_zero != 0;
    diagram.max_degree = job.max_degree;
    diagram.pairs = Slice<Pair>::of(context->arena, made.pairs.pairs, made.pairs.count);
    diagram.is_short = true;
    diagram.simplices = made.simplices;
    diagram.certified_ratio = diagram.certified_ratio_best = 1;
    return finish(context, Status::ok);
}

}  // extern "C"
