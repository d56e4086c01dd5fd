#include "core/files/png/png_decoder.hpp"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <png.h>

// After a fault, libpng jumps back to the last setjmp and runs no destructors on the way. So no function between them,
// here or in the callbacks, has an object that needs one.

namespace forefront {

PngDecoder::PngDecoder(std::string_view file) : file_(file) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, png_const_charp) {});
    info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
}

PngDecoder::~PngDecoder() {
    png_destroy_read_struct(&png_, &info_, nullptr);
}

void PngDecoder::readBytes(png_structp png, unsigned char *bytes, std::size_t count) {
    auto &self = *static_cast<PngDecoder *>(png_get_io_ptr(png));
    if (count > self.file_.size() - self.offset_) {
        png_error(png, "the file ends early");
    }
    std::memcpy(bytes, self.file_.data() + self.offset_, count);
    self.offset_ += count;
}

void PngDecoder::fail(png_structp png, const char *message) {
    auto &self = *static_cast<PngDecoder *>(png_get_error_ptr(png));
    std::snprintf(self.fault_.data(), self.fault_.size(), "%s", message);
    png_longjmp(png, 1);
}

bool PngDecoder::open() {
    if (info_ == nullptr) {
        std::snprintf(fault_.data(), fault_.size(), "there is not enough memory");
        return false;
    }
    if (setjmp(png_jmpbuf(png_)) != 0) {
        return false;
    }
    png_set_read_fn(png_, this, readBytes);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(png_, info_);
    if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE) {
        png_set_packing(png_); // one byte for each pixel
        takePalette();
    } else {
        png_set_expand(png_); // few bits and a transparent colour become samples of 8 bits and opacity
    }
    png_read_update_info(png_, info_);
    return true;
}

void PngDecoder::takePalette() {
    png_colorp colours = nullptr;
    png_bytep opacities = nullptr;
    int count = 0, opacityCount = 0;
    png_get_PLTE(png_, info_, &colours, &count);
    png_get_tRNS(png_, info_, &opacities, &opacityCount, nullptr);
    for (int k = 0; k < count; ++k) {
        const std::uint8_t opacity = k < opacityCount ? opacities[k] : 255;
        palette_[static_cast<std::size_t>(k)] = {colours[k].red, colours[k].green, colours[k].blue, opacity};
    }
    colours_ = count;
}

std::size_t PngDecoder::columns() const {
    return png_get_image_width(png_, info_);
}
std::size_t PngDecoder::rows() const {
    return png_get_image_height(png_, info_);
}
unsigned PngDecoder::channels() const {
    return colours_ > 0 ? 4 : png_get_channels(png_, info_);
}
unsigned PngDecoder::sampleBytes() const {
    return png_get_bit_depth(png_, info_) / 8U;
}
int PngDecoder::passes() const {
    return png_get_interlace_type(png_, info_) == PNG_INTERLACE_NONE ? 1 : PNG_INTERLACE_ADAM7_PASSES;
}

bool PngDecoder::readRow(std::uint8_t *row, std::size_t pixels) {
    if (setjmp(png_jmpbuf(png_)) != 0) {
        return false;
    }
    png_read_row(png_, row, nullptr);
    for (std::size_t k = colours_ > 0 ? pixels : 0; k-- > 0;) {
        if (row[k] >= colours_) {
            png_error(png_, "a pixel has a colour that the palette lacks");
        }
        std::copy_n(palette_[row[k]].begin(), 4, row + 4 * k);
    }
    return true;
}

bool PngDecoder::finish() {
    if (setjmp(png_jmpbuf(png_)) != 0) {
        return false;
    }
    png_read_end(png_, nullptr);
    return true;
}

} // namespace forefront
