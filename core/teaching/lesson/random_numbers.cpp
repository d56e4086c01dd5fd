#include "core/teaching/lesson/random_numbers.hpp"

#include "core/teaching/markup/text_values.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace forefront {

namespace {

/// The finalizer of SplitMix64 (Steele, Lea and Flood, 2014), which spreads neighbouring numbers over all bits.
std::uint64_t mixed(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

/// The numbers of a range that seeds have drawn so far, by parts of equal length.
class DrawnNumbers {
  public:
    explicit DrawnNumbers(const RandomRange &range)
        : range_(range), count_(static_cast<std::uint64_t>(range.to - range.from) + 1U),
          width_((count_ + kMaxValues - 1) / kMaxValues) {
        for (std::uint64_t part = 0; part * width_ < count_; ++part) {
            missing_.insert(part);
        }
        missing_.insert({kFirst, kLast});
    }

    /// Returns true if every number is a part of its own.
    bool wholly() const { return width_ == 1; }
    bool complete() const { return missing_.empty(); }
    /// Draws the number of a seed; returns true if it is an end of the range, or the first of its part.
    bool draw(std::uint64_t seed) {
        const auto number = static_cast<std::uint64_t>(randomNumber(seed, range_) - range_.from);
        const std::size_t end = number == 0 ? missing_.erase(kFirst) : number + 1 == count_ ? missing_.erase(kLast) : 0;
        return missing_.erase(number / width_) + end > 0;
    }

  private:
    static constexpr std::uint64_t kFirst = kMaxValues, kLast = kMaxValues + 1; ///< the ends, beside the parts

    RandomRange range_;
    std::uint64_t count_, width_; ///< numbers in the range, and in a part of it
    std::set<std::uint64_t> missing_;
};

} // namespace

std::int64_t randomNumber(std::uint64_t seed, const RandomRange &range) {
    std::uint64_t bits = mixed(mixed(seed) ^ static_cast<std::uint64_t>(range.page));
    for (const char c : range.name) {
        bits = mixed(bits ^ static_cast<unsigned char>(c));
    }
    const std::uint64_t count = static_cast<std::uint64_t>(range.to) - static_cast<std::uint64_t>(range.from) + 1U;
    return range.from + static_cast<std::int64_t>(bits % count);
}

std::string withNumbers(std::string_view text, const RandomNumbers &numbers) {
    return withValuesReplaced(text, [&](std::string_view word) -> std::optional<std::string> {
        const auto number = numbers.find(word);
        return number == numbers.end() ? std::nullopt : std::optional(std::to_string(number->second.value));
    });
}

bool namesNumber(std::string_view text, const RandomNumbers &numbers, bool isFormula) {
    if (!isFormula) {
        const std::vector<NamedValue> named = valuesNamed(text);
        return std::any_of(named.begin(), named.end(),
                           [&](const NamedValue &value) { return numbers.find(value.word) != numbers.end(); });
    }
    const auto inWord = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
               static_cast<unsigned char>(c) >= 0x80;
    };
    return std::any_of(numbers.begin(), numbers.end(), [&](const RandomNumbers::value_type &number) {
        const std::string &name = number.first;
        for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
            const std::size_t end = at + name.size();
            if ((at == 0 || !inWord(text[at - 1])) && (end == text.size() || !inWord(text[end]))) {
                return true;
            }
        }
        return false;
    });
}

SeedsToCheck seedsToCheck(const std::vector<RandomRange> &ranges) {
    constexpr std::uint64_t kMaxTried = 20'000; // 64 parts are drawn from in a few hundred
    std::vector<DrawnNumbers> drawn(ranges.begin(), ranges.end());
    SeedsToCheck found;
    found.all = std::all_of(drawn.begin(), drawn.end(), [](const DrawnNumbers &range) { return range.wholly(); });
    for (std::uint64_t seed = 1; seed <= kMaxTried; ++seed) {
        bool isNew = seed == 1, complete = true;
        for (DrawnNumbers &range : drawn) {
            isNew = range.draw(seed) || isNew;
            complete = complete && range.complete();
        }
        if (isNew) {
            found.seeds.push_back(seed);
        }
        if (complete) {
            break;
        }
    }
    return found;
}

} // namespace forefront
