#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A random number of a lesson: how it is drawn.
struct RandomRange {
    std::size_t page = 0; ///< that draws it
    std::string name;
    std::int64_t from = 0, to = 0; ///< both included; from < to

    friend bool operator==(const RandomRange &, const RandomRange &) = default;
};

/// A random number that was drawn.
struct RandomNumber {
    std::int64_t value = 0;
    std::int64_t from = 0; ///< the smallest that another seed may draw
};

/// The random numbers of a lesson that its texts and positions name, by these names.
using RandomNumbers = std::map<std::string, RandomNumber, std::less<>>;

/// The largest seed of a lesson. Seeds begin at 1.
inline constexpr std::int64_t kMaxLessonSeed = 1'000'000'000;

/// Returns a whole number from `from` to `to`, both included; the same for the same seed, page and name everywhere.
std::int64_t randomNumber(std::uint64_t seed, const RandomRange &range);
/// Returns a text in which each {name} of a random number, in formulas \value{name}, is replaced by that number.
std::string withNumbers(std::string_view text, const RandomNumbers &numbers);
/// Returns true if a text names a random number, as withNumbers() replaces it or, if it is a formula, as a word.
bool namesNumber(std::string_view text, const RandomNumbers &numbers, bool isFormula);

/// The largest range all of whose numbers are checked.
inline constexpr std::uint64_t kMaxValues = 64;

/// The seeds by which the questions of a lesson are checked.
struct SeedsToCheck {
    std::vector<std::uint64_t> seeds; ///< increasing; the first is 1
    bool all = false;                 ///< they draw every number of every range, not only samples of the large ones
};
/// Returns seeds that together draw every number of each range of at most kMaxValues numbers. Larger ranges are drawn
/// from in kMaxValues places along their length, and at their ends if one of the first 20,000 seeds draws those.
SeedsToCheck seedsToCheck(const std::vector<RandomRange> &ranges);

} // namespace forefront
