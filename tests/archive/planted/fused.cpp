// Fault when compiled with -mfma -ffp-contract=fast: one rounding where the engine's code has two.
extern "C" double netmesh_fused(double a, double b, double c) { return a * b + c; }
