#include "tools/commands/steps.hpp"

#include "tools/commands/check_parts.hpp"

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
        persist.function = session.function().get();
        if (persist.function != nullptr) session.function().set_domain(engine.report());
        return engine.persist(persist);
    });
}

namespace {

// The best mesh and diagram for the memory, or those that decide the most bars. What was reached is what is checked. A
// function has to know the domain, which is that of any mesh of the points.
netmesh_status fit(Session& session, const Options& options, const PointCloud& cloud) {
    requests::Fit request = session.watched(fit_request(options, cloud.dim), cloud);
    request.function = session.function().get();
    netmesh_status status = NETMESH_OK;
    if (request.function != nullptr) {
        status = make_mesh(session, cloud);
        session.function().set_domain(session.engine().report());
    }
    if (status == NETMESH_OK)
        status = session.call(NETMESH_STAGE_REFINE, [&] { return session.engine().fit(request); });
    if (status == NETMESH_OK && request.function != nullptr) {
        session.function().set_error(session.engine().report().diagram.fitted_error);
        session.function().set_sizes(&session.mesh());
    }
    if (status == NETMESH_OK) session.mesh().certificate = session.engine().report().mesh.certificate;
    if (status == NETMESH_OK && !options.representatives.empty()) status = find_cycles(session);
    return status;
}

// Mesh or triangulation and diagram of the filter that the engine takes. What a mesh was made to is what is checked.
netmesh_status persist_auto(Session& session, const Options& options, const PointCloud& cloud) {
    const netmesh_status status = session.call(NETMESH_STAGE_REDUCE, [&] {
        return session.engine().persist_auto(session.watched(auto_request(options, cloud.dim), cloud));
    });
    if (status == NETMESH_OK) session.mesh().certificate = session.engine().report().mesh.certificate;
    return status;
}

// What a filter needs of a mesh that is read: that it is a Delaunay triangulation.
netmesh_status take_mesh(Session& session, const MeshFiles& mesh) {
    const netmesh_status status = load_mesh(session, mesh);
    if (status != NETMESH_OK) return status;
    return session.call(NETMESH_STAGE_CHECK, [&] {
        requests::Check check;
        check.what = NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY;
        check.mesh = &session.mesh();
        return session.engine().check(session.watched(check));
    });
}

}  // namespace

netmesh_status persist_as_asked(Session& session, const Options& options, const PointCloud& cloud,
                                const MeshFiles* mesh) {
    if (options.fit || options.focus_auto) return fit(session, options, cloud);
    DiagramRequest diagram{choice_of(options), options.all, false};
    const netmesh_filter_info& filter = about(diagram.choice.filter);
    const bool at_once = is_on_points(filter.filter) || filter.source == NETMESH_SOURCE_SCALES;
    const bool cycles =
        filter.has_representatives != 0 && (!options.representatives.empty() || (at_once && options.check));
    diagram.cycles = at_once && cycles;
    if (!options.auto_filter && filter.source == NETMESH_SOURCE_DELAUNAY && wants_diagram_alone(options)) {
        const netmesh_status status = session.call(NETMESH_STAGE_REDUCE, [&] {
            return session.engine().persist_alpha(session.watched(alpha_request(options, cloud.dim), cloud));
        });
        return status == NETMESH_OK && options.bounds ? bound_bars(session) : status;
    }
    netmesh_status status = options.auto_filter ? persist_auto(session, options, cloud)
                            : mesh != nullptr   ? take_mesh(session, *mesh)
                                                : prepare_for(session, options, filter.filter, cloud);
    if (status == NETMESH_OK && !options.auto_filter) status = make_diagram(session, options, diagram, cloud);
    const bool has_function = session.function().get() != nullptr;
    if (status == NETMESH_OK && has_function && session.function().has_missed(session.engine().report())) {
        status = make_mesh(session, cloud);
        if (status == NETMESH_OK) status = make_diagram(session, options, diagram, cloud);
    }
    if (status == NETMESH_OK && options.bounds) status = bound_bars(session);
    if (status == NETMESH_OK && !at_once && cycles) status = find_cycles(session);
    return status;
}

netmesh_status make_vineyard(Session& session, const VineyardRequest& vineyard, const PointCloud& cloud, Vines* vines) {
    Engine& engine = session.engine();
    const netmesh_status status = session.call(NETMESH_STAGE_REDUCE, [&] {
        if (!is_on_points(vineyard.choice.filter)) return engine.vineyard(session.watched(vineyard_request(vineyard)));
        return engine.points_vineyard(session.watched(points_vineyard_request(vineyard, cloud.dim), cloud));
    });
    if (status == NETMESH_OK) *vines = vines_of(session.engine());
    return status;
}

netmesh_status bound_bars(Session& session) {
    return session.call(NETMESH_STAGE_CERTIFY, [&] {
        requests::Bounds bounds = session.watched(requests::Bounds());
        bounds.function = session.function().get();
        return session.engine().bound_bars(bounds);
    });
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
