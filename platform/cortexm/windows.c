/* Is this signal periodic? Samples arrive one by one. After every 16 of them the last ones are points in the plane or
 * in space, and the exact alpha diagram of these, which is made in slices while further samples arrive, has the answer.
 *
 * A file to copy, as example.c is: with netmesh.h and netmesh.cpp of tools/amalgamate, a linker script (example.ld) and
 * the board of example.h it is a whole firmware. platform/cortexm/run --windows builds it so, for D = DIM alone, runs
 * it in qemu and prints what it takes. The job is part 1; parts 2 and 3 are this program and this signal, in whose
 * place you have your own. On any other machine it is an ordinary program that prints the same lines, but for those
 * that begin with a blank. */
#include "netmesh.h"

#ifndef DIM
#define DIM 2
#endif

/* Part 1: the job ------------------------------------------------------------------------------------------------ */

/* A window's points are (s[i], s[i + LAG]), in space (s[i], s[i + LAG], s[i + 2 LAG]), of its samples s. A signal that
 * repeats itself runs round a loop, which is widest where LAG is about a quarter of its period. */
enum { POINTS = 64, LAG = 5, SAMPLES = POINTS + (DIM - 1) * LAG };

/* The engine's memory: what netmesh_plan says of uniform points and a quarter more, as curves have more cells. A window
 * that needs more all the same is no accident: it answers NETMESH_OUT_OF_MEMORY, and the next one is made. */
static unsigned char block[(DIM == 2 ? 10 : 50) * 1024] __attribute__((aligned(16)));
static size_t planned;

/* The last samples, which an interrupt writes. The engine reads points as it works, when further samples arrive, and
 * its rows may not overlap: so a window's points are copied, which takes half a kilobyte, in space three quarters. */
enum { RING = 256 };
static volatile int16_t ring[RING];
static volatile uint32_t arrived; /* samples so far */
static float points[POINTS][DIM];

/* What the engine's deepest call takes, whatever the points are, and 512 bytes for the functions below and for one
 * interrupt, which runs on the stack in use. */
#ifndef JOB_STACK_BYTES
#define JOB_STACK_BYTES (NETMESH_STACK_BYTES_ALPHA(DIM) + NETMESH_STACK_BYTES_JOB + 512)
#endif
static uint64_t job_stack[JOB_STACK_BYTES / 8];
static netmesh_job* job;

static netmesh_request request;
static netmesh_report report; /* two kilobytes that need not be on a stack */

/* How periodic a signal is, in percent: the most of 100 (1 - birth / death) of bars of degree 1 that end at LEAST or
 * later; smaller loops are noise of the last digit.
 *
 * Samples are rounded: where it is not clipped, the signal was up to 1/2 away. So points were up to sqrt(DIM) / 2 away,
 * and no birth or death is farther from what it would have been; bars shorter than twice that come and go (stability of
 * diagrams). As births and deaths are exact, `low` and `high` enclose the percentage of every signal that gives these
 * samples. */
#define LEAST 8
#define MOVED (DIM == 2 ? 0.7072 : 0.8661)
typedef struct window {
    double low, high;
} window;

static void take_bar(double birth, double death, window* found) {
    const double low = 100 * (1 - (birth + MOVED) / (death - MOVED));
    const double high = birth <= MOVED ? 100 : 100 * (1 - (birth - MOVED) / (death + MOVED));
    if (death - MOVED >= LEAST && low > found->low) found->low = low;
    if (death + MOVED >= LEAST && high > found->high) found->high = high;
}

/* The task of a job: one window. */
static netmesh_status find_loop(void* user) {
    window* const found = (window*)user;
    netmesh_context* context;
    netmesh_pair bar;
    uint64_t i;
    netmesh_status status = netmesh_init(block, planned, &context);
    if (status == NETMESH_OK) status = netmesh_persist(context, &request);
    if (status != NETMESH_OK) return status;
    found->low = 0;
    found->high = 100 * 2 * MOVED / LEAST;
    bar.struct_bytes = sizeof bar;
    for (i = 0; netmesh_get_pair(context, i, &bar) == NETMESH_OK; ++i)
        if (bar.degree == 1) take_bar(bar.birth, bar.death, found);
    report.struct_bytes = sizeof report;
    return netmesh_get_report(context, &report);
}

static void plan(void) {
    request = netmesh_default_request();
    request.points.coordinates = points;
    request.points.count = POINTS;
    request.points.dim = DIM;
    request.points.format = NETMESH_POINTS_FLOAT32;
    request.filter = &netmesh_filter_alpha_small;
    request.monitor.poll = netmesh_poll_pause; /* a slice ends at each poll */
    planned = netmesh_plan(&request) / 4 * 5;
}

/* Begins a job for the window whose first sample has this number. */
static netmesh_status begin_job(uint32_t first, window* found) {
    netmesh_status status = netmesh_job_init(job_stack, sizeof job_stack, find_loop, found, &job);
    uint32_t i, k;
    for (i = 0; i < POINTS; ++i)
        for (k = 0; k < DIM; ++k) points[i][k] = ring[(first + i + k * LAG) % RING];
    request.monitor.user = job;
    return status;
}

/* Part 2: what this program does with it -------------------------------------------------------------------------- */

enum { WINDOWS = 1000, HOP = 16, PERIODIC = 67 };

/* From one sample to the next: HOP times that is what a window may take. */
#define TICK_INSTRUCTIONS (DIM == 2 ? 400000 : 4000000)
/* No slice of such signals takes more. How long slices can be, tools/docs/small-parts.md says. */
enum { SLICE_INSTRUCTIONS = DIM == 2 ? 2000000 : 4000000 };
#define STACK_BYTES 1536
#include "example.h"

static int16_t read_sensor(uint32_t number);

static void on_tick(void) {
    ring[arrived % RING] = read_sensor(arrived);
    ++arrived;
}

static uint64_t instructions;
static uint32_t slices, most_slices, longest_slice, longest_window, most_waiting, most_block, most_stack;
static void note(uint32_t* most, uint32_t now) {
    if (now > *most) *most = now;
}

/* A window from its samples to its bars. */
static netmesh_status make_window(uint32_t first, window* found) {
    uint32_t whole = 0, parts = 0;
    netmesh_status status;
    while (arrived < first + SAMPLES) wait_for_tick();
    status = begin_job(first, found);
    note(&most_waiting, arrived - first);
    if (arrived - first > RING) return NETMESH_CANCELLED; /* too late: samples are lost */
    if (status != NETMESH_OK) return status;
    do {
        const uint64_t begin = clock_now();
        uint32_t slice;
        status = netmesh_resume(job);
        slice = instructions_between(begin, clock_now());
        note(&longest_slice, slice);
        whole += slice;
        ++parts;
        /* Whatever else the program has to do stands here. */
    } while (status == NETMESH_PAUSED);
    instructions += whole;
    slices += parts;
    note(&most_slices, parts);
    note(&longest_window, whole);
    note(&most_stack, (uint32_t)netmesh_stack_used(job));
    return status;
}

/* LATE: none, as windows before took so long that its samples are gone. */
typedef enum decision { LOOP, NO_LOOP, UNSURE, FLAT, NO_ROOM, LATE, DECISIONS } decision;

static int program(void) {
    static const char* const text[DECISIONS] = {"periodic", "not periodic", "unsure", "flat", "out of memory", "late"};
    static uint32_t count[DECISIONS];
    decision now, last = DECISIONS;
    uint64_t fingerprint = 0;
    uint32_t i;
    plan();
    if (planned > sizeof block) {
        say_number("block: ", (uint32_t)planned, " bytes are planned\n");
        return 1;
    }
    for (i = 0; i < WINDOWS; ++i, last = now) {
        window found;
        const netmesh_status status = make_window(i * HOP, &found);
        switch (status) {
        case NETMESH_OK: now = found.low >= PERIODIC ? LOOP : found.high < PERIODIC ? NO_LOOP : UNSURE; break;
        case NETMESH_FLAT: now = FLAT; break; /* a constant signal; in space also one whose points lie in a plane */
        case NETMESH_OUT_OF_MEMORY: now = NO_ROOM; break;
        case NETMESH_CANCELLED: now = LATE; break;
        default: say(netmesh_status_text(status)); return 1;
        }
        if (status == NETMESH_OK) {
            note(&most_block, (uint32_t)report.memory.peak_bytes);
            fingerprint = fingerprint * 0x100000001B3u ^ report.fingerprint;
        }
        ++count[now];
        if (now == last) continue;
        say_number("window ", i, ": ");
        say(text[now]);
        if (status == NETMESH_OK) {
            say_number(", ", (uint32_t)found.low, " to ");
            say_number("", found.high < 100 ? (uint32_t)found.high + 1 : 100, " percent");
        }
        say("\n");
    }
    for (i = 0; i < LATE; ++i) {
        say(text[i]);
        say_number(": ", count[i], i + 1 < LATE ? ", " : "\n");
    }
    /* Two halves of one word that is the same on every machine, however it was compiled. */
    say_number("fingerprint ", (uint32_t)(fingerprint >> 32), " ");
    say_number("", (uint32_t)fingerprint, "\n");
    say_number("  block: ", most_block, " of ");
    say_number("", (uint32_t)planned, " planned bytes\n");
    say_number("  stack: ", stack_used(), " of ");
    say_number("", stack_size(), " bytes, of the job ");
    say_number("", most_stack, " of ");
    say_number("", (uint32_t)sizeof job_stack, "\n");
    say_number("  slices: ", slices / WINDOWS, " a window, at most ");
    say_number("", most_slices, "\n");
    say_number("  instructions: ", (uint32_t)(instructions / WINDOWS), " a window, at most ");
    say_number("", longest_window, "; at most ");
    say_number("", longest_slice, " a slice\n");
    say_number("  late: ", count[LATE], " windows\n");
    say_number("  samples waiting: at most ", most_waiting, " of ");
    say_number("", RING, "\n");
    if (longest_slice > SLICE_INSTRUCTIONS) say("a slice was too long\n");
    return longest_slice > SLICE_INSTRUCTIONS;
}

/* Part 3: the signal, by integers alone ---------------------------------------------------------------------------- */

enum { STRETCH = 1600 };

/* times sin(2 pi phase / 65536), nearly: an arch, and its square to mend it. */
static int32_t sine(uint32_t phase, uint32_t times) {
    const uint32_t half = phase & 0x7FFF, arch = half * (0x8000 - half) >> 13;
    const uint32_t y = (arch * (25395 + (7373 * arch >> 15)) >> 15) * times >> 15;
    return (phase & 0x8000) != 0 ? -(int32_t)y : (int32_t)y;
}
/* 0 .. below - 1, by no rule that can be seen. */
static int32_t noise(uint32_t number, uint32_t below) {
    number *= 2654435761u;
    number = (number ^ number >> 15) * 2246822519u;
    number = (number ^ number >> 13) * 3266489917u;
    return (int32_t)((number >> 16) % below);
}
/* A converter of 12 bits. */
static int16_t read_sensor(uint32_t number) {
    const uint32_t at = number % STRETCH, turn = 3079 * number; /* 21.3 samples a period */
    int32_t s = 2048;
    switch (number / STRETCH % 10) {
    case 0: break;                                                  /* silence */
    case 1: s += sine(turn, 1500) + noise(number, 17) - 8; break;   /* a tone with a little noise */
    case 2: s += noise(number, 3) - 1; break;                       /* noise of the last digit */
    case 3: s += sine(turn, 4000); break;                           /* a tone that is clipped */
    case 4: s += sine(1000 * at + 4 * at * at, 1800); break;        /* a chirp, from 65 samples a period to 5 */
    case 5: s += noise(number, 4096) - 2048; break;                 /* noise */
    case 6: s += sine(turn, 900) + sine(4982 * number, 900); break; /* two tones */
    case 7: s += number % 24 < 12 ? 1500 : -1500; break;            /* a square wave */
    case 8: s += number % 15 < 5 ? noise(number, 2000) : number % 15 < 10 ? -1000 : 1000; break; /* steps and noise */
    default: s += sine(turn, 150 - 150 * at / STRETCH);                                          /* a tone that fades */
    }
    return (int16_t)(s < 0 ? 0 : s > 4095 ? 4095 : s);
}
