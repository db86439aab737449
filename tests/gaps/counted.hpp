// What an engine made by `counting` says of itself.
#pragma once
#include <cstdint>

// Instructions so far of all that `counting` compiled: the engine, this program and memory.c.
inline std::uint64_t counted() {
    std::uint64_t count;
    asm volatile("movq %%r15, %0" : "=r"(count));
    return count;
}

// How instructions of ten jobs grow from 10,000 to 100,000 points; 1 when one grows by more than is stated
// (growth.cpp).
int check_growth();
