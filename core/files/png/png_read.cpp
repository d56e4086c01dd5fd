#include "core/engine/base/cancelled.hpp"
#include "core/files/common/cell_grid.hpp"
#include "core/files/png/png.hpp"
#include "core/files/png/png_decoder.hpp"
#include "core/files/png/png_pass.hpp"

#include <string>

namespace forefront {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t kMaxPixels = 100'000'000;
constexpr const char *kSaveAgain = "open it in another program and save it as PNG";

/// Averages grey values over the rectangles of pixels of a coarser picture.
class GreyMeans {
  public:
    explicit GreyMeans(GreyPicture &picture) : picture_(picture), cells_(picture.columns * picture.rows) {}

    /// Adds a luminance between 0 and kWhite, or a transparent pixel.
    void add(std::size_t x, std::size_t y, std::uint64_t luminance, bool transparent) {
        const std::size_t row = y * picture_.rows / picture_.pixelRows;
        Cell &cell = cells_[row * picture_.columns + x * picture_.columns / picture_.pixelColumns];
        cell.sum += transparent ? 0 : luminance;
        ++(transparent ? cell.transparent : cell.opaque);
    }
    void finish() {
        picture_.values.reserve(cells_.size());
        for (const Cell &cell : cells_) {
            const bool none = cell.opaque == 0 || cell.opaque < cell.transparent;
            picture_.values.push_back(none ? kNoGrey
                                           : static_cast<double>(cell.sum) / static_cast<double>(cell.opaque) /
                                                 static_cast<double>(kWhite));
        }
    }
    static constexpr std::uint64_t kWhite = std::uint64_t{65535} * 10000;

  private:
    struct Cell {
        std::uint64_t sum = 0;
        std::uint32_t opaque = 0, transparent = 0; ///< pixels
    };
    GreyPicture &picture_;
    std::vector<Cell> cells_;
};

/// The samples of a row of pixels.
class PixelRow {
  public:
    explicit PixelRow(const PngDecoder &decoder)
        : channels_(decoder.channels()), bytes_(decoder.sampleBytes()),
          row_(decoder.columns() * decoder.channels() * decoder.sampleBytes()) {}

    std::uint8_t *data() { return row_.data(); }
    void add(std::size_t k, std::size_t x, std::size_t y, GreyMeans &means) const {
        const std::size_t first = k * channels_;
        const bool coloured = channels_ >= 3, hasOpacity = channels_ % 2 == 0;
        const std::uint64_t luminance = coloured
                                            ? 2126 * sample(first) + 7152 * sample(first + 1) + 722 * sample(first + 2)
                                            : 10000 * sample(first);
        means.add(x, y, luminance, hasOpacity && sample(first + channels_ - 1) == 0);
    }

  private:
    /// Returns a sample on a scale up to 65535.
    std::uint64_t sample(std::size_t k) const {
        return bytes_ == 2 ? row_[2 * k] * 256U + row_[2 * k + 1] : row_[k] * 257U;
    }

    std::size_t channels_, bytes_;
    std::vector<std::uint8_t> row_;
};

Diagnostics badPicture(const SourceText &source, const PngDecoder &decoder) {
    return {faultAt(source, decoder.offset(), "bad-picture",
                    std::string("cannot decode the picture: ") + decoder.fault(), kSaveAgain)};
}

Diagnostics readPixels(PngDecoder &decoder, const SourceText &source, GreyPicture &picture) {
    GreyMeans means(picture);
    PixelRow row(decoder);
    for (int number = 0; number < decoder.passes(); ++number) {
        const PngPass pass(decoder, number);
        for (std::size_t j = 0; j < pass.rows; ++j) {
            if (source.options.progress.cancelled()) {
                return cancelled("reading");
            }
            if (!decoder.readRow(row.data(), pass.columns)) {
                return badPicture(source, decoder);
            }
            for (std::size_t k = 0; k < pass.columns; ++k) {
                row.add(k, pass.x + k * pass.stepX, pass.y + j * pass.stepY, means);
            }
        }
    }
    means.finish();
    return decoder.finish() ? Diagnostics{} : badPicture(source, decoder);
}

} // namespace

bool looksLikePng(std::string_view head) {
    return head.starts_with(kSignature);
}

Result<GreyPicture> readGreyPicture(const SourceText &source, std::size_t most) {
    if (!looksLikePng(source.text)) {
        return Diagnostics{faultAt(source, 0, "bad-picture", "the file is not a PNG picture", kSaveAgain)};
    }
    PngDecoder decoder(source.text);
    if (!decoder.open()) {
        return badPicture(source, decoder);
    }
    GreyPicture picture;
    picture.pixelColumns = decoder.columns();
    picture.pixelRows = decoder.rows();
    if (picture.pixelColumns > kMaxPixels / picture.pixelRows) {
        return Diagnostics{faultAt(source, 0, "large-picture",
                                   "the picture has " + std::to_string(picture.pixelColumns) + " x " +
                                       std::to_string(picture.pixelRows) + " pixels; expected at most 100 million",
                                   "make it smaller in another program")};
    }
    const GridCounts counts = averagedCounts(picture.pixelColumns, picture.pixelRows, most);
    picture.columns = counts.columns;
    picture.rows = counts.rows;
    if (Diagnostics faults = readPixels(decoder, source, picture); !faults.empty()) {
        return faults;
    }
    return picture;
}

} // namespace forefront
