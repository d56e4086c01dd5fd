#pragma once

#include "core/engine/platform/large_pages.hpp"

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace forefront {

/// An allocator that leaves new elements uninitialised, so that the threads that write them touch the memory first, not
/// the thread that allocates it. Uses large pages where available.
template <class T>
struct RawAllocator : std::allocator<T> {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
    template <class U>
    struct rebind { // NOLINT: the standard prescribes the name
        using other = RawAllocator<U>;
    };

    RawAllocator() = default;
    template <class U>
    explicit RawAllocator(const RawAllocator<U> &) {}

    T *allocate(std::size_t count) {
        T *const memory = std::allocator<T>::allocate(count);
        preferLargePages(memory, count * sizeof(T) / 16 * 15); // the rest may be spare capacity
        return memory;
    }
    template <class U>
    void construct(U *) noexcept {}
    template <class U, class... Arguments>
    void construct(U *place, Arguments &&...arguments) {
        std::construct_at(place, std::forward<Arguments>(arguments)...);
    }
};

/// A vector whose resize(n) leaves new elements uninitialised: write each before reading it.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

} // namespace forefront
