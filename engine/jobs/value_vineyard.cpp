#include "jobs/value_vineyard.hpp"

#include "numerics/fingerprint.hpp"
#include "numerics/real.hpp"

namespace netmesh {
namespace {

class ValueSteps {
public:
    ValueSteps(const ValueVineyardRequest& request, const ListedComplex& complex)
        : request_(request), complex_(complex), width_(request.by_vertex ? complex.count[0] : request.list.count) {
        const std::uint32_t top = request.max_degree < complex.dimension ? request.max_degree + 1 : complex.dimension;
        view_.dimension = top;
        for (std::uint32_t k = 0; k <= top; ++k) {
            view_.count[k] = complex.count[k];
            view_.facets[k] = complex.rows[k];
        }
    }
    // The dimensions that the diagrams depend on.
    const ComplexView& view() const { return view_; }

    // Whether each vector is finite and a filtration; what is wrong with the first that is not goes to *out. Adds all
    // values to the fingerprint.
    Status check(const Work& work, ValueVineyard* out) const;

    void load(std::uint32_t step, double* const* value, const Arena& arena) const;

private:
    const double* vector_of(std::uint32_t step) const {
        return request_.values + std::size_t{step - 1} * static_cast<std::size_t>(width_);
    }
    bool is_filtration(std::uint32_t step, SimplexFault* fault, const Arena& arena) const;

    const ValueVineyardRequest& request_;
    const ListedComplex& complex_;
    std::uint64_t width_;
    ComplexView view_ = {};
};

// Of the dimensions in view.
void ValueSteps::load(std::uint32_t step, double* const* value, const Arena& arena) const {
    const double* const vector = vector_of(step);
    if (request_.by_vertex) {
        for (std::uint32_t v = 0; v < complex_.count[0];)
            for (const std::uint64_t piece = arena.piece(v, complex_.count[0], 5); v < piece; ++v) {
                value[0][v] = vector[v] + 0.0;
            }
        raise_to_vertices(view_, value, arena);
        return;
    }
    std::uint32_t filled[ListedComplex::dimension_max + 1] = {};
    for (std::uint64_t i = 0; i < request_.list.count;)
        for (const std::uint64_t piece = arena.piece(i, request_.list.count, 12); i < piece; ++i) {
            const std::uint32_t k = static_cast<std::uint32_t>(request_.list.size(i) - 1);
            if (k <= view_.dimension) value[k][filled[k]++] = vector[i] + 0.0;
        }
}

// Of all dimensions, on the values that the complex has room for.
bool ValueSteps::is_filtration(std::uint32_t step, SimplexFault* fault, const Arena& arena) const {
    const double* const vector = vector_of(step);
    std::uint32_t filled[ListedComplex::dimension_max + 1] = {};
    for (std::uint64_t i = 0; i < request_.list.count;)
        for (const std::uint64_t piece = arena.piece(i, request_.list.count, 12); i < piece; ++i) {
            const std::uint32_t k = static_cast<std::uint32_t>(request_.list.size(i) - 1);
            complex_.value[k][filled[k]++] = vector[i];
        }
    for (std::uint32_t k = 1; k <= complex_.dimension; ++k)
        for (std::size_t i = 0; i < complex_.count[k];)
            for (const std::uint64_t piece = arena.piece(i, complex_.count[k], 8 + 6 * k); i < piece; ++i) {
                for (std::size_t j = 0; j <= k; ++j) {
                    const std::uint32_t facet = complex_.rows[k][i * (k + 1) + j];
                    if (complex_.value[k - 1][facet] <= complex_.value[k][i]) continue;
                    *fault = {NETMESH_FAULT_FACE_LATER, place_of(request_.list, k, static_cast<std::uint32_t>(i)),
                              place_of(request_.list, k - 1, facet)};
                    return false;
                }
            }
    return true;
}

Status ValueSteps::check(const Work& work, ValueVineyard* out) const {
    Fingerprint f;
    f.add(out->input_fingerprint);
    f.add(std::uint64_t{request_.by_vertex});
    work.monitor.begin(NETMESH_STAGE_FILTER, request_.steps);
    for (out->step = 1; out->step <= request_.steps; ++out->step) {
        const double* const vector = vector_of(out->step);
        for (std::uint64_t i = 0; i < width_;)
            for (const std::uint64_t piece = work.arena.piece(i, width_, 15); i < piece; ++i) {
                f.add(vector[i]);
                if (is_finite(vector[i])) continue;
                const std::uint32_t at = static_cast<std::uint32_t>(i);
                out->fault = {NETMESH_FAULT_NONE, request_.by_vertex ? place_of(request_.list, 0, at) : i, 0};
                return Status::not_finite;
            }
        if (!request_.by_vertex && !is_filtration(out->step, &out->fault, work.arena)) return Status::not_a_complex;
        if (work.monitor.advance(out->step, 1)) return Status::cancelled;
    }
    out->step = 0;
    out->input_fingerprint = f.value();
    return Status::ok;
}

}  // namespace

Status value_vineyard(const ValueVineyardRequest& request, const Work& work, ValueVineyard* out) {
    *out = {};
    VineRoom room(work.arena);
    Status status = room.open(request.steps);
    if (status != Status::ok) return status;
    ListedSimplices listed;
    status = list_simplices(request.list, work, &listed);
    out->fault = listed.fault;
    if (status != Status::ok) return status;
    out->input_fingerprint = listed.input_fingerprint;
    ValueSteps steps(request, listed.complex);
    status = steps.check(work, out);
    if (status != Status::ok) return status;
    out->vertices = listed.complex.count[0];
    out->max_degree = request.max_degree < listed.complex.dimension ? request.max_degree : listed.complex.dimension;
    const auto fill = [&](std::uint32_t step, double* const* value, double*) {
        steps.load(step, value, work.arena);
        return Status::ok;
    };
    return room.follow(steps.view(), out->max_degree, 1, fill, work, &out->vines);
}

double value_vineyard_bytes(std::uint64_t count, std::uint64_t vertices, std::uint64_t steps) {
    // Rows, and columns of R and V in blocks of up to twice their lengths, those of V about as long as those of R;
    // values, tables of faces, then what follow_vines says; at most half of the simplices have a bar.
    constexpr double row = sizeof(std::uint32_t) * 9, simplex = sizeof(double) + 84 + 64;
    const double points = static_cast<double>(steps) * static_cast<double>(count) / 2 * sizeof(VinePoint);
    return row * static_cast<double>(vertices) + simplex * static_cast<double>(count) + points +
           sizeof(double) * static_cast<double>(steps);
}

}  // namespace netmesh
