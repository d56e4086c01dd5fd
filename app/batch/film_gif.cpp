#include "app/batch/film_gif.hpp"

#if defined(FOREFRONT_WITH_GIF)

#include "core/io/text/atomic_file.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <gif_lib.h>
#include <string>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

constexpr int kColours = 256, kBits = 8;

struct FreeColours {
    void operator()(ColorMapObject *map) const { GifFreeMapObject(map); }
};

} // namespace

/// The file appears only when it is finished.
struct GifFilm::File {
    File(const std::filesystem::path &place, int delayOfFrames) : path(place), output(place), delay(delayOfFrames) {}

    std::filesystem::path path;
    AtomicFile output;
    GifFileType *gif = nullptr;
    int delay;
    bool refused = false; ///< bytes could not be written

    /// Passes bytes of giflib on to the file; returns their number, or 0 if they cannot be written.
    static int write(GifFileType *gif, const GifByteType *bytes, int count) {
        auto *const file = static_cast<File *>(gif->UserData);
        const auto size = static_cast<std::size_t>(count);
        file->refused = !file->output.write({reinterpret_cast<const char *>(bytes), size}) || file->refused;
        return file->refused ? 0 : count;
    }

    /// Returns why the file cannot be written, given an error of giflib.
    Diagnostics fault(int code) {
        if (refused) {
            return output.commit(); // which only reports it
        }
        const char *const reason = GifErrorString(code);
        return error("cannot-write",
                     "cannot write " + path.string() + ": " + (reason != nullptr ? reason : "unknown reason"));
    }

    ~File() {
        if (gif != nullptr) {
            EGifCloseFile(gif, nullptr);
        }
    }
};

Result<GifFilm> GifFilm::create(const std::filesystem::path &file, int width, int height, int delay) {
    auto made = std::make_shared<File>(file, delay);
    int code = 0;
    made->gif = EGifOpen(made.get(), File::write, &code);
    if (made->gif == nullptr) {
        return made->fault(code);
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
    if (!written) {
        return made->fault(made->gif->Error);
    }
    return GifFilm(std::move(made));
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
    return written ? Status() : Status(file_->fault(gif->Error));
}

Status GifFilm::finish() {
    int code = 0;
    GifFileType *const gif = std::exchange(file_->gif, nullptr);
    return EGifCloseFile(gif, &code) == GIF_OK ? file_->output.commit() : Status(file_->fault(code));
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
