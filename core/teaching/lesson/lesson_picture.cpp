#include "core/teaching/lesson/lesson_picture.hpp"

#include "core/engine/base/result.hpp"
#include "core/files/png/png.hpp"
#include "core/files/png/png_decoder.hpp"
#include "core/files/png/png_pixels.hpp"
#include "core/files/source/source.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

struct Sides {
    std::size_t columns = 0, rows = 0;
};

/// Returns a number of two bytes, the highest first.
std::size_t numberAt(std::string_view bytes, std::size_t at) {
    return (static_cast<std::size_t>(static_cast<unsigned char>(bytes[at])) << 8U) |
           static_cast<unsigned char>(bytes[at + 1]);
}

/// Returns the size in the header of a JPEG file; nothing if the file ends before it, or has no end.
std::optional<Sides> jpegSides(std::string_view bytes) {
    for (std::size_t at = 2; at + 9 < bytes.size();) {
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[k]); };
        if (byte(at) != 0xff) {
            return std::nullopt;
        }
        const unsigned marker = byte(at + 1);
        if (marker == 0xff) { // fills up
            ++at;
            continue;
        }
        const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (frame) {
            const bool ends = bytes.find("\xff\xd9", at) != std::string_view::npos;
            return ends ? std::optional(Sides{numberAt(bytes, at + 7), numberAt(bytes, at + 5)}) : std::nullopt;
        }
        at += 2 + numberAt(bytes, at + 2);
    }
    return std::nullopt;
}

/// Returns the size in the header of a PNG file; nothing if that or the end of the file is missing.
std::optional<Sides> pngSides(std::string_view bytes, std::string &why) {
    PngDecoder decoder(bytes);
    if (!decoder.open()) {
        why = decoder.fault();
        return std::nullopt;
    }
    const bool ends = bytes.rfind("IEND") != std::string_view::npos;
    return ends ? std::optional(Sides{decoder.columns(), decoder.rows()}) : std::nullopt;
}

constexpr const char *kSaveAnew = "open it in another program and save it as PNG or JPEG";

Diagnostics damaged(const std::string &why) {
    return error("bad-picture", "the file is damaged or incomplete (" + why + ')', kSaveAnew);
}

} // namespace

LessonPicture lessonPictureOf(std::string bytes) {
    LessonPicture picture;
    const bool png = looksLikePng(bytes);
    if (!png && !bytes.starts_with("\xff\xd8\xff")) {
        picture.faults = error("bad-picture", "it is not a picture; expected a PNG or JPEG file", kSaveAnew);
        return picture;
    }
    picture.kind = png ? LessonPictureKind::Png : LessonPictureKind::Jpeg;
    std::string why = "it ends too early";
    const std::optional<Sides> sides = png ? pngSides(bytes, why) : jpegSides(bytes);
    if (!sides || sides->columns == 0 || sides->rows == 0) {
        picture.faults = damaged(why);
    } else if (std::max(sides->columns, sides->rows) > static_cast<std::size_t>(kMaxPictureSide)) {
        picture.faults = error("large-picture",
                               "it has " + std::to_string(sides->columns) + " x " + std::to_string(sides->rows) +
                                   " pixels; expected at most " + std::to_string(kMaxPictureSide) + " on a side",
                               "make it smaller in another program");
    } else {
        picture.columns = static_cast<int>(sides->columns);
        picture.rows = static_cast<int>(sides->rows);
        picture.bytes = std::move(bytes);
    }
    return picture;
}

Diagnostics damageOf(const LessonPicture &picture) {
    if (picture.kind != LessonPictureKind::Png || picture.bytes.empty()) {
        return {};
    }
    PngDecoder decoder(picture.bytes);
    return decoder.open() && coloursOf(decoder) ? Diagnostics() : damaged(decoder.fault());
}

LessonPicture readLessonPicture(const std::filesystem::path &file) {
    Result<std::string> bytes = readRegularFile(file, kMaxLessonPicture);
    if (bytes) {
        return lessonPictureOf(*std::move(bytes));
    }
    const Diagnostic &fault = bytes.faults().front();
    LessonPicture picture;
    picture.faults = fault.code == "too-large"
                         ? error("large-picture", "the file is larger than 2 MiB", "make it smaller in another program")
                         : error("missing-picture", fault.message, "put the file there, or correct its path");
    return picture;
}

} // namespace forefront
