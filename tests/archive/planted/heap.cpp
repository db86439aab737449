// Fault: asks the heap for memory.
#include <cstddef>

extern "C" void* malloc(std::size_t);

extern "C" double* netmesh_heap(std::size_t n) { return static_cast<double*>(malloc(n * sizeof(double))); }
