#include "core/teaching/lesson/random_numbers.hpp"

namespace forefront {

namespace {

/// The finalizer of SplitMix64 (Steele, Lea and Flood, 2014), which spreads neighbouring numbers over all bits.
std::uint64_t mixed(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

} // namespace

std::int64_t randomNumber(std::uint64_t seed, std::size_t page, std::string_view name, std::int64_t from,
                          std::int64_t to) {
    std::uint64_t bits = mixed(mixed(seed) ^ static_cast<std::uint64_t>(page));
    for (const char c : name) {
        bits = mixed(bits ^ static_cast<unsigned char>(c));
    }
    const std::uint64_t count = static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from) + 1U;
    return from + static_cast<std::int64_t>(bits % count);
}

std::string withNumbers(std::string text, const RandomNumbers &numbers) {
    for (const auto &[name, number] : numbers) {
        const std::string word = '{' + name + '}';
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
            text.replace(at, word.size(), std::to_string(number));
        }
    }
    return text;
}

} // namespace forefront
