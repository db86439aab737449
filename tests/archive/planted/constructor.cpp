// Fault: code that runs before main.
namespace {
extern "C" int netmesh_seed();
const int seed = netmesh_seed();
}  // namespace

extern "C" int netmesh_constructor() { return seed; }
extern "C" int netmesh_seed() {
    int x = 1;
    asm volatile("" : "+r"(x));
    return x;
}
