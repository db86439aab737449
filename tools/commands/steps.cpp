#include "tools/commands/steps.hpp"

#include "tools/commands/check_parts.hpp"

namespace netmesh::tool {

netmesh_status make_mesh(Session& session, const PointCloud& cloud) {
    netmesh_request request = session.watched(on_points(session.request(), cloud));
    request.function = session.function().for_sizes();
    request.fit = nullptr;  // a mesh to begin with, whatever the block
    const bool triangulates = request.mesh.method == &netmesh_method_delaunay;
    return session.call(triangulates ? NETMESH_STAGE_DELAUNAY : NETMESH_STAGE_REFINE,
                        [&] { return session.engine().mesh(request); });
}

netmesh_status persist(Session& session, netmesh_request request) {
    request.function = session.function().get();
    return session.call(NETMESH_STAGE_REDUCE, [&] { return session.engine().persist(session.watched(request)); });
}

namespace {

// What a filter needs of a mesh that is read: that it is a Delaunay triangulation.
netmesh_status take_mesh(Session& session, const MeshFiles& mesh) {
    const netmesh_status status = load_mesh(session, mesh);
    if (status != NETMESH_OK) return status;
    return session.call(NETMESH_STAGE_CHECK, [&] {
        netmesh_check_request check = sized<netmesh_check_request>();
        check.what = NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY;
        return session.engine().check(session.watched(check));
    });
}

// A function has to know the domain, which is that of any mesh of the points, before it is asked for its values.
netmesh_status persist_function(Session& session, const PointCloud& cloud) {
    const netmesh_request& request = session.request();
    netmesh_status status;
    do {
        status = make_mesh(session, cloud);
        if (status != NETMESH_OK) return status;
        session.function().set_domain(session.report());
        status = persist(session, request.fit != nullptr ? on_points(request, cloud) : on_what_is_there(request));
    } while (status == NETMESH_OK && session.function().has_missed(session.report()));
    return status;
}

netmesh_status persist_what_is_there(Session& session) {
    session.function().set_domain(session.report());
    return persist(session, on_what_is_there(session.request()));
}

}  // namespace

netmesh_status persist_as_asked(Session& session, const PointCloud& cloud, const MeshFiles* mesh) {
    netmesh_status status = mesh != nullptr ? take_mesh(session, *mesh) : NETMESH_OK;
    if (status != NETMESH_OK) return status;
    status = mesh != nullptr                       ? persist_what_is_there(session)
             : session.function().get() != nullptr ? persist_function(session, cloud)
                                                   : persist(session, on_points(session.request(), cloud));
    if (status != NETMESH_OK || mesh != nullptr) return status;
    const netmesh_report& report = session.report();
    netmesh_request made = promised(session.request());
    if (made.filter == &netmesh_filter_auto) made.filter = about(report.diagram.filter).filter;
    if (session.request().fit != nullptr) made.goal.error = report.diagram.fitted_error;
    made.goal.ratio = report.mesh.goal.ratio;
    made.goal.focus_ratio = report.mesh.goal.focus_ratio;
    made.goal.focus_from = report.mesh.goal.focus_from;
    made.goal.focus_to = report.mesh.goal.focus_to;
    session.set_promise(made);
    return status;
}

netmesh_status check_everything(Session& session) {
    const netmesh_request promise = session.promise();
    netmesh_check_request check = session.watched(sized<netmesh_check_request>());
    check.promised = &promise;
    // A regular triangulation is not Delaunay.
    if (session.request().weighting != nullptr) check.what = NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC;
    return session.call(NETMESH_STAGE_CHECK, [&] { return session.engine().check(check); });
}

}  // namespace netmesh::tool
