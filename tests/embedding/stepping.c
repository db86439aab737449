/* A job in time slices, as a task of a real-time system runs it: the task's poll hands the processor back and waits for
 * the next slice, so the job goes on where it stopped. The engine needs nothing for that but a stack of known size;
 * here the task is a thread, the scheduler a mutex and a condition. The result is that of an undivided run. */
#define _POSIX_C_SOURCE 200112L
#include <netmesh.h>
#include <pthread.h>
#include <stdio.h>

#define POINTS 20000
#define BLOCK_BYTES ((size_t)64 << 20)

static double points[2 * POINTS];
static uint64_t memory[BLOCK_BYTES / 8 + 2];

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static int slices_granted, slices_used, finished;

static int wait_for_slice(void* user, const netmesh_progress* progress) {
    (void)user, (void)progress;
    pthread_mutex_lock(&mutex);
    ++slices_used;
    pthread_cond_broadcast(&changed);
    while (slices_granted <= slices_used) pthread_cond_wait(&changed, &mutex);
    pthread_mutex_unlock(&mutex);
    return 0;
}

static uint64_t job(netmesh_poll poll) {
    const uintptr_t at = (uintptr_t)memory;
    netmesh_context* context;
    netmesh_mesh_request mesh;
    netmesh_persist_request persist;
    netmesh_report report;
    netmesh_mesh_request_init(&mesh, sizeof mesh, 2);
    mesh.points = points;
    mesh.point_count = POINTS;
    mesh.purpose = NETMESH_PURPOSE_PERSIST;
    netmesh_persist_request_init(&persist, sizeof persist);
    mesh.monitor.poll = persist.monitor.poll = poll;
    if (netmesh_init((unsigned char*)memory + (16 - at % 16) % 16, BLOCK_BYTES, &context) != NETMESH_OK) return 0;
    if (netmesh_mesh(context, &mesh) != NETMESH_OK) return 0;
    if (netmesh_persist(context, &persist) != NETMESH_OK) return 0;
    report.struct_bytes = sizeof report;
    return netmesh_get_report(context, &report) == NETMESH_OK ? report.fingerprint : 0;
}

static void* task(void* result) {
    *(uint64_t*)result = job(wait_for_slice);
    pthread_mutex_lock(&mutex);
    finished = 1;
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&mutex);
    return NULL;
}

int main(void) {
    uint64_t state = 1, whole, sliced = 0;
    pthread_attr_t attributes;
    pthread_t thread;
    int i;
    for (i = 0; i < 2 * POINTS; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        points[i] = (double)(state >> 40);
    }
    whole = job(NULL);
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, 128 << 10); /* the engine's deepest chain in 2D takes less than 5 KiB */
    slices_granted = 1;
    if (pthread_create(&thread, &attributes, task, &sliced) != 0) return 1;
    pthread_mutex_lock(&mutex);
    while (!finished) {
        if (slices_used == slices_granted) {
            ++slices_granted; /* the system's own work stands here, between two slices */
            pthread_cond_broadcast(&changed);
        }
        pthread_cond_wait(&changed, &mutex);
    }
    pthread_mutex_unlock(&mutex);
    pthread_join(thread, NULL);
    printf("%d slices\n", slices_used + 1);
    return whole != 0 && sliced == whole && slices_used > 1 ? 0 : 1;
}
