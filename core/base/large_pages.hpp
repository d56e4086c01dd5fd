#pragma once

#include <cstddef>
#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace forefront {

/// Asks the system to map the memory from `begin` on, before it is touched, in pages of 2 MiB where these fit inside:
/// a third of the cost of the first touch, and fewer misses of the address cache. No memory beyond the range is taken.
inline void preferLargePages(void *begin, std::size_t bytes) {
#ifdef __linux__
    constexpr std::uintptr_t kPage = 2U << 20U;
    const auto from = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t first = (from + kPage - 1) / kPage * kPage, last = (from + bytes) / kPage * kPage;
    if (first < last) {
        madvise(reinterpret_cast<void *>(first), last - first, MADV_HUGEPAGE); // only a wish: may fail
    }
#else
    static_cast<void>(begin);
    static_cast<void>(bytes);
#endif
}

} // namespace forefront
