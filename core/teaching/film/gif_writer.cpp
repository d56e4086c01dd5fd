#include "core/teaching/film/gif_writer.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

void appendShort(std::string &bytes, int value) {
    bytes += static_cast<char>(value & 0xFF);
    bytes += static_cast<char>(value >> 8 & 0xFF);
}

/// Compresses 8-bit indices with GIF's variable-length codes (Lempel-Ziv-Welch).
class LzwEncoder {
  public:
    std::string encode(const std::vector<std::uint8_t> &pixels) {
        put(kClear);
        std::uint32_t prefix = pixels.front();
        for (std::size_t k = 1; k < pixels.size(); ++k) {
            std::uint32_t &slot = find(prefix << 8 | pixels[k]);
            if (slot != 0) {
                prefix = slot & kCodeMask;
                continue;
            }
            put(prefix);
            addCode(slot, prefix << 8 | pixels[k]);
            prefix = pixels[k];
        }
        put(prefix);
        put(kEnd);
        if (bits_ > 0) {
            bytes_ += static_cast<char>(buffer_ & 0xFF);
        }
        return std::move(bytes_);
    }

  private:
    static constexpr std::uint32_t kClear = 256, kEnd = 257, kFirst = 258, kCodes = 4096;
    static constexpr std::uint32_t kSlots = 16384, kCodeMask = kCodes - 1;

    /// Returns the table slot of a string, whose key is its prefix's code and last index. A slot holds the key above 12
    /// bits of code, or 0 if the string is unknown.
    std::uint32_t &find(std::uint32_t key) {
        std::uint32_t place = key * 2654435761U >> 18;
        while (table_[place] != 0 && table_[place] >> 12 != key) {
            place = (place + 1) % kSlots;
        }
        return table_[place];
    }
    void addCode(std::uint32_t &slot, std::uint32_t key) {
        if (next_ == kCodes) {
            put(kClear);
            std::fill(table_.begin(), table_.end(), 0U);
            next_ = kFirst;
            size_ = 9;
            return;
        }
        slot = key << 12 | next_;
        if (next_ == 1U << size_) {
            ++size_;
        }
        ++next_;
    }
    void put(std::uint32_t code) {
        buffer_ |= static_cast<std::uint64_t>(code) << bits_;
        for (bits_ += size_; bits_ >= 8; bits_ -= 8) {
            bytes_ += static_cast<char>(buffer_ & 0xFF);
            buffer_ >>= 8;
        }
    }

    std::vector<std::uint32_t> table_ = std::vector<std::uint32_t>(kSlots, 0U);
    std::uint32_t next_ = kFirst;
    unsigned size_ = 9, bits_ = 0;
    std::uint64_t buffer_ = 0;
    std::string bytes_;
};

/// A rectangle of pixels.
struct PixelPart {
    int left = 0, top = 0, width = 0, height = 0;
};

/// Returns the smallest rectangle that holds all changed pixels; one pixel if there are none.
PixelPart changedPart(const FilmPicture &last, const FilmPicture &now) {
    if (last.pixels.empty()) {
        return {0, 0, now.width, now.height};
    }
    int left = now.width, right = -1, top = now.height, bottom = -1;
    for (int y = 0; y < now.height; ++y) {
        for (int x = 0; x < now.width; ++x) {
            if (last.row(y)[x] != now.row(y)[x]) {
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = y;
            }
        }
    }
    return right < 0 ? PixelPart{0, 0, 1, 1} : PixelPart{left, top, right - left + 1, bottom - top + 1};
}

/// Returns the pixels of a rectangle; unchanged ones become kUnchangedPixel.
std::vector<std::uint8_t> pixelsOf(const PixelPart &part, const FilmPicture &last, const FilmPicture &now) {
    std::vector<std::uint8_t> pixels;
    for (int y = part.top; y < part.top + part.height; ++y) {
        for (int x = part.left; x < part.left + part.width; ++x) {
            const std::uint8_t pixel = now.row(y)[x];
            const bool same = !last.pixels.empty() && last.row(y)[x] == pixel;
            pixels.push_back(same ? kUnchangedPixel : pixel);
        }
    }
    return pixels;
}

} // namespace

GifWriter::GifWriter(ByteSink &sink, int width, int height, int delay) : sink_(sink), delay_(delay) {
    std::string head = "GIF89a";
    appendShort(head, width);
    appendShort(head, height);
    head += std::string_view("\xf7\0\0", 3); // a palette of 256 colours follows
    for (const std::uint8_t part : filmPalette()) {
        head += static_cast<char>(part);
    }
    head += std::string_view("!\xff\x0bNETSCAPE2.0\x03\x01\0\0\0", 19); // loops forever
    written_ = sink_.write(head);
}

bool GifWriter::add(const FilmPicture &picture) {
    const PixelPart part = changedPart(last_, picture);
    std::string bytes("!\xf9\x04\x05", 4); // keep the frame as background; one index is transparent
    appendShort(bytes, delay_);
    bytes += static_cast<char>(kUnchangedPixel);
    bytes += std::string_view("\0,", 2);
    for (const int value : {part.left, part.top, part.width, part.height}) {
        appendShort(bytes, value);
    }
    bytes += std::string_view("\0\x08", 2); // uses the common palette; 8-bit indices
    const std::string data = LzwEncoder().encode(pixelsOf(part, last_, picture));
    for (std::size_t at = 0; at < data.size(); at += 255) {
        const std::string_view block = std::string_view(data).substr(at, 255);
        bytes += static_cast<char>(block.size());
        bytes += block;
    }
    bytes += '\0';
    last_ = picture;
    written_ = written_ && sink_.write(bytes);
    return written_;
}

bool GifWriter::finish() {
    written_ = written_ && sink_.write(";");
    return written_;
}

} // namespace forefront
