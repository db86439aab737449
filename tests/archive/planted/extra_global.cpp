// Fault when the archive is not finished: an inner function that the world sees.
namespace netmesh {
double inner(double x) { return x + 1.0; }
}  // namespace netmesh

extern "C" double netmesh_extra_global(double x) { return netmesh::inner(x); }
