/* What a build of the engine holds. Results of what is in are those of the full build, byte for byte.
 *
 * Every macro may be given on the compiler's command line, or in a copy of this file. CMake has two settings for it:
 *
 *     cmake -DNETMESH_DIMENSIONS="2;3" -DNETMESH_WITHOUT="cages;audits;sizes" ...
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

/* netmesh_mesh makes quality meshes by Sparse Voronoi Refinement (METHOD_SVR). Beside that: */

/* METHOD_HIERARCHY with compact cages */
#ifndef NETMESH_WITH_CAGES
#define NETMESH_WITH_CAGES 1
#endif

/* NETMESH_CAGES_THESIS. Needs CAGES */
#ifndef NETMESH_WITH_THESIS_CAGES
#define NETMESH_WITH_THESIS_CAGES NETMESH_WITH_CAGES
#endif

/* METHOD_REFINE */
#ifndef NETMESH_WITH_REFINE
#define NETMESH_WITH_REFINE 1
#endif

/* netmesh_certificate_goal: meshes refined by the certificate, and filters on their clipped cells; netmesh_fit */
#ifndef NETMESH_WITH_CERTIFICATE
#define NETMESH_WITH_CERTIFICATE 1
#endif

/* Over-refinement: netmesh_sizes, size_at_inputs, PURPOSE_TIGHT */
#ifndef NETMESH_WITH_SIZES
#define NETMESH_WITH_SIZES 1
#endif

/* netmesh_audit_what */
#ifndef NETMESH_WITH_AUDITS
#define NETMESH_WITH_AUDITS 1
#endif

/* Filters of netmesh_persist beside COMPLETE: */

#ifndef NETMESH_WITH_ALPHA
#define NETMESH_WITH_ALPHA 1
#endif

#ifndef NETMESH_WITH_BASIC
#define NETMESH_WITH_BASIC 1
#endif

/* KNN and KDISTANCE with k above 1 */
#ifndef NETMESH_WITH_NEAREST_K
#define NETMESH_WITH_NEAREST_K 1
#endif

/* FUNCTION */
#ifndef NETMESH_WITH_FUNCTION
#define NETMESH_WITH_FUNCTION 1
#endif

#ifndef NETMESH_WITH_TIGHT
#define NETMESH_WITH_TIGHT 1
#endif

#if NETMESH_WITH_THESIS_CAGES && !NETMESH_WITH_CAGES
#error "NETMESH_WITH_THESIS_CAGES needs NETMESH_WITH_CAGES"
#endif

#endif
