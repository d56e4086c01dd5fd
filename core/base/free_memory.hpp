#pragma once

#include <cstdlib> // says which library it is
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace forefront {

/// Gives memory that is free but kept for later back to the system, where the library's allocator can: each thread
/// keeps some megabytes that large arrays and other threads do not use. Takes less than a millisecond.
inline void giveBackFreeMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace forefront
