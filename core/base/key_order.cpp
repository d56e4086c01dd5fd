#include "core/base/key_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace forefront {
namespace {

constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr std::size_t kFew = 1000; ///< fewer keys are compared: the digits would take longer

struct Entry {
    std::uint64_t key;
    std::uint32_t item;
};

std::size_t digit(std::uint64_t key, unsigned shift) {
    return static_cast<std::size_t>(key >> shift) & (kDigits - 1);
}

/// Moves the entries to `to` in ascending order of one digit.
void distribute(const std::vector<Entry> &from, std::vector<Entry> &to, unsigned shift) {
    std::array<std::uint32_t, kDigits> next{};
    for (const Entry &entry : from) {
        ++next[digit(entry.key, shift)];
    }
    std::uint32_t first = 0;
    for (std::uint32_t &count : next) {
        first += std::exchange(count, first);
    }
    for (const Entry &entry : from) {
        to[next[digit(entry.key, shift)]++] = entry;
    }
}

bool before(const Entry &s, const Entry &t) {
    return s.key != t.key ? s.key < t.key : s.item < t.item;
}

/// Sorts by the upper digits of the bits that vary, which tell nearly all keys apart, then sorts each run of keys that
/// agree in them.
void sortByDigits(std::vector<Entry> &entries, std::uint64_t varying) {
    constexpr unsigned kUpper = 3 * kDigitBits;
    const auto bits = static_cast<unsigned>(std::bit_width(varying));
    const unsigned lowest = bits > kUpper ? bits - kUpper : 0;
    std::vector<Entry> other(entries.size());
    for (unsigned shift = lowest; shift < bits; shift += kDigitBits) {
        if (digit(varying, shift) != 0) {
            distribute(entries, other, shift);
            entries.swap(other);
        }
    }
    if (((varying >> lowest) << lowest) == varying) {
        return;
    }
    for (auto first = entries.begin(); first != entries.end();) {
        const std::uint64_t upper = first->key >> lowest;
        const auto last =
            std::find_if(first + 1, entries.end(), [=](const Entry &entry) { return entry.key >> lowest != upper; });
        if (!std::is_sorted(first, last, before)) {
            std::sort(first, last, before);
        }
        first = last;
    }
}

} // namespace

std::vector<std::uint32_t> orderByKeys(std::span<const std::uint64_t> keys) {
    std::vector<Entry> entries(keys.size());
    std::uint64_t varying = 0;
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
        entries[i] = {keys[i], i};
        varying |= keys[i] ^ keys[0];
    }
    if (entries.size() < kFew) {
        std::sort(entries.begin(), entries.end(), before);
    } else {
        sortByDigits(entries, varying);
    }
    std::vector<std::uint32_t> order(entries.size());
    std::transform(entries.begin(), entries.end(), order.begin(), [](const Entry &entry) { return entry.item; });
    return order;
}

} // namespace forefront
