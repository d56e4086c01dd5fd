#pragma once

#include "core/base/result.hpp"
#include "core/film/film_scene.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

/// Draws a scene, antialiased and without its caption. Returns a palette index for each pixel, row by row.
std::vector<std::uint8_t> paintScene(const FilmScene &scene);

/// Returns the 256 colours that paintScene() uses, red, green and blue of each.
std::vector<std::uint8_t> filmPalette();

/// An animated GIF that repeats for ever.
class GifFilm {
  public:
    /// Creates the file. `delay`: of each frame, in hundredths of a second. Fault: cannot-write.
    static Result<GifFilm> create(const std::filesystem::path &file, int width, int height, int delay);

    /// Appends a frame. Fault: cannot-write.
    Status add(const FilmScene &scene);
    /// Completes the file. Fault: cannot-write.
    Status finish();

  private:
    struct File;
    explicit GifFilm(std::shared_ptr<File> file) : file_(std::move(file)) {}

    std::shared_ptr<File> file_;
};

} // namespace forefront
