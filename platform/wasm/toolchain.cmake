# WebAssembly by clang, with the headers of libc++ and of wasi-libc but neither library.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_FLAGS_INIT "-mbulk-memory")
# The system's ar makes archives of such objects without an index, which the linker refuses.
foreach(program ar ranlib)
  string(TOUPPER ${program} name)
  find_program(NETMESH_LLVM_${name} NAMES llvm-${program} llvm-${program}-19 llvm-${program}-18 llvm-${program}-17
    llvm-${program}-16 llvm-${program}-15 llvm-${program}-14)
  if(NOT NETMESH_LLVM_${name})
    message(FATAL_ERROR "there is no llvm-${program} (Debian: llvm)")
  endif()
  set(CMAKE_${name} ${NETMESH_LLVM_${name}} CACHE FILEPATH "" FORCE)
endforeach()
