#include "core/io/png/inflate.hpp"

#include "core/io/common/deflate_classes.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace forefront {
namespace {

/// Reads bits, the lowest of each byte first. Behind the end there are zeros.
class BitReader {
  public:
    explicit BitReader(std::string_view bytes) : bytes_(bytes) {}

    /// Returns the next bits, at most 32, without taking them.
    std::uint32_t peek(unsigned count) {
        while (held_ < 32) {
            const std::uint64_t byte = at_ < bytes_.size() ? static_cast<std::uint8_t>(bytes_[at_]) : 0U;
            buffer_ |= byte << held_;
            held_ += 8;
            ++at_;
        }
        return static_cast<std::uint32_t>(buffer_ & ((std::uint64_t{1} << count) - 1));
    }
    void drop(unsigned count) {
        buffer_ >>= count;
        held_ -= count;
    }
    std::uint32_t take(unsigned count) {
        const std::uint32_t bits = peek(count);
        drop(count);
        return bits;
    }
    void skipToByte() { drop(held_ % 8); }
    /// Returns true if more bits were taken than there are.
    bool overrun() const { return at_ - held_ / 8 > bytes_.size(); }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0; ///< next byte for the buffer; may be behind the end
    std::uint64_t buffer_ = 0;
    unsigned held_ = 0; ///< bits in the buffer
};

/// A canonical prefix code of symbols: the shorter codes come first, those of one length in the order of the symbols.
class PrefixCode {
  public:
    static constexpr unsigned kLongest = 15;

    /// Sets the lengths of the codes by symbol; 0: the symbol has none. Returns false if there are too many of a
    /// length.
    bool set(std::span<const std::uint8_t> lengths) {
        std::array<std::uint32_t, kLongest + 2> next{};
        counts_.fill(0);
        for (const std::uint8_t length : lengths) {
            counts_[length] += length > 0 ? 1U : 0U;
        }
        std::uint32_t code = 0;
        std::uint32_t before = 0;
        for (unsigned length = 1; length <= kLongest; ++length) {
            code = (code + (length > 1 ? counts_[length - 1] : 0U)) << 1;
            first_[length] = code;
            offset_[length] = next[length] = before;
            before += counts_[length];
            if (code + counts_[length] > 1U << length) {
                return false;
            }
        }
        symbols_.assign(before, 0);
        quick_.fill({});
        for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
            if (const unsigned length = lengths[symbol]; length > 0) {
                const std::uint32_t place = next[length]++;
                symbols_[place] = static_cast<std::uint16_t>(symbol);
                enter(first_[length] + (place - offset_[length]), length, static_cast<std::uint16_t>(symbol));
            }
        }
        return true;
    }

    /// Reads a symbol; returns -1 if the bits are no code.
    int read(BitReader &bits) const {
        const Quick &quick = quick_[bits.peek(kQuickBits)];
        if (quick.length > 0) {
            bits.drop(quick.length);
            return quick.symbol;
        }
        const std::uint32_t ahead = bits.peek(kLongest);
        std::uint32_t code = 0;
        for (unsigned length = 1; length <= kLongest; ++length) {
            code = code << 1 | (ahead >> (length - 1) & 1U);
            if (code >= first_[length] && code - first_[length] < counts_[length]) {
                bits.drop(length);
                return symbols_[offset_[length] + (code - first_[length])];
            }
        }
        return -1;
    }

  private:
    static constexpr unsigned kQuickBits = 10;
    struct Quick {
        std::uint16_t symbol = 0;
        std::uint16_t length = 0; ///< 0: the code is longer than kQuickBits, or there is none
    };

    /// Enters a short code in the table of all values of the next bits; the first bit of a code is its highest.
    void enter(std::uint32_t code, unsigned length, std::uint16_t symbol) {
        if (length > kQuickBits) {
            return;
        }
        std::uint32_t reversed = 0;
        for (unsigned bit = 0; bit < length; ++bit) {
            reversed |= (code >> bit & 1U) << (length - 1 - bit);
        }
        for (std::uint32_t k = reversed; k < quick_.size(); k += 1U << length) {
            quick_[k] = {symbol, static_cast<std::uint16_t>(length)};
        }
    }

    std::array<Quick, std::size_t{1} << kQuickBits> quick_{};
    std::array<std::uint32_t, kLongest + 1> counts_{}; ///< codes by length
    std::array<std::uint32_t, kLongest + 1> first_{};  ///< first code of each length
    std::array<std::uint32_t, kLongest + 1> offset_{}; ///< its place in `symbols_`
    std::vector<std::uint16_t> symbols_;               ///< in the order of their codes
};

constexpr const char *kBadCode = "a code of the compressed data does not exist";
constexpr const char *kTooLong = "the compressed data has more bytes than the pixels need";

/// Decompresses one stream.
class Inflater {
  public:
    Inflater(std::string_view stream, std::vector<std::uint8_t> &bytes) : bits_(stream), bytes_(bytes) {}

    const char *run() {
        constexpr unsigned kDeflate = 8, kDictionary = 0x20;
        const unsigned method = bits_.take(8), flags = bits_.take(8);
        if ((method & 0xFU) != kDeflate || (method << 8 | flags) % 31 != 0 || (flags & kDictionary) != 0) {
            return "the compressed data does not begin like a zlib stream";
        }
        bool last = false;
        while (!last) {
            last = bits_.take(1) == 1;
            if (const char *const fault = block(bits_.take(2))) {
                return fault;
            }
        }
        return filled_ < bytes_.size() ? "the compressed data has fewer bytes than the pixels need" : nullptr;
    }

  private:
    const char *block(unsigned kind) {
        switch (kind) {
        case 0:
            return stored();
        case 1:
            setFixedCodes();
            return compressed();
        case 2:
            if (const char *const fault = readCodes()) {
                return fault;
            }
            return compressed();
        default:
            return "a block of the compressed data is of an unknown kind";
        }
    }

    const char *stored() {
        bits_.skipToByte();
        const std::uint32_t size = bits_.take(16), check = bits_.take(16);
        if ((size ^ check) != 0xFFFFU) {
            return "the size of a block of the compressed data is damaged";
        }
        if (size > bytes_.size() - filled_) {
            return kTooLong;
        }
        for (std::uint32_t k = 0; k < size; ++k) {
            bytes_[filled_++] = static_cast<std::uint8_t>(bits_.take(8));
        }
        return bits_.overrun() ? kShort : nullptr;
    }

    void setFixedCodes() {
        std::array<std::uint8_t, 288> lengths{};
        std::fill(lengths.begin(), lengths.begin() + 144, std::uint8_t{8});
        std::fill(lengths.begin() + 144, lengths.begin() + 256, std::uint8_t{9});
        std::fill(lengths.begin() + 256, lengths.begin() + 280, std::uint8_t{7});
        std::fill(lengths.begin() + 280, lengths.end(), std::uint8_t{8});
        literals_.set(lengths);
        std::array<std::uint8_t, 30> distances{};
        distances.fill(5);
        distances_.set(distances);
    }

    /// Reads the codes of a block: first the code of the lengths of the other two.
    const char *readCodes() {
        constexpr std::array<std::uint8_t, 19> kOrder{16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
        const std::size_t literals = 257 + bits_.take(5), distances = 1 + bits_.take(5), ordered = 4 + bits_.take(4);
        std::array<std::uint8_t, kOrder.size()> own{};
        for (std::size_t k = 0; k < ordered; ++k) {
            own[kOrder[k]] = static_cast<std::uint8_t>(bits_.take(3));
        }
        if (!lengths_.set(own)) {
            return kBadCode;
        }
        std::vector<std::uint8_t> lengths;
        while (lengths.size() < literals + distances) {
            const int symbol = lengths_.read(bits_);
            if (symbol < 0 || (symbol == 16 && lengths.empty())) {
                return kBadCode;
            }
            if (bits_.overrun()) {
                return kShort;
            }
            if (symbol < 16) {
                lengths.push_back(static_cast<std::uint8_t>(symbol));
                continue;
            }
            const std::uint32_t count = symbol == 16   ? 3 + bits_.take(2)
                                        : symbol == 17 ? 3 + bits_.take(3)
                                                       : 11 + bits_.take(7);
            lengths.insert(lengths.end(), count, symbol == 16 ? lengths.back() : std::uint8_t{0});
        }
        const std::span<const std::uint8_t> all = lengths;
        return lengths.size() == literals + distances && literals_.set(all.first(literals)) &&
                       distances_.set(all.subspan(literals))
                   ? nullptr
                   : kBadCode;
    }

    /// Reads a block of symbols up to its end.
    const char *compressed() {
        constexpr int kEnd = 256;
        while (true) {
            const int symbol = literals_.read(bits_);
            if (symbol == kEnd) {
                return bits_.overrun() ? kShort : nullptr;
            }
            if (symbol < 0) {
                return kBadCode;
            }
            if (bits_.overrun()) {
                return kShort;
            }
            if (symbol > kEnd) {
                if (const char *const fault = match(static_cast<std::size_t>(symbol - kEnd - 1))) {
                    return fault;
                }
            } else if (filled_ == bytes_.size()) {
                return kTooLong;
            } else {
                bytes_[filled_++] = static_cast<std::uint8_t>(symbol);
            }
        }
    }

    /// Copies earlier bytes; they may overlap their copy.
    const char *match(std::size_t lengthClass) {
        if (lengthClass >= kDeflateLengths.size()) {
            return kBadCode;
        }
        const std::size_t length = valueOf(kDeflateLengths[lengthClass]);
        const int distanceClass = distances_.read(bits_);
        if (distanceClass < 0 || static_cast<std::size_t>(distanceClass) >= kDeflateDistances.size()) {
            return kBadCode;
        }
        const std::size_t back = valueOf(kDeflateDistances[static_cast<std::size_t>(distanceClass)]);
        if (back > filled_) {
            return "the compressed data refers to bytes before its start";
        }
        if (length > bytes_.size() - filled_) {
            return kTooLong;
        }
        for (std::size_t k = 0; k < length; ++k, ++filled_) {
            bytes_[filled_] = bytes_[filled_ - back];
        }
        return nullptr;
    }
    std::size_t valueOf(DeflateClass range) { return range.first + bits_.take(range.extraBits); }

    static constexpr const char *kShort = "the compressed data ends early";

    BitReader bits_;
    std::vector<std::uint8_t> &bytes_;
    std::size_t filled_ = 0;
    PrefixCode lengths_, literals_, distances_;
};

} // namespace

const char *inflate(std::string_view stream, std::vector<std::uint8_t> &bytes) {
    return Inflater(stream, bytes).run();
}

} // namespace forefront
