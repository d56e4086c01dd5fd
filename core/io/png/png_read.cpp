#include "core/base/cancelled.hpp"
#include "core/io/common/crc32.hpp"
#include "core/io/png/inflate.hpp"
#include "core/io/png/png.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <string>
#include <utility>

namespace forefront {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t kMaxPixels = 100'000'000;
constexpr unsigned kPaletteBit = 1, kColourBit = 2, kAlphaBit = 4;
constexpr const char *kSaveAgain = "open it in another program and save it as PNG";

std::uint8_t byteAt(std::string_view bytes, std::size_t at) {
    return static_cast<std::uint8_t>(bytes[at]);
}

/// Returns the four bytes as a number, the highest first.
std::size_t longAt(std::string_view bytes, std::size_t at) {
    std::size_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        value = value << 8 | byteAt(bytes, at + k);
    }
    return value;
}

Diagnostics badPicture(const SourceText &source, std::size_t offset, const std::string &what) {
    return {faultAt(source, offset, "bad-picture", "cannot decode the picture: " + what, kSaveAgain)};
}

/// The number of samples of a pixel.
unsigned channelsOf(const PngHeader &header) {
    return (header.colour & kPaletteBit) != 0
               ? 1
               : ((header.colour & kColourBit) != 0 ? 3U : 1U) + ((header.colour & kAlphaBit) != 0 ? 1U : 0U);
}

/// Returns true if the format allows samples of this depth for the kind of colour.
bool allowedDepth(unsigned colour, unsigned depth) {
    switch (colour) {
    case 0:
        return depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
    case kPaletteBit | kColourBit:
        return depth == 1 || depth == 2 || depth == 4 || depth == 8;
    case kColourBit:
    case kAlphaBit:
    case kColourBit | kAlphaBit:
        return depth == 8 || depth == 16;
    default:
        return false;
    }
}

/// The pixels of one pass over a picture: every `stepX`-th column and every `stepY`-th row.
struct Pass {
    std::size_t x = 0, y = 0, stepX = 1, stepY = 1;

    std::size_t columns(const PngHeader &h) const { return h.columns > x ? (h.columns - x + stepX - 1) / stepX : 0; }
    std::size_t rows(const PngHeader &h) const { return h.rows > y ? (h.rows - y + stepY - 1) / stepY : 0; }
    /// Returns the number of bytes of a row without its filter.
    std::size_t rowBytes(const PngHeader &h) const { return (columns(h) * channelsOf(h) * h.depth + 7) / 8; }
    std::size_t bytes(const PngHeader &h) const { return columns(h) == 0 ? 0 : rows(h) * (rowBytes(h) + 1); }
};
constexpr std::array<Pass, 1> kWhole{};
constexpr std::array<Pass, 7> kInterlaced{
    {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};

std::span<const Pass> passesOf(const PngHeader &header) {
    return header.interlaced ? std::span<const Pass>(kInterlaced) : std::span<const Pass>(kWhole);
}

/// Averages grey values over the rectangles of pixels of a coarser picture.
class GreyMeans {
  public:
    GreyMeans(const PngHeader &header, GreyCounts counts)
        : header_(header), counts_(counts), cells_(counts.columns * counts.rows) {}

    /// Adds a luminance between 0 and kWhite, or a transparent pixel.
    void add(std::size_t x, std::size_t y, std::uint64_t luminance, bool transparent) {
        Cell &cell = cells_[y * counts_.rows / header_.rows * counts_.columns + x * counts_.columns / header_.columns];
        cell.sum += transparent ? 0 : luminance;
        ++(transparent ? cell.transparent : cell.opaque);
    }
    std::vector<double> values() const {
        std::vector<double> values;
        values.reserve(cells_.size());
        for (const Cell &cell : cells_) {
            values.push_back(cell.opaque == 0 || cell.opaque < cell.transparent
                                 ? kNoGrey
                                 : static_cast<double>(cell.sum) / static_cast<double>(cell.opaque) /
                                       static_cast<double>(kWhite));
        }
        return values;
    }
    static constexpr std::uint64_t kWhite = std::uint64_t{65535} * 10000;

  private:
    struct Cell {
        std::uint64_t sum = 0;
        std::uint32_t opaque = 0, transparent = 0; ///< pixels
    };
    PngHeader header_;
    GreyCounts counts_;
    std::vector<Cell> cells_;
};

/// Reads the samples of unfiltered rows as luminance.
class PixelReader {
  public:
    using Colour = std::array<std::uint32_t, 4>; ///< red, green, blue, alpha, up to 65535

    PixelReader(const PngHeader &header, std::string_view palette, std::string_view transparency)
        : header_(header), channels_(channelsOf(header)) {
        const bool indexed = (header.colour & kPaletteBit) != 0;
        for (std::size_t k = 0; indexed && 3 * k + 2 < palette.size(); ++k) {
            palette_.push_back({byteAt(palette, 3 * k) * 257U, byteAt(palette, 3 * k + 1) * 257U,
                                byteAt(palette, 3 * k + 2) * 257U,
                                k < transparency.size() ? byteAt(transparency, k) * 257U : 65535U});
        }
        if (!indexed && (header.colour & kAlphaBit) == 0 && transparency.size() == 2 * std::size_t{channels_}) {
            hasKey_ = true;
            for (std::size_t k = 0; k < channels_; ++k) {
                key_[k] = byteAt(transparency, 2 * k) * 256U + byteAt(transparency, 2 * k + 1);
            }
        }
    }
    /// Adds pixel `k` of a row, which lies at (x, y). Returns false if it has an unknown colour.
    bool add(std::span<const std::uint8_t> row, std::size_t k, std::size_t x, std::size_t y, GreyMeans &means) const {
        std::array<std::uint32_t, 4> samples{};
        for (unsigned channel = 0; channel < channels_; ++channel) {
            samples[channel] = sample(row, k * channels_ + channel);
        }
        Colour colour{};
        if ((header_.colour & kPaletteBit) != 0) {
            if (samples[0] >= palette_.size()) {
                return false;
            }
            colour = palette_[samples[0]];
        } else {
            const std::uint32_t scale = 65535U / ((1U << header_.depth) - 1U);
            const bool coloured = (header_.colour & kColourBit) != 0;
            colour = {samples[0] * scale, samples[coloured ? 1 : 0] * scale, samples[coloured ? 2 : 0] * scale, 65535U};
            if ((header_.colour & kAlphaBit) != 0) {
                colour[3] = samples[channels_ - 1];
            } else if (hasKey_ && std::equal(key_.begin(), key_.begin() + channels_, samples.begin())) {
                colour[3] = 0;
            }
        }
        means.add(x, y, std::uint64_t{2126} * colour[0] + std::uint64_t{7152} * colour[1] + 722U * colour[2],
                  colour[3] == 0);
        return true;
    }

  private:
    std::uint32_t sample(std::span<const std::uint8_t> row, std::size_t k) const {
        switch (header_.depth) {
        case 8:
            return row[k];
        case 16:
            return row[2 * k] * 256U + row[2 * k + 1];
        default: {
            const std::size_t bit = k * header_.depth;
            return row[bit / 8] >> (8 - header_.depth - bit % 8) & ((1U << header_.depth) - 1U);
        }
        }
    }

    PngHeader header_;
    unsigned channels_;
    std::vector<Colour> palette_;
    bool hasKey_ = false;
    std::array<std::uint32_t, 4> key_{}; ///< samples of the transparent colour
};

/// Returns the predictor of Paeth for a byte, from those to the left, above, and above to the left.
int paeth(int left, int above, int corner) {
    const int guess = left + above - corner;
    const int toLeft = std::abs(guess - left), toAbove = std::abs(guess - above), toCorner = std::abs(guess - corner);
    return toLeft <= toAbove && toLeft <= toCorner ? left : toAbove <= toCorner ? above : corner;
}

/// Undoes the filter of a row; `above` is empty for the first one. Returns false if the filter is unknown.
bool unfilter(unsigned filter, std::span<std::uint8_t> row, std::span<const std::uint8_t> above, std::size_t pixel) {
    if (filter > 4) {
        return false;
    }
    for (std::size_t k = 0; filter > 0 && k < row.size(); ++k) {
        const int left = k >= pixel ? row[k - pixel] : 0;
        const int up = above.empty() ? 0 : above[k];
        const int corner = k >= pixel && !above.empty() ? above[k - pixel] : 0;
        const int guess = filter == 1   ? left
                          : filter == 2 ? up
                          : filter == 3 ? (left + up) / 2
                                        : paeth(left, up, corner);
        row[k] = static_cast<std::uint8_t>(row[k] + guess);
    }
    return true;
}

/// Reads the chunks of a file, then its pixels.
class PngReader {
  public:
    PngReader(const SourceText &source, const PngHeader &header) : source_(source), header_(header) {}

    Result<GreyPicture> read(std::size_t most) {
        if (Diagnostics faults = chunks(); !faults.empty()) {
            return faults;
        }
        std::size_t size = 0;
        for (const Pass &pass : passesOf(header_)) {
            size += pass.bytes(header_);
        }
        // Checked before memory is allocated for what the header promises.
        if (size / kMaxInflation > data_.size()) {
            return badPicture(source_, dataOffset_, "the compressed data has fewer bytes than the pixels need");
        }
        std::vector<std::uint8_t> bytes(size);
        if (const char *const fault = inflate(data_, bytes)) {
            return badPicture(source_, dataOffset_, fault);
        }
        data_ = {};
        GreyPicture picture;
        picture.header = header_;
        const GreyCounts counts = greyCounts(header_.columns, header_.rows, most);
        picture.columns = counts.columns;
        picture.rows = counts.rows;
        GreyMeans means(header_, counts);
        if (Diagnostics faults = pixels(bytes, means); !faults.empty()) {
            return faults;
        }
        picture.values = means.values();
        return picture;
    }

  private:
    Diagnostics chunks() {
        const std::string_view text = source_.text;
        std::size_t at = PngHeader::kBytes;
        for (std::string_view kind; kind != "IEND";) {
            constexpr std::size_t kFrame = 12; // length, kind and check sum
            if (text.size() - at < kFrame || longAt(text, at) > text.size() - at - kFrame) {
                return badPicture(source_, at, "the file ends early");
            }
            const std::size_t length = longAt(text, at);
            kind = text.substr(at + 4, 4);
            const std::string_view content = text.substr(at + 8, length);
            if (longAt(text, at + 8 + length) != crc32(text.substr(at + 4, length + 4))) {
                return badPicture(source_, at, "the part " + inQuotes(kind) + " is damaged");
            }
            if (!use(kind, content, at)) {
                return badPicture(source_, at, "the part " + inQuotes(kind) + " is unknown");
            }
            at += kFrame + length;
        }
        if (header_.colour == (kPaletteBit | kColourBit) && palette_.empty()) {
            return badPicture(source_, 0, "it has no palette");
        }
        return {};
    }
    /// Uses the content of a chunk. Returns false if the picture cannot be read without knowing it.
    bool use(std::string_view kind, std::string_view content, std::size_t at) {
        if (kind == "IDAT") {
            dataOffset_ = data_.empty() ? at : dataOffset_;
            data_ += content;
        } else if (kind == "PLTE") {
            palette_ = content;
        } else if (kind == "tRNS") {
            transparency_ = content;
        }
        const bool optional = (byteAt(kind, 0) & 0x20U) != 0;
        return optional || kind == "IDAT" || kind == "PLTE" || kind == "IEND";
    }

    Diagnostics pixels(std::vector<std::uint8_t> &bytes, GreyMeans &means) const {
        const PixelReader reader(header_, palette_, transparency_);
        const std::size_t pixel = std::max<std::size_t>(1, channelsOf(header_) * header_.depth / 8);
        std::size_t at = 0;
        for (const Pass &pass : passesOf(header_)) {
            const std::size_t columns = pass.columns(header_), rowBytes = pass.rowBytes(header_);
            std::span<const std::uint8_t> above;
            for (std::size_t j = 0; columns > 0 && j < pass.rows(header_); ++j) {
                if (source_.options.progress.cancelled()) {
                    return cancelled("reading");
                }
                const std::span<std::uint8_t> row = std::span(bytes).subspan(at + 1, rowBytes);
                if (!unfilter(bytes[at], row, above, pixel)) {
                    return badPicture(source_, dataOffset_,
                                      "a row has the unknown filter " + std::to_string(bytes[at]));
                }
                for (std::size_t k = 0; k < columns; ++k) {
                    if (!reader.add(row, k, pass.x + k * pass.stepX, pass.y + j * pass.stepY, means)) {
                        return badPicture(source_, dataOffset_, "a pixel has a colour that the palette lacks");
                    }
                }
                above = row;
                at += rowBytes + 1;
            }
        }
        return {};
    }

    const SourceText &source_;
    PngHeader header_;
    std::string data_; ///< compressed
    std::size_t dataOffset_ = 0;
    std::string_view palette_, transparency_;
};

} // namespace

bool looksLikePng(std::string_view head) {
    return head.starts_with(kSignature);
}

Result<PngHeader> readPngHeader(const SourceText &source) {
    const std::string_view text = source.text;
    if (!looksLikePng(text)) {
        return Diagnostics{faultAt(source, 0, "bad-picture", "the file is not a PNG picture", kSaveAgain)};
    }
    if (text.size() < PngHeader::kBytes || longAt(text, 8) != 13 || text.substr(12, 4) != "IHDR" ||
        longAt(text, 29) != crc32(text.substr(12, 17))) {
        return badPicture(source, 8, "its header is damaged");
    }
    PngHeader header{.columns = longAt(text, 16),
                     .rows = longAt(text, 20),
                     .depth = byteAt(text, 24),
                     .colour = byteAt(text, 25),
                     .interlaced = byteAt(text, 28) == 1};
    if (header.columns == 0 || header.rows == 0 || !allowedDepth(header.colour, header.depth) ||
        byteAt(text, 26) != 0 || byteAt(text, 27) != 0 || byteAt(text, 28) > 1) {
        return badPicture(source, 16, "its header has values that do not exist");
    }
    if (header.columns > kMaxPixels / header.rows) {
        return Diagnostics{faultAt(source, 16, "large-picture",
                                   "the picture has " + std::to_string(header.columns) + " x " +
                                       std::to_string(header.rows) + " pixels; expected at most 100 million",
                                   "make it smaller in another program")};
    }
    return header;
}

GreyCounts greyCounts(std::size_t columns, std::size_t rows, std::size_t most) {
    const auto divided = [](std::size_t count, std::size_t by) { return (count + by - 1) / by; };
    std::size_t by = 1;
    while (divided(columns, by) * divided(rows, by) > most) {
        ++by;
    }
    return {divided(columns, by), divided(rows, by)};
}

Result<GreyPicture> readGreyPicture(const SourceText &source, std::size_t most) {
    const Result<PngHeader> header = readPngHeader(source);
    if (!header) {
        return header.faults();
    }
    return PngReader(source, *header).read(most);
}

} // namespace forefront
