// Fault: keeps state between calls.
namespace {
int calls = 7;
}

extern "C" int netmesh_mutable_data() { return ++calls; }
