// Fault: two functions that call each other, so the stack has no bound.
namespace netmesh {
__attribute__((noinline)) unsigned odd(const unsigned* next, unsigned i);
__attribute__((noinline)) unsigned even(const unsigned* next, unsigned i) {
    return i == 0 ? 1 : odd(next, next[i]) + i;
}
unsigned odd(const unsigned* next, unsigned i) { return i == 0 ? 0 : even(next, next[i]) * i; }
}  // namespace netmesh

extern "C" unsigned netmesh_recursion(const unsigned* next) { return netmesh::even(next, next[0]); }
