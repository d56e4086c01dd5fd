// The programs' operator new: large arrays and the heap behind them get pages of 2 MiB. The library leaves operator new
// to the programs that use it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

namespace {

/// Asks the system for large pages where an array will be written, and from there to the end of the heap, so that
/// smaller arrays get them too. Unlike preferLargePages(), includes the pages that the array shares with others: arrays
/// of a few megabytes would else have half of their pages small. Free memory in such a page is taken from the system as
/// well, together at most a few megabytes.
void useLargePages(void *array, std::size_t bytes) {
    constexpr std::uintptr_t kPage = 2U << 20U;
    const auto begin = reinterpret_cast<std::uintptr_t>(array);
    const auto heapEnd = reinterpret_cast<std::uintptr_t>(sbrk(0));
    const std::uintptr_t first = begin / kPage * kPage;
    const std::uintptr_t last = begin < heapEnd ? heapEnd : (begin + bytes + kPage - 1) / kPage * kPage;
    auto *const page = static_cast<std::byte *>(array) - (begin - first);
    madvise(page, last - first, MADV_HUGEPAGE); // a hint; failure is harmless
}

} // namespace

void *operator new(std::size_t bytes) {
    constexpr std::size_t kLarge = 64 * 1024;
    void *memory = std::malloc(bytes > 0 ? bytes : 1);
    while (memory == nullptr) {
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) {
            throw std::bad_alloc();
        }
        handler();
        memory = std::malloc(bytes > 0 ? bytes : 1);
    }
    if (bytes >= kLarge) {
        useLargePages(memory, bytes);
    }
    return memory;
}

void operator delete(void *memory) noexcept {
    std::free(memory);
}

void operator delete(void *memory, std::size_t /*bytes*/) noexcept {
    std::free(memory);
}
