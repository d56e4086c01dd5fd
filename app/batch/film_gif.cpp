#include "app/batch/film_gif.hpp"

#if defined(FOREFRONT_WITH_GIF)

#include <algorithm>
#include <array>
#include <cstring>
#include <gif_lib.h>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr int kColours = 256, kBits = 8;

Diagnostics cannotWrite(const std::filesystem::path &file, int code) {
    const char *const reason = GifErrorString(code);
    return error("cannot-write",
                 "cannot write " + file.string() + ": " + (reason != nullptr ? reason : "unknown reason"));
}

struct FreeColours {
    void operator()(ColorMapObject *map) const { GifFreeMapObject(map); }
};

} // namespace

struct GifFilm::File {
    GifFileType *gif = nullptr;
    std::filesystem::path path;
    int delay = 10;

    ~File() {
        if (gif != nullptr) {
            EGifCloseFile(gif, nullptr);
        }
    }
};

Result<GifFilm> GifFilm::create(const std::filesystem::path &file, int width, int height, int delay) {
    auto made = std::make_shared<File>();
    made->path = file;
    made->delay = delay;
    int code = 0;
    made->gif = EGifOpenFileName(file.c_str(), false, &code);
    if (made->gif == nullptr) {
        return cannotWrite(file, code);
    }
    EGifSetGifVersion(made->gif, true);
    const std::vector<std::uint8_t> palette = filmPalette();
    std::array<GifColorType, kColours> colours{};
    for (std::size_t k = 0; k < colours.size(); ++k) {
        colours[k] = {palette[3 * k], palette[3 * k + 1], palette[3 * k + 2]};
    }
    const std::unique_ptr<ColorMapObject, FreeColours> map(GifMakeMapObject(kColours, colours.data()));
    constexpr std::array<unsigned char, 3> kForEver{1, 0, 0};
    const bool written = map && EGifPutScreenDesc(made->gif, width, height, kBits, 0, map.get()) == GIF_OK &&
                         EGifPutExtensionLeader(made->gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
                         EGifPutExtensionBlock(made->gif, 11, "NETSCAPE2.0") == GIF_OK &&
                         EGifPutExtensionBlock(made->gif, kForEver.size(), kForEver.data()) == GIF_OK &&
                         EGifPutExtensionTrailer(made->gif) == GIF_OK;
    return written ? Result<GifFilm>(GifFilm(std::move(made))) : cannotWrite(file, made->gif->Error);
}

Status GifFilm::add(const FilmScene &scene) {
    GifFileType *const gif = file_->gif;
    GraphicsControlBlock control{};
    control.DelayTime = file_->delay;
    control.TransparentColor = NO_TRANSPARENT_COLOR;
    std::array<GifByteType, 4> extension{};
    const std::size_t length = EGifGCBToExtension(&control, extension.data());
    bool written =
        EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(length), extension.data()) == GIF_OK &&
        EGifPutImageDesc(gif, 0, 0, scene.width, scene.height, false, nullptr) == GIF_OK;
    std::vector<std::uint8_t> pixels = paintScene(scene);
    for (int y = 0; y < scene.height && written; ++y) {
        std::uint8_t *const row = pixels.data() + static_cast<std::ptrdiff_t>(y) * scene.width;
        written = EGifPutLine(gif, row, scene.width) == GIF_OK;
    }
    return written ? Status() : Status(cannotWrite(file_->path, gif->Error));
}

Status GifFilm::finish() {
    int code = 0;
    GifFileType *const gif = std::exchange(file_->gif, nullptr);
    return EGifCloseFile(gif, &code) == GIF_OK ? Status() : Status(cannotWrite(file_->path, code));
}

} // namespace forefront

#else

namespace forefront {

struct GifFilm::File {};

Result<GifFilm> GifFilm::create(const std::filesystem::path & /*file*/, int /*width*/, int /*height*/, int /*delay*/) {
    return error("no-gif", "this program was built without GIF support",
                 "write a drawing for each frame: -o frames-%d.svg");
}
Status GifFilm::add(const FilmScene & /*scene*/) {
    return {};
}
Status GifFilm::finish() {
    return {};
}

} // namespace forefront

#endif
