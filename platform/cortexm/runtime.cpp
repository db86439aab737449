// What a compiler expects of every target and finds here instead of in a C library.
#include <cstddef>

extern "C" {

void* memset(void* to, int value, std::size_t count) {
    unsigned char* p = static_cast<unsigned char*>(to);
    for (; count > 0; --count) *p++ = static_cast<unsigned char>(value);
    return to;
}

void* memcpy(void* to, const void* from, std::size_t count) {
    unsigned char* p = static_cast<unsigned char*>(to);
    const unsigned char* q = static_cast<const unsigned char*>(from);
    for (; count > 0; --count) *p++ = *q++;
    return to;
}

void* memmove(void* to, const void* from, std::size_t count) {
    unsigned char* p = static_cast<unsigned char*>(to);
    const unsigned char* q = static_cast<const unsigned char*>(from);
    if (p <= q) return memcpy(to, from, count);
    while (count-- > 0) p[count] = q[count];
    return to;
}

int memcmp(const void* a, const void* b, std::size_t count) {
    const unsigned char *p = static_cast<const unsigned char*>(a), *q = static_cast<const unsigned char*>(b);
    for (; count > 0; --count, ++p, ++q)
        if (*p != *q) return *p < *q ? -1 : 1;
    return 0;
}
}
