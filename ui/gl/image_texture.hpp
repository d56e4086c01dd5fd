#pragma once

#include "ui/canvas/picture.hpp"

namespace forefront {

/// A texture of OpenGL with a picture and smaller copies of it, for pictures in texts. The OpenGL context must be
/// current while it is made and destroyed.
class ImageTexture {
  public:
    explicit ImageTexture(const Picture &picture);
    ~ImageTexture();
    ImageTexture(const ImageTexture &) = delete;
    ImageTexture &operator=(const ImageTexture &) = delete;

    /// Returns the name that OpenGL knows the texture by.
    unsigned name() const { return name_; }

  private:
    unsigned name_ = 0;
};

} // namespace forefront
