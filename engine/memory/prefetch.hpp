// Asking for memory before it is needed, where jumps about in it cost more than the code that asks.
#pragma once

namespace netmesh {

#ifdef __OPTIMIZE_SIZE__
constexpr bool jumps_matter = false;
#else
constexpr bool jumps_matter = true;
#endif

// Always inline: a function that does nothing but prefetch is taken for one without effect and dropped.
template <class T> [[gnu::always_inline]] inline void prefetch(const T* at) {
    if (jumps_matter) __builtin_prefetch(at);
}

}  // namespace netmesh
