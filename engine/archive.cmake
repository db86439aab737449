# From the engine's objects to the archive that users link: one relocatable object in which only netmesh_* is global.
#
# A client that instantiates the same templates under other flags (say -mfma) would otherwise hand the linker a weak
# copy that replaces the library's, and results would change without a word. So the objects are combined (ld -r, with
# the COMDAT groups dissolved where the linker can) and every other symbol is made local (objcopy).
#
#   netmesh_engine   the plain archive, every symbol visible: what the tests of inner folders link
#   netmesh          the finished archive libnetmesh.a: what tools, benchmarks and users link

# Sets `out` to the linker flags of the combining step, `out_ok` to whether linker and objcopy can do it at all, tried
# on two small objects that share a template.
function(netmesh_can_finish out out_ok out_why)
  set(${out_ok} FALSE PARENT_SCOPE)
  if(NOT CMAKE_OBJCOPY OR NOT CMAKE_LINKER OR NOT CMAKE_NM)
    set(${out_why} "objcopy, ld or nm is missing" PARENT_SCOPE)
    return()
  endif()
  set(flags -r)
  execute_process(COMMAND ${CMAKE_LINKER} --help OUTPUT_VARIABLE help ERROR_QUIET)
  if(help MATCHES "force-group-allocation")
    list(APPEND flags --force-group-allocation)
  endif()
  if(help MATCHES "--unique \\[=SECTION\\]")
    list(APPEND flags "--unique=.rodata*") # or who calls anything holds the constants and texts of everything
  endif()
  separate_arguments(user_flags UNIX_COMMAND "${CMAKE_CXX_FLAGS}")
  if("-m32" IN_LIST user_flags)
    list(APPEND flags -m elf_i386)
  endif()
  if(CMAKE_CXX_COMPILER_TARGET)
    list(APPEND user_flags --target=${CMAKE_CXX_COMPILER_TARGET})
  endif()
  set(dir ${PROJECT_BINARY_DIR}/CMakeFiles/netmesh_finish)
  file(WRITE ${dir}/a.cpp
    "template <class T> T twice(T x) { return x + x; }\ntemplate double twice<double>(double);\n"
    "extern \"C\" double netmesh_a(double x) { return twice(x); }\n")
  file(WRITE ${dir}/b.cpp
    "template <class T> T twice(T x) { return x + x; }\ntemplate double twice<double>(double);\n"
    "extern \"C\" double netmesh_b(double x) { return twice(x); }\n")
  foreach(unit a b)
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${user_flags} ${NETMESH_ENGINE_FLAGS}
        -c ${dir}/${unit}.cpp -o ${dir}/${unit}.o
      RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if(failed)
      set(${out_why} "the compiler refuses a small file" PARENT_SCOPE)
      return()
    endif()
  endforeach()
  execute_process(COMMAND ${CMAKE_LINKER} ${flags} -o ${dir}/ab.o ${dir}/a.o ${dir}/b.o
    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed)
    set(${out_why} "${CMAKE_LINKER} does not combine objects" PARENT_SCOPE)
    return()
  endif()
  execute_process(COMMAND ${CMAKE_OBJCOPY} -w "--keep-global-symbol=netmesh_*" ${dir}/ab.o
    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  execute_process(COMMAND ${CMAKE_NM} -g --defined-only ${dir}/ab.o OUTPUT_VARIABLE symbols ERROR_QUIET)
  if(failed OR NOT symbols MATCHES "netmesh_a" OR symbols MATCHES "twice")
    set(${out_why} "${CMAKE_OBJCOPY} does not make symbols local" PARENT_SCOPE)
    return()
  endif()
  set(${out} ${flags} PARENT_SCOPE)
  set(${out_ok} TRUE PARENT_SCOPE)
endfunction()

add_library(netmesh_engine STATIC ${NETMESH_ENGINE_SOURCES})
target_compile_features(netmesh_engine PUBLIC cxx_std_17)
set_target_properties(netmesh_engine PROPERTIES CXX_EXTENSIONS OFF INTERPROCEDURAL_OPTIMIZATION OFF
  ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/plain)
target_compile_options(netmesh_engine PRIVATE ${NETMESH_ENGINE_FLAGS})
# For tests that compile an engine of their own.
set_property(TARGET netmesh_engine PROPERTY NETMESH_SOURCES ${NETMESH_ENGINE_SOURCES})
# A Release build is small, but for what the large jobs spend their time in: archive.size counts the bytes of all that
# is built. What headers leave out at -Os (__OPTIMIZE_SIZE__) stays in: they have to mean the same in all files.
target_compile_options(netmesh_engine PRIVATE "$<$<CONFIG:Release>:-Os;-U__OPTIMIZE_SIZE__>")
set(fast api/report api/structs complex/faces_along delaunay/any_store delaunay/plane_few delaunay/spatial_order
  delaunay/triangulate diagram/bottleneck diagram/wasserstein filtration/mesh_filter
  filtration/rips_graph homology/lower_star/surface homology/matrix/ball homology/matrix/cohomology
  homology/matrix/homology homology/matrix/image homology/pair_writer homology/rips/rips homology/rips/rips_simplices
  homology/vineyard/vineyard jobs/alpha_of_plane jobs/alpha_of_triangulation mesh/clip/clipped_cell
  mesh/clip/clipped_reach
  mesh/loop/certificate_rule mesh/loop/quality_rule numerics/residues periods/final_stars periods/lattice
  periods/orbits periods/wanted_copies pieces/cancel pieces/leaf pieces/stars predicates/predicates)
list(TRANSFORM fast REPLACE ".+" "${PROJECT_SOURCE_DIR}/engine/\\0.cpp")
set(unaligned "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(unaligned ";-fno-align-jumps;-fno-align-labels") # loops and functions are
endif()
# Where -O3 saves a part of a large job that counts.
set(fastest delaunay/kernel delaunay/sphere filtration/alpha homology/lower_star/lower_star
  mesh/input_tree numerics/radix_sort numerics/value_order)
list(TRANSFORM fastest REPLACE ".+" "${PROJECT_SOURCE_DIR}/engine/\\0.cpp")
# What has options of its own stays out of a build of several sources at once (CMAKE_UNITY_BUILD).
if(CMAKE_BUILD_TYPE STREQUAL "Release" OR CMAKE_CONFIGURATION_TYPES)
  set_source_files_properties(${fast} PROPERTIES COMPILE_OPTIONS "$<$<CONFIG:Release>:-O2${unaligned}>")
  set_source_files_properties(${fastest} PROPERTIES COMPILE_OPTIONS "$<$<CONFIG:Release>:-O3${unaligned}>")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Loops that -O3 makes twice, or spells out where they are long, and copies of functions cost a fifth of the bytes
    # there and save nothing.
    set(spelled_out --param=max-completely-peeled-insns=100)
    set(once delaunay/sphere filtration/alpha homology/lower_star/lower_star mesh/input_tree numerics/value_order)
    list(TRANSFORM once REPLACE ".+" "${PROJECT_SOURCE_DIR}/engine/\\0.cpp")
    set_property(SOURCE ${once}
      APPEND PROPERTY COMPILE_OPTIONS "$<$<CONFIG:Release>:-fno-unswitch-loops;-fno-split-loops;-fno-tree-vectorize>"
        "$<$<CONFIG:Release>:-fno-ipa-cp-clone;${spelled_out}>")
    # The kernel's loops over corners are worth a copy, but not that much of it.
    set_property(SOURCE ${PROJECT_SOURCE_DIR}/engine/delaunay/kernel.cpp
      APPEND PROPERTY COMPILE_OPTIONS "$<$<CONFIG:Release>:${spelled_out}>")
  endif()
endif()
# Beyond D = 4 the same templates are small, but for triangulations: their sources are compiled once more, for those
# dimensions alone.
set(low ${NETMESH_SERVED})
list(FILTER low INCLUDE REGEX "^[2-4]$")
set(high ${NETMESH_SERVED})
list(FILTER high EXCLUDE REGEX "^[2-4]$")
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND low AND high)
  foreach(part low high)
    list(TRANSFORM ${part} REPLACE "(.+)" "DO(\\1)")
    list(JOIN ${part} " " each)
    set(${part} "-DNETMESH_EACH_INSTANCE(DO)=${each}")
  endforeach()
  foreach(source ${fast} ${fastest})
    file(STRINGS ${source} instances REGEX "^NETMESH_EACH_INSTANCE")
    if(instances AND NOT source MATCHES "/delaunay/")
      file(RELATIVE_PATH again ${PROJECT_SOURCE_DIR} ${source})
      string(REGEX REPLACE "([^/]+)$" "high/\\1" again ${PROJECT_BINARY_DIR}/${again})
      configure_file(${PROJECT_SOURCE_DIR}/engine/again.cpp.in ${again} @ONLY)
      target_sources(netmesh_engine PRIVATE ${again})
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS "${low}")
      set_property(SOURCE ${again} APPEND PROPERTY COMPILE_OPTIONS "${high}")
      if(source MATCHES "/quality_rule")  # half of the time of a mesh, which small code would double
        set_property(SOURCE ${again} APPEND PROPERTY COMPILE_OPTIONS "$<$<CONFIG:Release>:-O2${unaligned}>")
      endif()
    endif()
  endforeach()
endif()
target_include_directories(netmesh_engine
  PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/engine/include> PRIVATE ${PROJECT_SOURCE_DIR}/engine)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Records only, no code: tests/archive reads call chains and their stack out of them.
  target_compile_options(netmesh_engine PRIVATE -fstack-usage -fcallgraph-info=su,da)
endif()

# Where size counts the archive is made of tools/amalgamate's one source: the compiler then knows that nothing but
# netmesh_* is called from outside, and code comes out an eighth smaller than from a source for each part.
set(NETMESH_ONE_SOURCE OFF)
if(CMAKE_BUILD_TYPE STREQUAL "MinSizeRel" AND NOT NETMESH_VALIDATE)
  find_package(Python3 COMPONENTS Interpreter QUIET)
  set(NETMESH_ONE_SOURCE ${Python3_FOUND})
  if(NOT Python3_FOUND)
    message(STATUS "netmesh: no python3; the archive is made of many sources, and an eighth larger")
  endif()
endif()

netmesh_can_finish(NETMESH_COMBINE NETMESH_FINISHED NETMESH_WHY)
list(JOIN NETMESH_COMBINE " " NETMESH_COMBINE_TEXT)
if(NETMESH_ONE_SOURCE)
  set(one ${PROJECT_BINARY_DIR}/one)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/engine/*.hpp ${PROJECT_SOURCE_DIR}/engine/*.h)
  add_custom_command(OUTPUT ${one}/netmesh.cpp ${one}/netmesh.h
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/amalgamate ${one}
    DEPENDS ${NETMESH_ENGINE_SOURCES} ${headers} ${PROJECT_SOURCE_DIR}/tools/amalgamate ${PROJECT_SOURCE_DIR}/LICENSE
    COMMENT "Writing the engine as one source" VERBATIM)
  add_library(netmesh STATIC ${one}/netmesh.cpp)
  target_compile_features(netmesh PUBLIC cxx_std_17)
  set_target_properties(netmesh PROPERTIES CXX_EXTENSIONS OFF INTERPROCEDURAL_OPTIMIZATION OFF)
  target_compile_options(netmesh PRIVATE ${NETMESH_ENGINE_FLAGS} -w) # warnings are those of the many sources
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Passes that g++ runs at -Os, too, and that make this code larger.
    target_compile_options(netmesh PRIVATE
      -fno-tree-loop-im -fno-move-loop-invariants -fno-ipa-sra -fno-tree-dominator-opts -fno-guess-branch-probability
      -fno-tree-vrp -fno-caller-saves -fno-shrink-wrap)
    if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12)
      target_compile_options(netmesh PRIVATE -Oz)
    endif()
  endif()
  set_target_properties(netmesh_engine PROPERTIES EXCLUDE_FROM_ALL ON) # for tests of inner folders
elseif(NETMESH_FINISHED)
  set(combined ${PROJECT_BINARY_DIR}/plain/netmesh.o)
  add_custom_command(OUTPUT ${combined}
    COMMAND ${CMAKE_LINKER} ${NETMESH_COMBINE} -o ${combined}.tmp --whole-archive $<TARGET_FILE:netmesh_engine>
    COMMAND ${CMAKE_OBJCOPY} -w "--keep-global-symbol=netmesh_*" ${combined}.tmp ${combined}
    COMMAND ${CMAKE_COMMAND} -E remove ${combined}.tmp
    DEPENDS netmesh_engine $<TARGET_FILE:netmesh_engine>
    COMMENT "Finishing libnetmesh.a" VERBATIM)
  set_source_files_properties(${combined} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
  add_library(netmesh STATIC ${combined})
else()
  message(STATUS "netmesh: ${NETMESH_WHY}; libnetmesh.a keeps its inner symbols global")
  add_library(netmesh STATIC $<TARGET_OBJECTS:netmesh_engine>)
endif()
add_library(netmesh::netmesh ALIAS netmesh)
set_target_properties(netmesh PROPERTIES LINKER_LANGUAGE CXX)
target_include_directories(netmesh PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/engine/include>)
if(NETMESH_VALIDATE)
  add_library(netmesh_validate STATIC ${PROJECT_SOURCE_DIR}/platform/validate.c)
  target_link_libraries(netmesh_engine PUBLIC netmesh_validate)
  target_link_libraries(netmesh PUBLIC netmesh_validate)
endif()
