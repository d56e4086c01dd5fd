#pragma once

#include <cstdlib> // defines __GLIBC__ where it applies
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace forefront {

/// Returns unused memory from the allocator to the system, where the C library supports it. Each thread otherwise keeps
/// a few megabytes that large arrays and other threads cannot use. Takes less than a millisecond. Threads may call it
/// at the same time.
inline void releaseFreeMemory() {
#ifdef __GLIBC__
    // In a program with another allocator (jemalloc, the address sanitizer) the first call sets up the one of the C
    // library, and a second thread would find it half set up. So others wait until a first call has ended.
    [[maybe_unused]] static const int first = malloc_trim(0);
    malloc_trim(0);
#endif
}

/// Makes the allocator keep the memory of freed arrays for later ones. Otherwise the GNU C library returns every large
/// array to the system at once, and the next one is made of new pages, which the system must clear: a tenth of the time
/// to prepare a large mesh. The heap then grows by 32 MiB at a time, so that whole large pages fit. For programs
/// that mesh and end; one that goes on should give its memory back.
inline void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int kStep = 32 << 20;
    mallopt(M_TOP_PAD, kStep);
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1); // never
#endif
}

} // namespace forefront
