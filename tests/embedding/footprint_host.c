/* Runs a job of footprint.c in a static block, on a stack that is painted before and looked at after. Prints the peak
 * bytes of the block and those of the stack. callgrind counts the instructions of footprint_job. */
#define _GNU_SOURCE
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

void footprint_draw(void);
uint64_t footprint_job(void* block, size_t block_bytes);

static unsigned char block[BLOCK] __attribute__((aligned(16)));
static unsigned char stack[1 << 18] __attribute__((aligned(4096)));
static uint64_t peak;

static void* run(void* argument) {
    peak = footprint_job(block, sizeof block);
    /* From here down: what the job and all that it calls took. */
    *(uintptr_t*)argument = (uintptr_t)__builtin_frame_address(0);
    return NULL;
}

int main(void) {
    pthread_attr_t attributes;
    pthread_t thread;
    uintptr_t top = 0, lowest = 0;
    footprint_draw();
    memset(stack, 0x5A, sizeof stack);
    if (pthread_attr_init(&attributes) != 0 || pthread_attr_setstack(&attributes, stack, sizeof stack) != 0 ||
        pthread_create(&thread, &attributes, run, &top) != 0 || pthread_join(thread, NULL) != 0)
        return 1;
    while (lowest < sizeof stack && stack[lowest] == 0x5A) ++lowest;
    printf("%lu %lu\n", (unsigned long)peak, (unsigned long)(top - (uintptr_t)stack - lowest));
    return peak == 0;
}
