/* One sweep of a range finder to the loops that it saw, on a Cortex-M with 256 KB of flash and 128 KB of RAM.
 *
 * A file to copy: with netmesh.h and netmesh.cpp of tools/amalgamate, a board (example.h) and a linker script
 * (example.ld) it is a whole firmware. platform/cortexm/run --example builds it so, for D = 2 alone, runs it in qemu
 * and prints what it takes. The job is part 1; part 2 is this program, in whose place you have your own. On any other
 * machine it is an ordinary program that prints the same lines. */
#include "netmesh.h"

/* Part 1: the job ------------------------------------------------------------------------------------------------ */

enum { SWEEP_ANGLES = 360 };

/* The engine's memory: all of it. It is planned before the part is bought: netmesh_plan says how much uniform
 * points take, here 32 KB, netmesh_report.memory.peak_bytes how much yours took, here 26 KB. A block that is too small
 * is no accident: the call answers NETMESH_OUT_OF_MEMORY, and writes nowhere else. */
static unsigned char block[36 * 1024] __attribute__((aligned(16)));

/* The points are read from where they are and may be given up when the call returns. */
static double points[SWEEP_ANGLES][2];

/* The largest loop of a sweep: radii in metres. */
typedef struct loop {
    double gap;  /* half of the widest gap in it: what is narrower counts as closed */
    double free; /* the largest circle of free space inside */
} loop;

/* Ranges in millimetres, one a degree, 0 where nothing came back. Runs to its end; to share the processor, let
 * request.monitor.poll return non-zero to stop, or let it pause there (tests/embedding/slices.c). */
static netmesh_status find_loop(const uint16_t* range_mm, loop* largest) {
    const loop none = {0, 0};
    /* Sine and cosine by turning a direction one degree at a time: no library. */
    const double cosine = 0.99984769515639127, sine = 0.017452406437283512;
    netmesh_context* context;
    netmesh_request request = netmesh_default_request();
    netmesh_pair pair;
    netmesh_status status;
    double x = 1e-3, y = 0;
    size_t count = 0;
    uint64_t i;

    for (i = 0; i < SWEEP_ANGLES; ++i) {
        const double turned = cosine * x - sine * y;
        if (range_mm[i] != 0) {
            points[count][0] = range_mm[i] * x;
            points[count][1] = range_mm[i] * y;
            ++count;
        }
        y = sine * x + cosine * y;
        x = turned;
    }
    /* A task of an RTOS that does this needs as much stack as STACK_BYTES in part 2: it makes the deepest call. */
    if ((status = netmesh_init(block, sizeof block, &context)) != NETMESH_OK) return status;
    request.points.coordinates = points[0];
    request.points.count = count;
    request.points.dim = 2;
    request.filter = &netmesh_filter_alpha_small;
    if ((status = netmesh_persist(context, &request)) != NETMESH_OK) return status;

    *largest = none;
    pair.struct_bytes = sizeof pair;
    for (i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i)
        if (pair.degree == 1 && pair.death - pair.birth > largest->free - largest->gap) {
            largest->gap = pair.birth;
            largest->free = pair.death;
        }
    return NETMESH_OK;
}

/* Part 2: what this program does with it -------------------------------------------------------------------------- */

/* netmesh_persist by the filter alpha takes no more whatever the points are; the rest is for the functions of this file
 * and for one interrupt, which pushes up to 104 bytes where there is a floating-point unit. */
enum { OWN_STACK = 512 };
#define STACK_BYTES (NETMESH_STACK_BYTES_ALPHA(2) + OWN_STACK)
#include "example.h"

/* A room of some 5 m by 4 m with a niche, a pillar and an open door, from its inside; noise of 6 mm. */
static const uint16_t sweep[SWEEP_ANGLES] = {
    3107, 3106, 3094, 3093, 3107, 3116, 3116, 3115, 3127, 3147, 3140, 3164, 3172, 3184, 3200, 3206, 3224, 3252, 3257,
    3276, 3291, 3318, 3348, 3375, 1777, 1720, 1692, 1673, 1667, 1655, 1663, 1662, 1665, 1687, 1727, 3782, 3736, 3651,
    3575, 3498, 3428, 3348, 3290, 3232, 3169, 3122, 3056, 3008, 2961, 2913, 2872, 2832, 2792, 2752, 2717, 2685, 2645,
    2624, 2588, 2565, 2534, 2516, 2489, 2468, 2443, 2428, 2418, 2379, 2376, 2358, 2339, 2319, 2323, 2302, 2295, 2275,
    2263, 2264, 2254, 2239, 2233, 2231, 2217, 2212, 2212, 2214, 2210, 2204, 2209, 2199, 2197, 2214, 2198, 2207, 2209,
    2209, 2213, 2221, 2225, 2224, 2234, 2105, 1928, 1776, 1654, 1547, 1553, 1566, 1587, 1583, 1585, 1606, 1614, 1634,
    1649, 1653, 1670, 1678, 1706, 1711, 1732, 1764, 1763, 1790, 1809, 1834, 1857, 1887, 1906, 1934, 1951, 1990, 2011,
    2058, 2085, 2127, 2157, 2201, 2242, 2290, 2333, 2380, 2434, 2489, 2547, 2557, 2525, 2515, 2472, 2444, 2431, 2403,
    2378, 2364, 2347, 2312, 2307, 2285, 2272, 2246, 2245, 2228, 2193, 2203, 2193, 2166, 2166, 2154, 2148, 2134, 0,
    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,
    0,    2143, 2151, 2155, 2164, 2164, 2188, 2189, 2208, 2216, 2250, 2250, 2274, 2281, 2299, 2321, 2336, 2371, 2377,
    2411, 2418, 2445, 2480, 2496, 2545, 2567, 2596, 2640, 2596, 2538, 2474, 2428, 2389, 2334, 2308, 2269, 2227, 2178,
    2148, 2112, 2093, 2065, 2029, 2004, 1979, 1958, 1925, 1902, 1891, 1870, 1850, 1830, 1817, 1799, 1777, 1776, 1758,
    1737, 1725, 1710, 1695, 1686, 1674, 1669, 1666, 1656, 1641, 1641, 1632, 1624, 1631, 1614, 1621, 1602, 1611, 1602,
    1610, 1605, 1596, 1604, 1608, 1608, 1610, 1600, 1617, 1603, 1608, 1603, 1615, 1611, 1625, 1620, 1647, 1647, 1659,
    1664, 1666, 1676, 1684, 1681, 1696, 1712, 1731, 1730, 1753, 1762, 1785, 1800, 1806, 1823, 1856, 1873, 1887, 1913,
    1930, 1956, 1976, 2007, 2041, 2068, 2096, 2121, 2159, 2185, 2223, 2264, 2297, 2347, 2381, 2449, 2494, 2544, 2595,
    2655, 2720, 2780, 2859, 2932, 3025, 3115, 3209, 3292, 3400, 3488, 3454, 3427, 3397, 3369, 3356, 3326, 3303, 3273,
    3261, 3250, 3228, 3215, 3194, 3186, 3166, 3157, 3154, 3149, 3129, 3122, 3116, 3111, 3108, 3110, 3104, 3101,
};
static netmesh_report report; /* two kilobytes that need not be on the stack */

static int program(void) {
    const uint64_t start = clock_now();
    static loop largest;
    const netmesh_status status = find_loop(sweep, &largest);
    const uint64_t end = clock_now();
    if (status != NETMESH_OK) {
        say(netmesh_status_text(status));
        say("\n");
        return 1;
    }
    say_number("largest loop: gaps of ", (uint32_t)(2e6 * largest.gap + .5), " um, ");
    say_number("free circle of radius ", (uint32_t)(1e6 * largest.free + .5), " um\n");
    /* Two halves of one word that is the same on every machine, however it was compiled. */
    report.struct_bytes = sizeof report;
    netmesh_get_report((netmesh_context*)block, &report);
    say_number("fingerprint ", (uint32_t)(report.fingerprint >> 32), "");
    say_number(" ", (uint32_t)report.fingerprint, "\n");
    say_number("  block: ", (uint32_t)report.memory.peak_bytes, "");
    say_number(" of ", (uint32_t)sizeof block, " bytes\n");
    say_number("  stack: ", stack_used(), "");
    say_number(" of ", stack_size(), " bytes\n");
    say_number("  instructions: ", instructions_between(start, end), "\n");
    return 0;
}
