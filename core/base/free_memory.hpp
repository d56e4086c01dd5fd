#pragma once

#include <cstdlib> // defines __GLIBC__ where it applies
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace forefront {

/// Returns unused memory from the allocator to the system, where the C library supports it. Each thread otherwise keeps
/// a few megabytes that large arrays and other threads cannot use. Takes less than a millisecond.
inline void releaseFreeMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace forefront
