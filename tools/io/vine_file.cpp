#include "tools/io/vine_file.hpp"

#include "tools/options.hpp"

namespace netmesh::tool {

Vines vines_of(const netmesh_context* context) {
    Vines vines;
    netmesh_report report = {};
    report.struct_bytes = sizeof report;
    netmesh_get_report(context, &report);
    vines.k_first = report.k_first;
    double ratio;
    for (std::uint32_t k = report.k_first; netmesh_get_vine_ratio(context, k, &ratio) == NETMESH_OK; k++) {
        vines.ratios.push_back(ratio);
    }
    netmesh_vine_point point;
    for (std::uint64_t i = 0; netmesh_get_vine_point(context, i, &point) == NETMESH_OK; i++) {
        vines.points.push_back(point);
    }
    return vines;
}

void write_vines(const Vines& vines, const netmesh_report& report, TextWriter& out) {
    out << "# netmesh vineyard 1: vine degree k birth death\n# filter " << filter_name(report.filter) << ", "
        << values_name(report.values) << " values\n";
    for (std::size_t i = 0; i < vines.ratios.size(); i++) {
        out << "# k " << static_cast<std::uint64_t>(vines.k_first + i) << " certified ratio " << vines.ratios[i] << '\n';
    }
    for (const netmesh_vine_point& p : vines.points) {
        out << p.vine << ' ' << p.degree << ' ' << p.k << ' ' << p.birth << ' ' << p.death << '\n';
    }
}

}  // namespace netmesh::tool
