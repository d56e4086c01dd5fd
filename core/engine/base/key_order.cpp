#include "core/engine/base/key_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>

namespace forefront {
namespace {

constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr std::size_t kFew = 1000; ///< fewer keys are compared: the digits would take longer

/// The upper bits that vary of a key, and its index.
struct Entry {
    std::uint32_t upper = 0, item = 0;
};

std::size_t digit(std::uint32_t upper, unsigned shift) {
    return static_cast<std::size_t>(upper >> shift) & (kDigits - 1);
}

/// Moves the entries to `to` in ascending order of one digit.
void distribute(const std::vector<Entry> &from, std::vector<Entry> &to, unsigned shift) {
    std::array<std::uint32_t, kDigits> next{};
    for (const Entry &entry : from) {
        ++next[digit(entry.upper, shift)];
    }
    std::uint32_t first = 0;
    for (std::uint32_t &count : next) {
        first += std::exchange(count, first);
    }
    for (const Entry &entry : from) {
        to[next[digit(entry.upper, shift)]++] = entry;
    }
}

/// Returns the entries in ascending order of `upper`, those with the same one by index.
std::vector<Entry> sortedByDigits(std::span<const std::uint64_t> keys, unsigned bits, unsigned lowest) {
    std::vector<Entry> entries(keys.size()), other(keys.size());
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
        entries[i] = {static_cast<std::uint32_t>(keys[i] >> lowest), i};
    }
    for (unsigned shift = 0; shift + lowest < bits; shift += kDigitBits) {
        distribute(entries, other, shift);
        entries.swap(other);
    }
    return entries;
}

} // namespace

std::vector<std::uint32_t> orderByKeys(std::span<const std::uint64_t> keys) {
    std::vector<std::uint32_t> order(keys.size());
    const auto before = [&](std::uint32_t i, std::uint32_t j) {
        return keys[i] != keys[j] ? keys[i] < keys[j] : i < j;
    };
    if (keys.size() < kFew) {
        std::iota(order.begin(), order.end(), 0U);
        std::sort(order.begin(), order.end(), before);
        return order;
    }
    std::uint64_t varying = 0;
    for (const std::uint64_t key : keys) {
        varying |= key ^ keys[0];
    }
    constexpr unsigned kUpper = 32;
    const auto bits = static_cast<unsigned>(std::bit_width(varying));
    const unsigned lowest = bits > kUpper ? bits - kUpper : 0;
    const std::vector<Entry> entries = sortedByDigits(keys, bits, lowest);
    std::transform(entries.begin(), entries.end(), order.begin(), [](const Entry &entry) { return entry.item; });
    if (((varying >> lowest) << lowest) != varying) { // keys may differ in their lower bits alone
        for (std::size_t first = 0, last = 0; first < entries.size(); first = last) {
            while (last < entries.size() && entries[last].upper == entries[first].upper) {
                ++last;
            }
            const auto run = order.begin() + static_cast<std::ptrdiff_t>(first);
            const auto end = order.begin() + static_cast<std::ptrdiff_t>(last);
            if (last - first > 1 && !std::is_sorted(run, end, before)) {
                std::sort(run, end, before);
            }
        }
    }
    return order;
}

} // namespace forefront
