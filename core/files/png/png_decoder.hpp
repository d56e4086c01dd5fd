#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

struct png_struct_def;
struct png_info_def;

namespace forefront {

/// Decodes a PNG file with libpng, row by row. Each function returns false after a fault and must not be called again.
class PngDecoder {
  public:
    /// The file must outlive the decoder.
    explicit PngDecoder(std::string_view file);
    ~PngDecoder();
    PngDecoder(const PngDecoder &) = delete;
    PngDecoder &operator=(const PngDecoder &) = delete;

    /// Reads up to the pixels.
    bool open();
    std::size_t columns() const;
    std::size_t rows() const;
    /// Returns the number of samples of a pixel, also where the file has a palette: grey or red, green and blue, then
    /// the opacity if it has one.
    unsigned channels() const;
    /// Returns the number of bytes of a sample, 1 or 2, the highest first.
    unsigned sampleBytes() const;
    /// Returns the number of passes over the picture: 7 if it is interlaced, else 1.
    int passes() const;
    /// Reads the next row of a pass. `pixels`: its number of pixels; `row`: has room for columns() pixels.
    bool readRow(std::uint8_t *row, std::size_t pixels);
    /// Reads the rest of the file.
    bool finish();

    /// Returns the error.
    const char *fault() const { return fault_.data(); }
    /// Returns the number of bytes read.
    std::size_t offset() const { return offset_; }

  private:
    void takePalette();
    static void readBytes(png_struct_def *png, unsigned char *bytes, std::size_t count);
    static void fail(png_struct_def *png, const char *message);

    std::string_view file_;
    std::size_t offset_ = 0;
    std::array<char, 160> fault_{};
    std::array<std::array<std::uint8_t, 4>, 256> palette_{}; ///< red, green, blue, opacity
    int colours_ = 0;                                        ///< in the palette; 0: there is none
    png_struct_def *png_ = nullptr;
    png_info_def *info_ = nullptr;
};

} // namespace forefront
