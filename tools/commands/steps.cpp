#include "tools/commands/steps.hpp"

namespace netmesh::tool {

netmesh_status make_mesh(Session& session, const PointCloud& cloud) {
    return session.call(NETMESH_STAGE_REFINE,
                        [&] { return session.engine().mesh(session.watched(session.mesh(), cloud)); });
}

netmesh_status make_triangulation(Session& session, const Options& options, const PointCloud& cloud) {
    return session.call(NETMESH_STAGE_DELAUNAY, [&] {
        return session.engine().delaunay(session.watched(delaunay_request(options, cloud.dim), cloud));
    });
}

netmesh_status prepare_for(Session& session, const Options& options, netmesh_filter filter, const PointCloud& cloud) {
    switch (about(filter).source) {
    case NETMESH_SOURCE_MESH: return make_mesh(session, cloud);
    case NETMESH_SOURCE_DELAUNAY: return make_triangulation(session, options, cloud);
    default: return NETMESH_OK;
    }
}

netmesh_status make_diagram(Session& session, const Options& options, const DiagramRequest& diagram,
                            const PointCloud& cloud) {
    Engine& engine = session.engine();
    const netmesh_source source = about(diagram.choice.filter).source;
    return session.call(NETMESH_STAGE_REDUCE, [&] {
        if (source == NETMESH_SOURCE_SCALES)
            return engine.persist_scales(session.watched(scales_request(options, diagram, cloud.dim), cloud));
        if (source == NETMESH_SOURCE_POINTS)
            return engine.persist_points(session.watched(points_request(options, diagram, cloud.dim), cloud));
        requests::Persist persist = session.watched(persist_request(options, diagram, cloud.dim));
        session.function().set_domain(engine.report());
        persist.function = session.function().get();
        return engine.persist(persist);
    });
}

namespace {

// The best mesh and diagram for the memory, or those that decide the most bars. What was reached is what is checked.
netmesh_status fit(Session& session, const Options& options, const PointCloud& cloud) {
    netmesh_status status = session.call(NETMESH_STAGE_REFINE, [&] {
        return session.engine().fit(session.watched(fit_request(options, cloud.dim), cloud));
    });
    if (status == NETMESH_OK) session.mesh().certificate = session.engine().report().mesh.certificate;
    if (status == NETMESH_OK && !options.representatives.empty()) status = find_cycles(session);
    return status;
}

}  // namespace

netmesh_status persist_as_asked(Session& session, const Options& options, const PointCloud& cloud) {
    if (options.fit || options.focus_auto) return fit(session, options, cloud);
    DiagramRequest diagram{choice_of(options), options.all, false};
    const netmesh_filter_info& filter = about(diagram.choice.filter);
    const bool on_points = is_on_points(filter.filter);
    const bool cycles =
        filter.has_representatives != 0 && (!options.representatives.empty() || (on_points && options.check));
    diagram.cycles = on_points && cycles;
    netmesh_status status = prepare_for(session, options, filter.filter, cloud);
    if (status == NETMESH_OK) status = make_diagram(session, options, diagram, cloud);
    if (status == NETMESH_OK && session.function().has_missed(session.engine().report())) {
        status = make_mesh(session, cloud);
        if (status == NETMESH_OK) status = make_diagram(session, options, diagram, cloud);
    }
    if (status == NETMESH_OK && options.bounds) status = bound_bars(session);
    if (status == NETMESH_OK && !on_points && cycles) status = find_cycles(session);
    return status;
}

netmesh_status make_vineyard(Session& session, const requests::Vineyard& request, Vines* vines) {
    const netmesh_status status =
        session.call(NETMESH_STAGE_REDUCE, [&] { return session.engine().vineyard(session.watched(request)); });
    if (status == NETMESH_OK) *vines = vines_of(session.engine());
    return status;
}

netmesh_status bound_bars(Session& session) {
    return session.call(NETMESH_STAGE_CERTIFY,
                        [&] { return session.engine().bound_bars(session.watched(requests::Bounds())); });
}

netmesh_status find_cycles(Session& session) {
    return session.call(NETMESH_STAGE_REDUCE,
                        [&] { return session.engine().represent(session.watched(requests::Represent())); });
}

netmesh_status check_everything(Session& session) {
    return session.call(NETMESH_STAGE_CHECK, [&] {
        requests::Check check;
        check.mesh = &session.mesh();
        return session.engine().check(session.watched(check));
    });
}

}  // namespace netmesh::tool
