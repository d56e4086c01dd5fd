#include "ui/canvas/picture.hpp"

#include "core/engine/platform/file_handle.hpp"
#include "core/files/png/png.hpp"
#include "core/files/png/png_decoder.hpp"
#include "core/files/png/png_pixels.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <optional>
#include <stb_image.h>
#include <string>
#include <utility>

namespace forefront {
namespace {

/// Maximum width and height of the decoded picture; every graphics card of the last 15 years can hold it.
constexpr int kMaxSide = 8192;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

std::string nameOf(const std::filesystem::path &file) {
    return '\'' + file.filename().string() + '\'';
}

Diagnostics fault(const std::filesystem::path &file, std::string code, const std::string &message, std::string advice) {
    Diagnostics faults = error(std::move(code), message, std::move(advice));
    faults.front().file = file.string();
    return faults;
}

Diagnostics missing(const std::filesystem::path &file, const std::string &why) {
    return fault(file, "missing-picture", "cannot read picture " + nameOf(file) + ": " + why,
                 "put the file there, or choose another with File > Add background picture");
}

/// Opens a picture. Refuses all but regular files: a pipe would wait for ever for its other end.
Result<File> openPicture(const std::filesystem::path &path) {
    const FileHandle handle = openFile(path, FileAccess::ReadNow);
    if (handle < 0) {
        return missing(path, std::strerror(errno));
    }
    FileStatus status;
    const bool regular = statusOf(handle, status) && status.kind == FileStatus::Kind::Regular;
    File file(regular ? streamOf(handle) : nullptr, std::fclose);
    if (!file) {
        const std::string why = regular ? std::strerror(errno) : "it is not a regular file";
        closeFile(handle);
        return missing(path, why);
    }
    return file;
}

Diagnostics damaged(const std::filesystem::path &file, const char *reason) {
    return fault(file, "bad-picture",
                 "cannot decode picture " + nameOf(file) + ": the file is damaged or incomplete (" +
                     (reason != nullptr ? reason : "unknown reason") + ")",
                 "open it in another program and save it as PNG or JPEG");
}

enum class PictureKind : std::uint8_t { Png, Jpeg, Other };

/// Returns the kind of a file by its beginning; stb_image also accepts formats that nobody expects here.
PictureKind kindOf(std::FILE *file) {
    constexpr std::array<unsigned char, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    constexpr std::array<unsigned char, 3> kJpeg{0xff, 0xd8, 0xff};
    std::array<unsigned char, 8> head{};
    const std::size_t count = std::fread(head.data(), 1, head.size(), file);
    std::rewind(file);
    if (count == head.size() && head == kPng) {
        return PictureKind::Png;
    }
    return count >= kJpeg.size() && std::equal(kJpeg.begin(), kJpeg.end(), head.begin()) ? PictureKind::Jpeg
                                                                                         : PictureKind::Other;
}

/// Returns the size in the header of a PNG file; empty if that is cut.
PixelSize pngSize(std::FILE *file) {
    std::array<unsigned char, 24> head{};
    const std::size_t count = std::fread(head.data(), 1, head.size(), file);
    std::rewind(file);
    if (count < head.size()) {
        return {};
    }
    const auto number = [&](std::size_t at) {
        const unsigned value = (static_cast<unsigned>(head[at]) << 24) | (static_cast<unsigned>(head[at + 1]) << 16) |
                               (static_cast<unsigned>(head[at + 2]) << 8) | head[at + 3];
        return static_cast<int>(std::min(value, 0x7fffffffU));
    };
    return {number(16), number(20)};
}

/// Returns the size in the header of a JPEG file; empty if that cannot be read.
PixelSize jpegSize(std::FILE *file) {
    PixelSize size;
    int channels = 0;
    return stbi_info_from_file(file, &size.width, &size.height, &channels) != 0 ? size : PixelSize{};
}

/// Checks a file and returns its size; afterwards it is at its start again.
Result<PixelSize> checkedSize(const std::filesystem::path &path, std::FILE *file) {
    const PictureKind kind = kindOf(file);
    if (kind == PictureKind::Other) {
        return fault(path, "bad-picture", nameOf(path) + " is not a picture; expected a PNG or JPEG file",
                     "open it in another program and save it as PNG or JPEG");
    }
    const PixelSize size = kind == PictureKind::Png ? pngSize(file) : jpegSize(file);
    if (size.width < 1 || size.height < 1) {
        return damaged(path, kind == PictureKind::Png ? "no size" : stbi_failure_reason());
    }
    if (static_cast<double>(size.width) * size.height > kMaxPicturePixels) {
        return fault(path, "large-picture",
                     "picture " + nameOf(path) + " has " + std::to_string(size.width) + " x " +
                         std::to_string(size.height) + " pixels; expected at most 100 million",
                     "make it smaller in another program");
    }
    return size;
}

/// Halves the resolution: each pixel becomes the mean of four.
void halve(Picture &picture) {
    const int columns = std::max(1, picture.columns / 2), rows = std::max(1, picture.rows / 2);
    const auto at = [&](int column, int row) {
        return 4 *
               (static_cast<std::size_t>(std::min(row, picture.rows - 1)) * static_cast<std::size_t>(picture.columns) +
                static_cast<std::size_t>(std::min(column, picture.columns - 1)));
    };
    std::vector<std::uint8_t> half;
    half.reserve(4 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::array corners{at(2 * column, 2 * row), at(2 * column + 1, 2 * row), at(2 * column, 2 * row + 1),
                                     at(2 * column + 1, 2 * row + 1)};
            for (std::size_t channel = 0; channel < 4; ++channel) {
                unsigned sum = 2;
                for (const std::size_t corner : corners) {
                    sum += picture.rgba[corner + channel];
                }
                half.push_back(static_cast<std::uint8_t>(sum / 4));
            }
        }
    }
    picture.columns = columns;
    picture.rows = rows;
    picture.rgba = std::move(half);
}

/// Decodes the pixels of a PNG file into a picture of its size. Returns false for a damaged one; `decoder` has the
/// fault.
bool decodePng(PngDecoder &decoder, Picture &picture) {
    std::optional<std::vector<std::uint8_t>> colours = decoder.open() ? coloursOf(decoder) : std::nullopt;
    if (!colours) {
        return false;
    }
    picture.columns = static_cast<int>(decoder.columns());
    picture.rows = static_cast<int>(decoder.rows());
    picture.rgba = std::move(*colours);
    return true;
}

Diagnostics readPng(std::FILE *file, Picture &picture) {
    std::string bytes;
    std::array<char, 65536> block{};
    for (std::size_t count = 0; (count = std::fread(block.data(), 1, block.size(), file)) > 0;) {
        bytes.append(block.data(), count);
    }
    PngDecoder decoder(bytes);
    return decodePng(decoder, picture) ? Diagnostics() : damaged(picture.file, decoder.fault());
}

using JpegPixels = std::unique_ptr<stbi_uc, void (*)(void *)>;

/// Takes the decoded pixels of a JPEG file into a picture of that size. Returns false if there are none.
bool takeJpeg(const JpegPixels &pixels, Picture &picture) {
    if (!pixels) {
        return false;
    }
    const std::size_t count = static_cast<std::size_t>(picture.columns) * static_cast<std::size_t>(picture.rows);
    picture.rgba.assign(pixels.get(), pixels.get() + 4 * count);
    return true;
}

/// Decodes the pixels of a JPEG file into a picture of its size.
Diagnostics readJpeg(std::FILE *file, Picture &picture) {
    int channels = 0;
    const JpegPixels pixels(stbi_load_from_file(file, &picture.columns, &picture.rows, &channels, 4), stbi_image_free);
    return takeJpeg(pixels, picture) ? Diagnostics() : damaged(picture.file, stbi_failure_reason());
}

} // namespace

bool isPictureName(const std::filesystem::path &file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

Result<PixelSize> readPictureSize(const std::filesystem::path &path) {
    const Result<File> file = openPicture(path);
    return file ? checkedSize(path, file->get()) : file.faults();
}

Result<std::shared_ptr<const Picture>> readPicture(const std::filesystem::path &path) {
    const FileStamp stamp = stampOf(path);
    const Result<File> file = openPicture(path);
    if (!file) {
        return file.faults();
    }
    const Result<PixelSize> size = checkedSize(path, file->get());
    if (!size) {
        return size.faults();
    }
    Picture picture{.file = path, .stamp = stamp, .size = *size};
    try {
        const bool png = kindOf(file->get()) == PictureKind::Png;
        if (Diagnostics faults = png ? readPng(file->get(), picture) : readJpeg(file->get(), picture);
            !faults.empty()) {
            return faults;
        }
        while (std::max(picture.columns, picture.rows) > kMaxSide) {
            halve(picture);
        }
        return std::make_shared<const Picture>(std::move(picture));
    } catch (const std::bad_alloc &) {
        return fault(path, "large-picture", "not enough memory for picture " + nameOf(path),
                     "make it smaller in another program");
    }
}

std::shared_ptr<const Picture> decodePicture(std::string_view bytes) {
    Picture picture;
    try {
        bool done = false;
        if (looksLikePng(bytes)) {
            PngDecoder decoder(bytes);
            done = decodePng(decoder, picture);
        } else {
            int channels = 0;
            const auto *const data = reinterpret_cast<const stbi_uc *>(bytes.data());
            const JpegPixels pixels(stbi_load_from_memory(data, static_cast<int>(bytes.size()), &picture.columns,
                                                          &picture.rows, &channels, 4),
                                    stbi_image_free);
            done = takeJpeg(pixels, picture);
        }
        picture.size = {picture.columns, picture.rows};
        return done ? std::make_shared<const Picture>(std::move(picture)) : nullptr;
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
}

} // namespace forefront
