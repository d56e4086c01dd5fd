#pragma once

#include "core/teaching/lesson/lesson.hpp"
#include "ui/background/background_task.hpp"
#include "ui/gl/image_texture.hpp"
#include "ui/widgets/rich_text.hpp"

#include <map>
#include <memory>
#include <string>

namespace forefront {

/// Keeps the images of the open lesson as textures. They are decoded on a separate thread.
class PageImages {
  public:
    explicit PageImages(BackgroundList &list) : task_(list) {}

    /// Shows the images of a lesson from now on; null: of none. Called once per frame, with the OpenGL context.
    /// Returns true if pictures have arrived.
    bool follow(const std::shared_ptr<const Lesson> &lesson);
    /// Returns a picture of the lesson by its file.
    ui::TextPicture find(const std::string &file) const;

  private:
    using Decoded = std::map<std::string, std::shared_ptr<const Picture>>;

    BackgroundTask task_;
    std::shared_ptr<const Lesson> lesson_;
    std::map<std::string, std::unique_ptr<ImageTexture>> textures_; ///< null: damaged
    Decoded decoded_;                                               ///< that have become no textures yet
};

} // namespace forefront
