/* A process that rounds otherwise or flushes denormal numbers is refused with a status, and accepted again afterwards.
 */
#include <fenv.h>
#include <netmesh.h>
#include <stdio.h>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

static uint64_t memory[1026];

static netmesh_status init(void) {
    const uintptr_t at = (uintptr_t)memory;
    netmesh_context* context;
    return netmesh_init((unsigned char*)memory + (16 - at % 16) % 16, 8192, &context);
}

int main(void) {
    const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    int i, refused = 0;
    if (init() != NETMESH_OK) return 1;
    for (i = 0; i < 3; ++i) {
        if (fesetround(modes[i]) != 0) return 2;
        if (init() != NETMESH_FLOATING_POINT) return 3;
        ++refused;
        fesetround(FE_TONEAREST);
    }
#ifdef __SSE2__
    for (i = 0; i < 2; ++i) {
        const unsigned before = _mm_getcsr();
        _mm_setcsr(before | (i == 0 ? 0x8000u : 0x0040u)); /* flush to zero; denormals are zero */
        if (init() != NETMESH_FLOATING_POINT) return 4;
        ++refused;
        _mm_setcsr(before);
    }
#endif
    if (init() != NETMESH_OK) return 5;
    printf("%d modes refused\n", refused);
    return 0;
}
