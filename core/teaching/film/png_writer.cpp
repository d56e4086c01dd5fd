#include "core/teaching/film/png_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <png.h>
#include <vector>

namespace forefront {

std::string pngOf(const FilmPicture &picture) {
    const std::vector<std::uint8_t> palette = filmPalette();
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB_COLORMAP;
    image.colormap_entries = static_cast<png_uint_32>(palette.size() / 3);
    std::string file(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = file.size();
    const bool written = png_image_write_to_memory(&image, file.data(), &size, 0, picture.pixels.data(), picture.width,
                                                   palette.data()) != 0;
    png_image_free(&image);
    file.resize(written ? size : 0);
    return file;
}

} // namespace forefront
