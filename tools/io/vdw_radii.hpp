// Van der Waals radii of elements.
#pragma once
#include <string_view>

namespace netmesh::tool {

// In angstroms, of the elements of the main groups: table 12 of M. Mantina, A. C. Chamberlin, R. Valero, C. J. Cramer,
// D. G. Truhlar, Consistent van der Waals radii for the whole main group, J. Phys. Chem. A 113 (2009), 5806-5812, which
// has Bondi's (1964) and, of hydrogen, Rowland and Taylor's (1996). By symbol, in upper or lower case, perhaps with a
// number behind it (C, Fe1), or by atomic number. 0: none is known.
double van_der_waals_radius(std::string_view element);

}  // namespace netmesh::tool
