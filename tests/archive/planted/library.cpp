// Fault: a function of the mathematical library, whose last bit differs from system to system.
extern "C" double sin(double);

extern "C" double netmesh_library(double x) { return sin(x); }
