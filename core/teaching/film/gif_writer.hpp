#pragma once

#include "core/files/text/text_writer.hpp"
#include "core/teaching/film/film_picture.hpp"

#include <vector>

namespace forefront {

/// Writes an animated GIF that loops forever. A frame stores only the rectangle that differs from the previous frame.
/// It does without giflib, and the PNG writer without libpng, so that programs that link the library need neither.
class GifWriter {
  public:
    /// Writes the header for pictures of this size. `delay`: duration of a frame, in hundredths of a second.
    GifWriter(ByteSink &sink, int width, int height, int delay);

    /// Appends a frame of the given size. Returns false if the bytes cannot be written.
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
