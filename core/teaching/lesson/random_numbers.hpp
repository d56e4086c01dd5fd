#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace forefront {

/// The random numbers of a lesson that its texts and positions name, by these names.
using RandomNumbers = std::map<std::string, std::int64_t, std::less<>>;

/// The largest seed of a lesson. Seeds begin at 1.
inline constexpr std::int64_t kMaxLessonSeed = 1'000'000'000;

/// Returns a whole number from `from` to `to`, both included; the same for the same seed, page and name everywhere.
std::int64_t randomNumber(std::uint64_t seed, std::size_t page, std::string_view name, std::int64_t from,
                          std::int64_t to);
/// Returns a text in which each {name} of a random number is replaced by that number.
std::string withNumbers(std::string text, const RandomNumbers &numbers);

} // namespace forefront
