# What ESP-IDF's build system does with a project whose main component names netmesh, on newlib and qemu. Given: PYTHON,
# NETMESH_COMPONENT (of main/idf_component.yml, by check.py), EXTRA_CONF_FILE.
set(IDF_HERE ${CMAKE_CURRENT_LIST_DIR}/../..)

# Flags of components, as tools/cmake/build.cmake has them, but for the language, which is newer there.
function(idf_component_register)
  cmake_parse_arguments(arg "" "" "SRCS;INCLUDE_DIRS;REQUIRES;PRIV_REQUIRES" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS OR arg_REQUIRES OR arg_PRIV_REQUIRES)
    message(FATAL_ERROR "idf_component_register: ${arg_UNPARSED_ARGUMENTS}${arg_REQUIRES}${arg_PRIV_REQUIRES}")
  endif()
  get_filename_component(name ${CMAKE_CURRENT_LIST_DIR} NAME)
  set(library __idf_${name})
  add_library(${library} STATIC ${arg_SRCS})
  target_include_directories(${library} PUBLIC ${arg_INCLUDE_DIRS})
  target_compile_options(${library} PRIVATE -ffunction-sections -fdata-sections -Wall -Werror=all
    -Wno-error=unused-function -Wno-error=unused-variable -Wno-error=deprecated-declarations -Wextra
    -Wno-unused-parameter -Wno-sign-compare -ggdb $<$<COMPILE_LANGUAGE:CXX>:-std=gnu++17>)
  set(COMPONENT_LIB ${library} PARENT_SCOPE)
endfunction()

macro(project name)
  execute_process(
    COMMAND ${PYTHON} ${IDF_HERE}/../kconfig.py ${IDF_HERE}/Kconfig ${NETMESH_COMPONENT}/Kconfig
      ${CMAKE_CURRENT_BINARY_DIR}/config.cmake ${CMAKE_CURRENT_SOURCE_DIR}/sdkconfig.defaults ${EXTRA_CONF_FILE}
    RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "Kconfig")
  endif()
  include(${CMAKE_CURRENT_BINARY_DIR}/config.cmake)
  _project(${name} C CXX)
  add_subdirectory(${NETMESH_COMPONENT} netmesh)
  add_subdirectory(main)
  target_link_libraries(__idf_main PUBLIC __idf_netmesh)
  add_executable(program ${IDF_HERE}/main.c ${IDF_HERE}/../start.c)
  target_link_libraries(program PRIVATE __idf_main)
endmacro()
