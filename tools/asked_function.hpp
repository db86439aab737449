// The function of --function or --values-at, --lipschitz and --cut as the library takes it, and what can be seen of
// whether it is as these say.
#pragma once
#include <vector>

#include "netmesh.hpp"
#include "tools/options.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

class AskedFunction {
public:
    explicit AskedFunction(const Options& options);  // which must outlive it
    AskedFunction(const AskedFunction&) = delete;
    AskedFunction& operator=(const AskedFunction&) = delete;

    // Null where none is asked for.
    const netmesh_function* get() const { return is_asked_ ? &function_ : nullptr; }
    // What an error asks of the sizes of a mesh goes by.
    const netmesh_function* for_sizes() const { return is_even_ ? &cut_ : get(); }
    // The domain of the mesh whose diagram is next. Outside of it the function counts as the cut: so the expression has
    // to have its Lipschitz constant in the domain alone.
    void set_domain(const netmesh_report& report);
    // Sizes larger than --error needs were asked for where the expression is above the cut; outside of the domain that
    // may be too large. True when the mesh missed the error and smaller ones are asked for from now on.
    bool has_missed(const netmesh_report& report);

private:
    static double evaluate(void* self, const double* x);

    const Options& options_;
    netmesh_function function_;
    netmesh_function cut_;        // as if the function were the cut
    std::vector<double> domain_;  // centre, radius
    bool is_asked_, is_even_ = false;
};

// At x, by the expression or by the values at vertices.
double function_at(const Options& options, const double* x);

// Whether --function, --values-at, --lipschitz and --cut say a function together; and in `dim` dimensions.
Outcome check_function(const Options& options);
Outcome check_coordinates(const Options& options, std::uint32_t dim);

// Exit::usage where vertices of the mesh that the engine holds show that the function is not as --lipschitz and --cut
// say: two in the domain that are joined by an edge and too far apart in value, one outside of the domain below the
// cut, one inside so far below it that the sphere cannot be at the cut. More than the vertices cannot be seen.
Outcome check_claims(const Options& options, const Engine& engine);

}  // namespace netmesh::tool
