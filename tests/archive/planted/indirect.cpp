// Fault: a call through a pointer that is not the monitor's poll.
extern "C" double netmesh_indirect(double (*f)(double), double x) { return f(x) + 1.0; }
