#include "arrays.h"

netmesh_status netmesh_array_vertices(const netmesh_context* context, uint32_t dim, uint64_t count, double* coordinates,
                                      uint8_t* markers, double* values) {
    netmesh_vertex item = {0};
    item.struct_bytes = sizeof item;
    for (uint64_t i = 0; i < count; ++i) {
        const netmesh_status status = netmesh_get_vertex(context, i, &item);
        if (status != NETMESH_OK) return status;
        for (uint32_t k = 0; coordinates != NULL && k < dim; ++k) coordinates[i * dim + k] = item.coordinates[k];
        if (markers != NULL) markers[i] = (uint8_t)item.marker;
        if (values != NULL) values[i] = item.value;
    }
    return NETMESH_OK;
}

netmesh_status netmesh_array_cells(const netmesh_context* context, uint32_t dim, uint64_t count, uint32_t* vertices,
                                   uint32_t* neighbours) {
    netmesh_cell item = {0};
    item.struct_bytes = sizeof item;
    for (uint64_t i = 0; i < count; ++i) {
        const netmesh_status status = netmesh_get_cell(context, i, &item);
        if (status != NETMESH_OK) return status;
        for (uint32_t k = 0; vertices != NULL && k <= dim; ++k) vertices[i * (dim + 1) + k] = item.vertices[k];
        for (uint32_t k = 0; neighbours != NULL && k <= dim; ++k) neighbours[i * (dim + 1) + k] = item.neighbours[k];
    }
    return NETMESH_OK;
}

netmesh_status netmesh_array_cages(const netmesh_context* context, uint64_t count, uint32_t* centres, uint32_t* parents,
                                   double* radii) {
    netmesh_cage item = {0};
    item.struct_bytes = sizeof item;
    for (uint64_t i = 0; i < count; ++i) {
        const netmesh_status status = netmesh_get_cage(context, i, &item);
        if (status != NETMESH_OK) return status;
        if (centres != NULL) centres[i] = item.centre;
        if (parents != NULL) parents[i] = item.parent;
        if (radii != NULL) radii[i] = item.radius;
    }
    return NETMESH_OK;
}

netmesh_status netmesh_array_pairs(const netmesh_context* context, uint64_t count, double* intervals,
                                   uint32_t* degrees) {
    netmesh_pair item = {0};
    item.struct_bytes = sizeof item;
    for (uint64_t i = 0; i < count; ++i) {
        const netmesh_status status = netmesh_get_pair(context, i, &item);
        if (status != NETMESH_OK) return status;
        if (intervals != NULL) {
            intervals[2 * i] = item.birth;
            intervals[2 * i + 1] = item.death;
        }
        if (degrees != NULL) degrees[i] = item.degree;
    }
    return NETMESH_OK;
}

netmesh_status netmesh_array_bounds(const netmesh_context* context, uint64_t count, double* intervals,
                                    uint8_t* certain) {
    netmesh_bar_bounds item = {0};
    item.struct_bytes = sizeof item;
    for (uint64_t i = 0; i < count; ++i) {
        const netmesh_status status = netmesh_get_bar_bounds(context, i, &item);
        if (status != NETMESH_OK) return status;
        if (intervals != NULL) {
            intervals[5 * i] = item.birth_low;
            intervals[5 * i + 1] = item.birth_high;
            intervals[5 * i + 2] = item.death_low;
            intervals[5 * i + 3] = item.death_high;
            intervals[5 * i + 4] = item.certain_after;
        }
        if (certain != NULL) certain[i] = (uint8_t)item.certain;
    }
    return NETMESH_OK;
}

netmesh_status netmesh_array_steps(const netmesh_context* context, uint64_t count, double* steps) {
    netmesh_scale_step item = {0};
    item.struct_bytes = sizeof item;
    for (uint64_t i = 0; i < count; ++i) {
        const netmesh_status status = netmesh_get_scale_step(context, i, &item);
        if (status != NETMESH_OK) return status;
        if (steps != NULL) {
            steps[6 * i] = item.from;
            steps[6 * i + 1] = item.low;
            steps[6 * i + 2] = item.high;
            steps[6 * i + 3] = item.reach;
            steps[6 * i + 4] = item.ratio;
            steps[6 * i + 5] = item.error;
        }
    }
    return NETMESH_OK;
}

netmesh_status netmesh_array_cycle_starts(const netmesh_context* context, uint64_t count, uint64_t* starts) {
    starts[0] = 0;
    for (uint64_t i = 0; i < count; ++i) {
        uint64_t simplices = 0;
        const netmesh_status status = netmesh_get_cycle(context, i, &simplices);
        if (status != NETMESH_OK) return status;
        starts[i + 1] = starts[i] + simplices;
    }
    return NETMESH_OK;
}

netmesh_status netmesh_array_cycle(const netmesh_context* context, uint64_t pair, uint32_t degree, uint64_t count,
                                   uint32_t* vertices, double* values) {
    netmesh_simplex item = {0};
    item.struct_bytes = sizeof item;
    for (uint64_t i = 0; i < count; ++i) {
        const netmesh_status status = netmesh_get_cycle_simplex(context, pair, i, &item);
        if (status != NETMESH_OK) return status;
        for (uint32_t k = 0; vertices != NULL && k <= degree; ++k) vertices[i * (degree + 1) + k] = item.vertices[k];
        if (values != NULL) values[i] = item.value;
    }
    return NETMESH_OK;
}

netmesh_status netmesh_array_cycle_translations(const netmesh_context* context, uint64_t pair, uint32_t degree,
                                                uint64_t count, uint32_t axes, int32_t* translations) {
    netmesh_simplex item = {0};
    item.struct_bytes = sizeof item;
    for (uint64_t i = 0; i < count; ++i) {
        const netmesh_status status = netmesh_get_cycle_simplex(context, pair, i, &item);
        if (status != NETMESH_OK) return status;
        for (uint32_t k = 0; translations != NULL && k <= degree; ++k)
            for (uint32_t j = 0; j < axes; ++j)
                translations[(i * (degree + 1) + k) * axes + j] = item.translations[k][j];
    }
    return NETMESH_OK;
}

netmesh_status netmesh_array_vines(const netmesh_context* context, uint64_t count, uint32_t* vines, uint32_t* degrees,
                                   uint32_t* ks, double* intervals) {
    netmesh_vine_point item = {0};
    item.struct_bytes = sizeof item;
    for (uint64_t i = 0; i < count; ++i) {
        const netmesh_status status = netmesh_get_vine_point(context, i, &item);
        if (status != NETMESH_OK) return status;
        if (vines != NULL) vines[i] = item.vine;
        if (degrees != NULL) degrees[i] = item.degree;
        if (ks != NULL) ks[i] = item.k;
        if (intervals != NULL) {
            intervals[2 * i] = item.birth;
            intervals[2 * i + 1] = item.death;
        }
    }
    return NETMESH_OK;
}

static netmesh_status read_points(void* user, uint64_t first, uint32_t count, double* points, uint32_t* rows) {
    const netmesh_point_arrays* const from = user;
    for (uint64_t i = 0; i < (uint64_t)count * from->dim; ++i) points[i] = from->points[first * from->dim + i];
    for (uint32_t i = 0; i < count; ++i) rows[i] = from->rows[first + i];
    return NETMESH_OK;
}

static netmesh_status read_box(void* user, uint32_t node, double* box) {
    const netmesh_point_arrays* const from = user;
    const uint64_t numbers = 2 * (uint64_t)from->dim;
    for (uint64_t i = 0; i < numbers; ++i) box[i] = from->boxes[(node - 1) * numbers + i];
    return NETMESH_OK;
}

netmesh_status netmesh_array_source(netmesh_point_arrays* arrays, netmesh_source* source) {
    source->dim = arrays->dim;
    source->read = read_points;
    source->box = read_box;
    source->user = arrays;
    return NETMESH_OK;
}
