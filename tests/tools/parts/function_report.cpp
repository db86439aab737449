// What JSON says of the filter function: births and deaths are values, off by at most the error, be it 0.
#include <doctest/doctest.h>

#include "tools/report/report.hpp"

using namespace netmesh::tool;

TEST_CASE("report: JSON of the filter function has values for units, and always its error") {
    Options options;
    options.command = Command::persist;
    netmesh_report engine = netmesh::sized<netmesh_report>();
    engine.input.present = engine.mesh.present = engine.diagram.present = 1;
    engine.input.dim = 2;
    RunReport run;
    run.options = &options;
    for (const netmesh_filter_id filter : {NETMESH_FILTER_FUNCTION, NETMESH_FILTER_COMPLETE, NETMESH_FILTER_ALPHA,
                                           NETMESH_FILTER_KDISTANCE, NETMESH_FILTER_SCALES}) {
        CAPTURE(filter);
        const bool is_function = filter == NETMESH_FILTER_FUNCTION;
        engine.diagram.filter = filter;
        for (const double error : {0.0, 0.125}) {
            engine.diagram.certified_error = is_function ? error : 0;
            run.engine = engine;
            const std::string json = json_report(run), due = error == 0 ? "0," : "0.125,";
            CHECK((json.find("\"units\": \"value\"") != std::string::npos) == is_function);
            CHECK((json.find("\"units\": \"radius\"") != std::string::npos) == !is_function);
            CHECK((json.find("\"certified_error\": " + due) != std::string::npos) == is_function);
            CHECK((json.find("certified_error") != std::string::npos) == is_function);
        }
    }
    // A complex with values of its own, and distances.
    engine.diagram.filter = NETMESH_FILTER_NONE;
    engine.input.dim = 0;
    run.engine = engine;
    CHECK(json_report(run).find("\"units\": \"value\"") != std::string::npos);
    options.distances = true;
    CHECK(json_report(run).find("\"units\": \"radius\"") != std::string::npos);
}
