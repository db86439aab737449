# cpack -G DEB: two Debian packages. `netmesh` is the tool, which needs the C++ library of the system;
# `libnetmesh-dev` is the archive, the headers and what find_package and pkg-config read, which needs nothing, so that a
# machine that builds for a device takes it alone.
set(CPACK_PACKAGE_NAME netmesh)
set(CPACK_PACKAGE_VENDOR "the netmesh authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Delaunay meshes and certified persistent homology")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL development)
if(TARGET netmesh_tool)
  list(APPEND CPACK_COMPONENTS_ALL tool)
endif()

# The project has no address for mail; whoever hands packages out gives their own.
set(NETMESH_PACKAGE_MAINTAINER "netmesh authors <authors@netmesh.invalid>" CACHE STRING
  "Maintainer of the Debian packages, with an address")
mark_as_advanced(NETMESH_PACKAGE_MAINTAINER)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${NETMESH_PACKAGE_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# Lines of at most 79 columns.
set(about "From points in R^2 to R^6 to a quality Voronoi/Delaunay mesh, and from that to
certified persistent homology. Predicates are exact, results are the same
bytes on every machine, and a diagram carries the ratio within which it
provably agrees with the exact one.\n")
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME netmesh)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION math)
set(CPACK_COMPONENT_TOOL_DESCRIPTION "${about}This package has the command-line tool.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libnetmesh-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "${about}This package has the library, which works in one block of memory of the
caller's, and its headers for C and C++.")
# The versions that the tool needs, where dpkg-shlibdeps (of dpkg-dev) can tell; the library needs nothing.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
find_program(NETMESH_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(NETMESH_SHLIBDEPS)
if(NETMESH_SHLIBDEPS)
  set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
else()
  set(CPACK_DEBIAN_TOOL_PACKAGE_DEPENDS "libc6, libgcc-s1, libstdc++6")
endif()

# What Debian asks of every package: who may copy it, and what changed. The date is SOURCE_DATE_EPOCH where that is set.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(READ ${PROJECT_SOURCE_DIR}/LICENSE license)
file(WRITE ${PROJECT_BINARY_DIR}/package/copyright "netmesh\n\n${license}")
find_program(NETMESH_GZIP gzip)
mark_as_advanced(NETMESH_GZIP)
foreach(component tool development)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(documents ${PROJECT_BINARY_DIR}/package/${package})
  file(WRITE ${documents}/changelog.Debian
    "netmesh (${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
    "  * Version ${PROJECT_VERSION}; the project's own list of changes is changelog.gz.\n\n"
    " -- ${NETMESH_PACKAGE_MAINTAINER}  ${date}\n")
  configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${documents}/changelog COPYONLY)
  set(compressed "")
  if(NETMESH_GZIP)
    execute_process(COMMAND ${NETMESH_GZIP} -9nf changelog changelog.Debian WORKING_DIRECTORY ${documents})
    set(compressed .gz)
  endif()
  # EXCLUDE_FROM_ALL: cmake --install leaves them out, cpack installs each component.
  install(FILES ${PROJECT_BINARY_DIR}/package/copyright ${documents}/changelog${compressed}
    ${documents}/changelog.Debian${compressed} DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
include(CPack)
