/* The four functions that the engine asks for, counted as its own code is; sixteen bytes take as many instructions as
 * g++ makes of these loops, more than the C library's take. Hidden: shared libraries, whose code keeps something else
 * in r15, have their own. */
#include <stddef.h>

#pragma GCC visibility push(hidden)

void* memcpy(void* restrict to, const void* restrict from, size_t bytes) {
    unsigned char* a = to;
    const unsigned char* b = from;
    for (size_t i = 0; i < bytes; ++i) a[i] = b[i];
    return to;
}
typedef long long Words __attribute__((vector_size(16), aligned(1), may_alias));

void* memmove(void* to, const void* from, size_t bytes) {
    unsigned char* a = to;
    const unsigned char* b = from;
    const size_t apart = a < b ? (size_t)(b - a) : (size_t)(a - b);
    size_t i = 0;
    if (a <= b) {
        if (apart >= 16)
            for (; bytes - i >= 16; i += 16) *(Words*)(a + i) = *(const Words*)(b + i);
        for (; i < bytes; ++i) a[i] = b[i];
        return to;
    }
    i = bytes;
    if (apart >= 16)
        for (; i >= 16; i -= 16) *(Words*)(a + i - 16) = *(const Words*)(b + i - 16);
    for (; i > 0; --i) a[i - 1] = b[i - 1];
    return to;
}
void* memset(void* to, int value, size_t bytes) {
    unsigned char* a = to;
    for (size_t i = 0; i < bytes; ++i) a[i] = (unsigned char)value;
    return to;
}
int memcmp(const void* left, const void* right, size_t bytes) {
    const unsigned char *a = left, *b = right;
    for (size_t i = 0; i < bytes; ++i)
        if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
    return 0;
}
