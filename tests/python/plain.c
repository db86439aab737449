/* plain FILE DIM TIMES: the alpha diagram and the Delaunay triangulation of points, doubles in a file, as a program in
 * C makes and reads them. Prints for each: name, fingerprint, seconds of the best run. */
#define _DEFAULT_SOURCE
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <time.h>

#include "netmesh.h"

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Large blocks are mapped for each run, as Python does; small ones stay. */
static void* take(size_t bytes) {
    void* const block = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (block == MAP_FAILED) exit(2);
    madvise(block, bytes, MADV_HUGEPAGE);
    return block;
}

struct job {
    const double* points;
    size_t count, block_bytes, pairs_bytes;
    uint32_t dim;
    void* small;
    double* read;
};

static uint64_t fingerprint(const netmesh_context* context) {
    netmesh_report report;
    report.struct_bytes = sizeof report;
    return netmesh_get_report(context, &report) == NETMESH_OK ? report.fingerprint : 0;
}

static void* block_of(const struct job* job) { return job->small != NULL ? job->small : take(job->block_bytes); }
static void give_back(const struct job* job, void* block) {
    if (job->small == NULL) munmap(block, job->block_bytes);
}

static uint64_t alpha(const struct job* job) {
    netmesh_context* context;
    netmesh_request request = netmesh_default_request();
    netmesh_pair pair = {sizeof pair, 0, 0, 0};
    void* const block = block_of(job);
    uint64_t result;
    request.points.coordinates = job->points;
    request.points.count = job->count;
    request.points.dim = job->dim;
    request.filter = &netmesh_filter_alpha;
    if (netmesh_init(block, job->block_bytes, &context) != NETMESH_OK) exit(2);
    if (netmesh_persist(context, &request) != NETMESH_OK) exit(2);
    for (uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i) {
        job->read[2 * i] = pair.birth;
        job->read[2 * i + 1] = pair.death;
    }
    result = fingerprint(context);
    give_back(job, block);
    return result;
}

static uint64_t delaunay(const struct job* job) {
    netmesh_context* context;
    netmesh_request request = netmesh_default_request();
    netmesh_vertex vertex;
    netmesh_cell cell;
    void* const block = block_of(job);
    uint32_t* const cells = (uint32_t*)(job->read + job->count * job->dim);
    uint64_t result;
    request.points.coordinates = job->points;
    request.points.count = job->count;
    request.points.dim = job->dim;
    request.mesh.method = &netmesh_method_delaunay;
    if (netmesh_init(block, job->block_bytes, &context) != NETMESH_OK) exit(2);
    if (netmesh_mesh(context, &request) != NETMESH_OK) exit(2);
    vertex.struct_bytes = sizeof vertex;
    cell.struct_bytes = sizeof cell;
    for (uint64_t i = 0; netmesh_get_vertex(context, i, &vertex) == NETMESH_OK; ++i)
        for (uint32_t k = 0; k < job->dim; ++k) job->read[i * job->dim + k] = vertex.coordinates[k];
    for (uint64_t i = 0; netmesh_get_cell(context, i, &cell) == NETMESH_OK; ++i)
        for (uint32_t k = 0; k <= job->dim; ++k) cells[i * (job->dim + 1) + k] = cell.vertices[k];
    result = fingerprint(context);
    give_back(job, block);
    return result;
}

static void run(const char* name, uint64_t (*work)(const struct job*), const struct job* job, int times) {
    double best = 1e9;
    uint64_t result = 0;
    for (int i = 0; i < times; ++i) {
        const double begin = now();
        result = work(job);
        if (now() - begin < best) best = now() - begin;
    }
    printf("%s %016" PRIx64 " %.9f\n", name, result, best);
}

int main(int argc, char** argv) {
    struct job job = {0};
    if (argc != 4) return 1;
    FILE* const file = fopen(argv[1], "rb");
    if (file == NULL || fseek(file, 0, SEEK_END) != 0) return 1;
    job.dim = (uint32_t)atoi(argv[2]);
    job.count = (size_t)ftell(file) / sizeof(double) / job.dim;
    rewind(file);
    double* const points = malloc(job.count * job.dim * sizeof(double));
    if (points == NULL || fread(points, job.dim * sizeof(double), job.count, file) != job.count) return 1;
    fclose(file);
    job.points = points;
    job.block_bytes = job.count < 1000 ? (size_t)1 << 20 : (size_t)4 << 30;
    job.small = job.count < 1000 ? take(job.block_bytes) : NULL;
    job.read = malloc(job.count * 40 * sizeof(double) + 65536);
    if (job.read == NULL) return 2;
    run("alpha", alpha, &job, atoi(argv[3]));
    run("delaunay", delaunay, &job, atoi(argv[3]));
    return 0;
}
