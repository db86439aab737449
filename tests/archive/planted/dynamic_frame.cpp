// Fault: a frame whose size the caller's data decide.
extern "C" double netmesh_dynamic_frame(const double* p, unsigned n) {
    volatile double* copy = static_cast<volatile double*>(__builtin_alloca(n * sizeof(double)));
    for (unsigned i = 0; i < n; ++i) copy[i] = p[i];
    return copy[n / 2];
}
