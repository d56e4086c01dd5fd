#pragma once

#include "core/engine/base/diagnostic.hpp"

#include <new>
#include <utility>

namespace forefront {

/// Returns the error "out-of-memory".
inline Diagnostics outOfMemory(const char *what, const char *advice = "") {
    return error("out-of-memory", std::string("not enough memory ") + what, advice);
}

/// Returns compute(), or the error "out-of-memory" if an allocation fails. `what`: the purpose of the memory, such as
/// "to check the mesh".
template <class Compute>
auto orOutOfMemory(const char *what, Compute &&compute) -> decltype(compute()) {
    try {
        return std::forward<Compute>(compute)();
    } catch (const std::bad_alloc &) {
        return outOfMemory(what);
    }
}

} // namespace forefront
