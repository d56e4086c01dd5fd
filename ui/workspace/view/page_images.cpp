#include "ui/workspace/view/page_images.hpp"

#include "core/engine/base/progress.hpp"
#include "ui/canvas/picture.hpp"

#include <utility>

namespace forefront {

bool PageImages::follow(const std::shared_ptr<const Lesson> &lesson) {
    if (lesson != lesson_) {
        lesson_ = lesson;
        textures_.clear();
        decoded_.clear();
        task_.cancel();
        if (lesson && !lesson->pictures.empty()) {
            task_.start("reading the images of the lesson", [this, lesson](const Progress &progress) {
                const auto decoded = std::make_shared<Decoded>();
                for (const auto &[file, picture] : lesson->pictures) {
                    if (picture->faults.empty() && !progress.cancelled()) {
                        (*decoded)[file] = decodePicture(picture->bytes);
                    }
                }
                return BackgroundTask::Finish([this, decoded] { decoded_ = std::move(*decoded); });
            });
        }
    }
    task_.refresh();
    if (task_.ready()) {
        task_.finish();
    }
    for (const auto &[file, picture] : decoded_) {
        textures_[file] = picture ? std::make_unique<ImageTexture>(*picture) : nullptr;
    }
    return !std::exchange(decoded_, {}).empty();
}

ui::TextPicture PageImages::find(const std::string &file) const {
    if (!lesson_ || !lesson_->pictures.contains(file)) {
        return {.note = "not read"};
    }
    const LessonPicture &picture = *lesson_->pictures.at(file);
    if (!picture.faults.empty()) {
        return {.note = picture.faults.front().message};
    }
    ui::TextPicture shown{.columns = static_cast<float>(picture.columns), .rows = static_cast<float>(picture.rows)};
    if (const auto texture = textures_.find(file); texture != textures_.end()) {
        shown.texture = texture->second ? texture->second->name() : 0;
        shown.note = texture->second ? "" : "the file is damaged";
    }
    return shown;
}

} // namespace forefront
