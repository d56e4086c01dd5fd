#pragma once

#include <cstdio>
#include <cstdlib>

/// Aborts if an invariant of our own code is broken. Active wherever FOREFRONT_ASSERTS is set, also in optimised
/// builds. Not for bad input, which is reported as Diagnostics.
#if defined(FOREFRONT_ASSERTS)
#define FOREFRONT_ASSERT(condition)                                                                                    \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            std::fprintf(stderr, "%s:%d: invariant broken: %s\n", __FILE__, __LINE__, #condition);                     \
            std::abort();                                                                                              \
        }                                                                                                              \
    } while (false)
#else
#define FOREFRONT_ASSERT(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif
