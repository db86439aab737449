#include "tools/asked_function.hpp"

#include <algorithm>
#include <cmath>

#include "tools/commands/output.hpp"
#include "tools/io/numbers.hpp"
#include "tools/vertex_function.hpp"

namespace netmesh::tool {

AskedFunction::AskedFunction(const Options& options)
    : options_(options), function_(sized<netmesh_function>()),
      is_asked_(filter_of(options) == NETMESH_FILTER_FUNCTION && (options.function || options.vertex_function)) {
    if (!is_asked_) return;
    function_.evaluate = evaluate;
    function_.user = this;
    function_.lipschitz = options.lipschitz.value_or(0);
    function_.cut = options.cut.value_or(0);
    cut_ = function_;
    cut_.evaluate = [](void* self, const double*) { return static_cast<const AskedFunction*>(self)->function_.cut; };
}

void AskedFunction::set_domain(const netmesh_report& report) {
    domain_.assign(report.mesh.domain, report.mesh.domain + report.input.dim + 1);
}

bool AskedFunction::has_missed(const netmesh_report& report) {
    const double error = options_.request.goal.error;
    if (!is_asked_ || is_even_ || error == 0) return false;
    const double reached = report.diagram.certified_error;
    return is_even_ = reached > error && std::isfinite(reached);
}

namespace {

// How far a point is inside of the domain; negative: outside.
double depth(const std::vector<double>& domain, const double* x) {
    double away2 = 0;
    for (std::size_t k = 0; k + 1 < domain.size(); k++) away2 += (x[k] - domain[k]) * (x[k] - domain[k]);
    return domain.empty() ? 0 : domain.back() - std::sqrt(away2);
}

}  // namespace

double AskedFunction::evaluate(void* self, const double* x) {
    const AskedFunction& asked = *static_cast<const AskedFunction*>(self);
    const double f = function_at(asked.options_, x);
    return std::isfinite(f) && depth(asked.domain_, x) < 0 ? asked.function_.cut : f;
}

double function_at(const Options& options, const double* x) {
    return options.vertex_function ? (*options.vertex_function)(x) : (*options.function)(x);
}

Outcome check_function(const Options& options) {
    const bool is_it = filter_of(options) == NETMESH_FILTER_FUNCTION, has_values = !options.values_at.empty();
    const bool has_error = options.request.goal.error > 0;
    if (!is_it && (options.function || has_values || options.lipschitz || options.cut || has_error))
        return usage_error("--function, --values-at, --lipschitz, --cut and --error go with --filter function");
    if (is_it && options.function && has_values)
        return usage_error("--function and --values-at both say what the function is");
    const bool is_whole = (options.function || has_values) && options.lipschitz && options.cut;
    const bool is_read = options.command == Command::persist || options.command == Command::check;
    if (is_it && is_read && !is_whole)
        return usage_error("--filter function needs --function or --values-at, --lipschitz and --cut");
    return {};
}

Outcome check_coordinates(const Options& options, std::uint32_t dim) {
    if (!options.function || options.function->coordinates() <= dim) return {};
    return usage_error("--function " + options.function->text() + ": column " +
                       std::to_string(options.function->coordinate_column()) + ": coordinate " +
                       std::to_string(options.function->coordinates()) + " of points in " +
                       counted(dim, "dimension", "dimensions"));
}

namespace {

// What evaluating an expression may be off by, as a share.
constexpr double doubt = 1e-9;

class Claims {
public:
    Claims(const Options& options, const Engine& engine) : options_(options), mesh_(engine), report_(engine.report()) {
        domain_.assign(report_.mesh.domain, report_.mesh.domain + report_.input.dim + 1);
        for (std::uint64_t v = 0; v < report_.mesh.vertices; v++) {
            const netmesh_vertex vertex = mesh_.vertex(v);
            points_.emplace_back(vertex.coordinates, vertex.coordinates + report_.input.dim);
            depths_.push_back(depth(domain_, vertex.coordinates));
            // What was read of vertices outside is not asked for.
            const bool is_out = options.vertex_function && depths_.back() < 0;
            values_.push_back(is_out ? *options.cut : function_at(options, vertex.coordinates));
        }
    }
    Outcome check_edges() const {
        const std::uint32_t corners = report_.input.dim + 1;
        for (std::uint64_t c = 0; c < report_.mesh.cells; c++) {
            const netmesh_cell cell = mesh_.cell(c);
            for (std::uint32_t i = 0; i < corners; i++)
                for (std::uint32_t j = 0; j < i; j++) {
                    const Outcome outcome = check_edge(cell.vertices[j], cell.vertices[i]);
                    if (!outcome.good()) return outcome;
                }
        }
        return {};
    }
    Outcome check_vertices() const {
        const double cut = *options_.cut, lipschitz = *options_.lipschitz, radius = domain_.back();
        for (std::size_t v = 0; v < values_.size(); v++) {
            const double inside = depths_[v];
            if (!(values_[v] < cut - lipschitz * std::max(0.0, inside) - doubt * (std::fabs(cut) + lipschitz * radius)))
                continue;
            const std::string at = "the function is " + rounded_text(values_[v], 6) + " at " + place(v) + ", ";
            if (inside < 0)
                return usage_error("--cut " + number_text(cut) + ": " + at +
                                   "outside of the domain, where it must be at least the cut" + domain_text());
            return usage_error("--cut " + number_text(cut) + ", --lipschitz " + number_text(lipschitz) + ": " + at +
                               rounded_text(inside, 6) + " from the domain's sphere, where it then is below the cut" +
                               domain_text());
        }
        return {};
    }

private:
    Outcome check_edge(std::uint64_t v, std::uint64_t w) const {
        if (depths_[v] < 0 || depths_[w] < 0) return {};
        const std::vector<double>&p = points_[v], &q = points_[w];
        double length2 = 0;
        for (std::size_t k = 0; k < p.size(); k++) length2 += (p[k] - q[k]) * (p[k] - q[k]);
        const double length = std::sqrt(length2), change = std::fabs(values_[v] - values_[w]);
        const double lipschitz = *options_.lipschitz;
        if (!(change > lipschitz * length + doubt * (std::fabs(values_[v]) + std::fabs(values_[w])))) return {};
        return usage_error("--lipschitz " + number_text(lipschitz) + ": the function changes by " +
                           rounded_text(change, 6) + " from " + place(v) + " to " + place(w) + ", at least " +
                           rounded_text(change / length, 6) + " a unit of length");
    }
    std::string domain_text() const {
        const std::vector<double> centre(domain_.begin(), domain_.end() - 1);
        return "; the domain is the ball of radius " + rounded_text(domain_.back(), 6) + " about " + place_text(centre);
    }
    // Values that were read have lines.
    std::string place(std::size_t v) const {
        return place_text(points_[v]) +
               (options_.vertex_function ? " (" + options_.vertex_function->where(v) + ")" : "");
    }
    static std::string place_text(const std::vector<double>& place) {
        std::string text;
        for (const double x : place) text += (text.empty() ? "(" : ", ") + rounded_text(x, 6);
        return text + ")";
    }

    const Options& options_;
    EngineMesh mesh_;
    netmesh_report report_;
    std::vector<std::vector<double>> points_;
    std::vector<double> domain_, values_, depths_;
};

}  // namespace

Outcome check_claims(const Options& options, const Engine& engine) {
    if (filter_of(options) != NETMESH_FILTER_FUNCTION) return {};
    const Claims claims(options, engine);
    const Outcome outcome = claims.check_vertices();
    return outcome.good() ? claims.check_edges() : outcome;
}

}  // namespace netmesh::tool
