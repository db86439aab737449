// Vineyards of a complex and of vectors of values, both from files.
#pragma once
#include <string>

#include "tools/io/complex_file.hpp"
#include "tools/io/vine_file.hpp"
#include "tools/options.hpp"
#include "tools/outcome.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

struct ValueInput {
    SimplexFile complex;
    ValueFile values;
};

// Exit::usage for options that do not go with values of the user's, Exit::data for what is wrong with the files.
Outcome read_value_input(const Options& options, const std::string& complex_path, ValueInput* input);

// The vineyard, which the session's engine then holds.
Outcome make_value_vineyard(const Options& options, const ValueInput& input, Session& session, Vines* vines);

// Each diagram by itself, by the engine's other algorithm: empty, or at which step it differs. Replaces the vineyard.
Outcome check_value_vineyard(const Options& options, const ValueInput& input, const Vines& vines, Session& session,
                             std::string* fault);

// Names the simplex that has no place in the complex and what it lacks; `values`: at which the simplices enter.
Outcome explain_fault(const SimplexFile& file, const double* values, const netmesh_detail& detail);

}  // namespace netmesh::tool
