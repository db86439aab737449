// Fault: 40,000 bytes of stack.
extern "C" double netmesh_deep_stack(const double* p, unsigned n) {
    volatile double copy[5000];
    for (unsigned i = 0; i < n; ++i) copy[i] = p[i];
    return copy[n / 2];
}
