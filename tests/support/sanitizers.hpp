#pragma once

#include <cstdint>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FOREFRONT_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FOREFRONT_SANITIZED 1
#endif
#endif

namespace forefront::testing {

/// True in builds with the address or thread sanitizer, which run 5 to 10 times slower: there the longest cases check
/// fewer domains, meshes or places.
#if defined(FOREFRONT_SANITIZED)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// The step between the seeds of random domains in the longest cases; not a divisor of the number of their families.
inline constexpr std::uint64_t kSeedStep = kSanitized ? 23 : 1;

} // namespace forefront::testing
