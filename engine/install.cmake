# cmake --install: archive, headers, what find_package and pkg-config read. Everything is relative to the
# prefix, so an installation may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

target_include_directories(netmesh PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS netmesh EXPORT netmesh-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT netmesh-targets NAMESPACE netmesh:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/netmesh
  COMPONENT development)

configure_file(${PROJECT_SOURCE_DIR}/engine/netmesh-config.cmake.in ${PROJECT_BINARY_DIR}/netmesh-config.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/netmesh-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/netmesh-config.cmake ${PROJECT_BINARY_DIR}/netmesh-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/netmesh COMPONENT development)

string(REGEX REPLACE "[^/]+" ".." NETMESH_PREFIX_FROM_PC "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
configure_file(${PROJECT_SOURCE_DIR}/engine/netmesh.pc.in ${PROJECT_BINARY_DIR}/netmesh.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/netmesh.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
