// Fault: keeps state between calls, one a thread.
extern "C" int netmesh_thread_local() {
    static thread_local int calls;
    return ++calls;
}
