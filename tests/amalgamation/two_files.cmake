# In place of add_subdirectory(<netmesh>): the library as a user makes it who takes the two files of tools/amalgamate.
# Sets no flag, for those of CMAKE_CXX_FLAGS are all that such a user has.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(two_files ${CMAKE_CURRENT_BINARY_DIR}/two_files)
execute_process(COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/../../tools/amalgamate ${two_files}
  RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "tools/amalgamate fails")
endif()
file(WRITE ${two_files}/netmesh.hpp "#include \"netmesh.h\"\n") # for programs that know the layer by its own name
add_library(netmesh STATIC ${two_files}/netmesh.cpp)
target_compile_features(netmesh PUBLIC cxx_std_17)
set_target_properties(netmesh PROPERTIES CXX_EXTENSIONS OFF)
target_include_directories(netmesh PUBLIC ${two_files})
