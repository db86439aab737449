// Fault: long double, which is 80 bits wide on one platform and not on another.
extern "C" double netmesh_extended(const long double* a) { return static_cast<double>(a[0] * a[1]); }
