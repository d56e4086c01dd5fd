#include "core/teaching/film/film_picture.hpp"
#include "core/teaching/film/gif_writer.hpp"
#include "core/teaching/film/png_writer.hpp"
#include "core/teaching/film/stroke_font.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <png.h>
#include <random>
#include <string>
#include <vector>

namespace forefront {

namespace {

/// Reads numbers of a given number of bits, least significant bit first.
class BitReader {
  public:
    explicit BitReader(std::string_view bytes) : bytes_(bytes) {}
    unsigned take(unsigned count) {
        unsigned value = 0;
        for (unsigned k = 0; k < count; ++k, ++at_) {
            value |= (static_cast<unsigned char>(bytes_[at_ / 8]) >> at_ % 8 & 1U) << k;
        }
        return value;
    }
    /// Reads a Huffman code, most significant bit first.
    unsigned code(unsigned count) {
        unsigned value = 0;
        for (unsigned k = 0; k < count; ++k) {
            value = value << 1 | take(1);
        }
        return value;
    }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

std::vector<std::uint8_t> decodeLzw(std::string_view data) {
    BitReader bits(data);
    std::vector<std::vector<std::uint8_t>> words;
    std::vector<std::uint8_t> result, last;
    unsigned size = 9;
    for (;;) {
        const unsigned code = bits.take(size);
        if (code == 256) {
            words.clear();
            last.clear();
            size = 9;
            continue;
        }
        if (code == 257) {
            return result;
        }
        std::vector<std::uint8_t> word;
        if (code < 256) {
            word = {static_cast<std::uint8_t>(code)};
        } else if (code - 258 < words.size()) {
            word = words[code - 258];
        } else {
            word = last;
            word.push_back(last.front());
        }
        if (!last.empty() && words.size() + 258 < 4096) {
            words.push_back(last);
            words.back().push_back(word.front());
            size = words.size() + 258 == 1U << size && size < 12 ? size + 1 : size;
        }
        result.insert(result.end(), word.begin(), word.end());
        last = word;
    }
}

/// Decodes the frames of a GIF written by this program into full pictures.
std::vector<std::vector<std::uint8_t>> decodeGif(const std::string &file) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(file[at]); };
    const auto number = [&](std::size_t at) { return static_cast<std::size_t>(byte(at) | byte(at + 1) << 8); };
    const std::size_t width = number(6), height = number(8);
    std::vector<std::uint8_t> shown(width * height, 254);
    std::vector<std::vector<std::uint8_t>> frames;
    for (std::size_t at = 13 + 768; byte(at) != ';';) {
        std::size_t place[4] = {};
        const bool image = byte(at) == ',';
        for (std::size_t k = 0; k < 4 && image; ++k) {
            place[k] = number(at + 1 + 2 * k);
        }
        at += image ? 11 : 2;
        std::string data;
        for (; byte(at) != 0; at += byte(at) + std::size_t{1}) {
            data += file.substr(at + 1, byte(at));
        }
        ++at;
        if (!image) {
            continue;
        }
        const std::vector<std::uint8_t> pixels = decodeLzw(data);
        REQUIRE(pixels.size() == place[2] * place[3]);
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            if (pixels[k] != kUnchangedPixel) {
                shown[(place[1] + k / place[2]) * width + place[0] + k % place[2]] = pixels[k];
            }
        }
        frames.push_back(shown);
    }
    return frames;
}

FilmPicture randomPicture(std::mt19937 &random, int width, int height, unsigned colours, unsigned run) {
    FilmPicture picture{width, height, {}};
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    while (picture.pixels.size() < count) {
        const auto colour = static_cast<std::uint8_t>(random() % colours);
        const std::size_t length = std::min<std::size_t>(1 + random() % run, count - picture.pixels.size());
        picture.pixels.insert(picture.pixels.end(), length, colour);
    }
    return picture;
}

} // namespace

TEST_CASE("Film: the frames of a GIF decode to the original pictures") {
    std::mt19937 random(7);
    for (const unsigned run : {1U, 5U, 400U}) {
        for (const unsigned colours : {2U, 227U}) {
            CAPTURE(run);
            CAPTURE(colours);
            std::vector<FilmPicture> pictures;
            for (int k = 0; k < 3; ++k) {
                pictures.push_back(randomPicture(random, 181, 97, colours, run));
            }
            pictures.push_back(pictures.back()); // nothing changes
            StringSink sink;
            GifWriter writer(sink, 181, 97, 10);
            for (const FilmPicture &picture : pictures) {
                CHECK(writer.add(picture));
            }
            CHECK(writer.finish());
            const auto frames = decodeGif(sink.text);
            REQUIRE(frames.size() == pictures.size());
            for (std::size_t k = 0; k < frames.size(); ++k) {
                CHECK(frames[k] == pictures[k].pixels);
            }
        }
    }
}

TEST_CASE("Film: a PNG decodes to the original picture") {
    const std::vector<std::uint8_t> palette = filmPalette();
    std::mt19937 random(8);
    for (const unsigned run : {1U, 5U, 400U, 3000U}) {
        for (const unsigned colours : {2U, 227U}) {
            const FilmPicture picture = randomPicture(random, 301, 57, colours, run);
            const std::string file = pngOf(picture);
            png_image image{};
            image.version = PNG_IMAGE_VERSION;
            REQUIRE(png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0);
            CHECK(image.width == 301);
            CHECK(image.height == 57);
            image.format = PNG_FORMAT_RGB;
            std::vector<std::uint8_t> decoded(PNG_IMAGE_SIZE(image));
            REQUIRE(png_image_finish_read(&image, nullptr, decoded.data(), 0, nullptr) != 0);
            std::vector<std::uint8_t> painted;
            for (const std::uint8_t pixel : picture.pixels) {
                painted.insert(painted.end(), palette.begin() + 3 * pixel, palette.begin() + 3 * pixel + 3);
            }
            CHECK(decoded == painted);
        }
    }
}

TEST_CASE("Film: the stroke font knows every character of captions") {
    const std::vector<std::array<Vec2, 2>> box = strokeText("\xe2\x98\x83"); // a snowman, which is not in the font
    for (const char *symbol : {"\xce\xb1", "\xce\xb4", "\xcf\x81", "\xc2\xb7", "\xe2\x86\x92"}) {
        CHECK(strokeText(symbol) != box);
    }
    for (char c = '!'; c <= '~'; ++c) {
        CAPTURE(c);
        const auto strokes = strokeText(std::string(1, c));
        CHECK_FALSE(strokes.empty());
        CHECK(strokes != box);
        CHECK(strokeTextWidth(std::string(1, c)) > 0.0);
    }
    CHECK(strokeText(" ").empty());
    CHECK(strokeTextWidth("ab") > strokeTextWidth("a"));
}

} // namespace forefront
