#pragma once

#include "core/film/film_picture.hpp"
#include "core/io/text/text_writer.hpp"

#include <vector>

namespace forefront {

/// Writes an animated GIF that repeats for ever. A frame stores only the rectangle that differs from the one before it.
/// Own code, as is the PNG writer: with giflib and libpng, every program that links the library would need them, too.
class GifWriter {
  public:
    /// Writes the header for pictures of this size. `delay`: of each frame, in hundredths of a second.
    GifWriter(ByteSink &sink, int width, int height, int delay);

    /// Appends a frame of the size given. Returns false if the bytes cannot be written.
    bool add(const FilmPicture &picture);
    /// Completes the file.
    bool finish();

  private:
    ByteSink &sink_;
    int delay_;
    bool written_ = true;
    FilmPicture last_; ///< empty before the first frame
};

} // namespace forefront
