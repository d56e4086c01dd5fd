#include "tests/unit/failing_new.hpp"

#include "tests/support/sanitizers.hpp"

#include <cstdlib>
#include <new>

namespace {

thread_local long allowedAllocations = -1; // before one fails; -1: any number

} // namespace

// Sanitizers check that memory is released by the function that belongs to the one it came from, and have operators of
// their own.
#if !defined(FOREFRONT_SANITIZED)

namespace {

void *allocate(std::size_t bytes) {
    if (allowedAllocations >= 0 && allowedAllocations-- == 0) {
        throw std::bad_alloc();
    }
    void *const memory = std::malloc(bytes == 0 ? 1 : bytes);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

} // namespace

void *operator new(std::size_t bytes) {
    return allocate(bytes);
}
void *operator new[](std::size_t bytes) {
    return allocate(bytes);
}
void operator delete(void *memory) noexcept {
    std::free(memory);
}
void operator delete[](void *memory) noexcept {
    std::free(memory);
}
void operator delete(void *memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void *memory, std::size_t) noexcept {
    std::free(memory);
}

#endif

namespace forefront::testing {

FailingNew::FailingNew(long allowed) {
    allowedAllocations = allowed;
}
FailingNew::~FailingNew() {
    allowedAllocations = -1;
}

} // namespace forefront::testing
