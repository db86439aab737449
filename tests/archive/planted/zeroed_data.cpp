// Fault: keeps state between calls, in memory that starts as zero.
extern "C" int netmesh_zeroed_data() {
    static int calls;
    return ++calls;
}
