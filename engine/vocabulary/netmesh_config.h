/* What a build of the engine holds. Results of what is in are those of the full build, byte for byte.
 *
 * Every macro may be given on the compiler's command line, or in a copy of this file. CMake has two settings for it:
 *
 *     cmake -DNETMESH_DIMENSIONS="2;3" -DNETMESH_WITHOUT="audits;sizes" ...
 *
 * A part that is left out answers with NETMESH_NOT_BUILT and a message that names its macro. Whole calls that a program
 * does not make need no switch where its linker drops unused sections (-Wl,--gc-sections), as CMake's archive lets it;
 * tools/docs/small-parts.md has a table of what each job takes. */
#ifndef NETMESH_CONFIG_DEFAULTS_H
#define NETMESH_CONFIG_DEFAULTS_H

/* Dimensions: any of 2 to 6. Requests of others answer NETMESH_NOT_BUILT. */
#ifndef NETMESH_EACH_DIMENSION
#define NETMESH_EACH_DIMENSION(DO) DO(2) DO(3) DO(4) DO(5) DO(6)
#endif

/* Filters, methods of meshing and wants are objects that a program holds when it names them; no switch is needed. These
 * three cut code out of the middle of what is linked: */

/* The method certificate, and filters on its clipped cells; fit */
#ifndef NETMESH_WITH_CERTIFICATE
#define NETMESH_WITH_CERTIFICATE 1
#endif

/* Over-refinement: netmesh_sizes, goal.eps, goal.error */
#ifndef NETMESH_WITH_SIZES
#define NETMESH_WITH_SIZES 1
#endif

/* netmesh_audit_what */
#ifndef NETMESH_WITH_AUDITS
#define NETMESH_WITH_AUDITS 1
#endif

#endif
