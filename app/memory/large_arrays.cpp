// The programs' operator new: large arrays and the heap behind them get pages of 2 MiB. The library leaves operator new
// to the programs that use it.
#include "core/engine/platform/large_pages.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

extern "C" char _end; // NOLINT: the linker sets it to the end of the program, where the heap begins

namespace {

/// Asks the system for large pages where an array will be written. In the heap, does so from there to the end, so that
/// smaller arrays get them too, and includes the page in which the array begins: otherwise half the pages of an array
/// of a few megabytes would stay small. A large page takes 2 MiB, however little of it is in use.
void useLargePages(void *array, std::size_t bytes) {
    const int error = errno;
    constexpr std::uintptr_t kPage = 2U << 20U;
    const auto begin = reinterpret_cast<std::uintptr_t>(array);
    const auto heap = reinterpret_cast<std::uintptr_t>(&_end);
    const auto heapEnd = reinterpret_cast<std::uintptr_t>(sbrk(0));
    if (begin >= heap && begin < heapEnd) {
        const std::uintptr_t first = std::max(begin / kPage * kPage, (heap + kPage - 1) / kPage * kPage);
        auto *const page = static_cast<std::byte *>(array) - begin + first;
        if (first < heapEnd) {
            madvise(page, heapEnd - first, MADV_HUGEPAGE); // a hint; failure is harmless
        }
    } else {
        forefront::preferLargePages(array, bytes);
    }
    errno = error;
}

/// Returns what allocate() returns, after it called the new-handler as often as needed and possible.
template <class Allocate>
void *allocated(std::size_t bytes, const Allocate &allocate) {
    constexpr std::size_t kLarge = 64 * 1024;
    void *memory = allocate();
    while (memory == nullptr) {
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) {
            throw std::bad_alloc();
        }
        handler();
        memory = allocate();
    }
    if (bytes >= kLarge) {
        useLargePages(memory, bytes);
    }
    return memory;
}

} // namespace

void *operator new(std::size_t bytes) {
    return allocated(bytes, [bytes] { return std::malloc(bytes > 0 ? bytes : 1); });
}

void *operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocated(bytes, [bytes, alignment]() -> void * {
        void *memory = nullptr;
        const std::size_t step = std::max(static_cast<std::size_t>(alignment), sizeof(void *));
        return posix_memalign(&memory, step, bytes > 0 ? bytes : 1) == 0 ? memory : nullptr;
    });
}

void operator delete(void *memory) noexcept {
    std::free(memory);
}

void operator delete(void *memory, std::size_t /*bytes*/) noexcept {
    std::free(memory);
}

void operator delete(void *memory, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}

void operator delete(void *memory, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}
