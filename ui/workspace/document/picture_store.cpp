#include "ui/workspace/document/picture_store.hpp"

#include <utility>

namespace forefront {

void PictureStore::follow(const Document &document, std::uint64_t loads) {
    const std::string file = document.picture ? document.picture->file : std::string();
    if (file == file_ && loads == loads_) {
        return;
    }
    if (loads != loads_) {
        read_.reset(); // the file may have changed meanwhile
    }
    file_ = file;
    loads_ = loads;
    failed_ = false;
    task_.cancel();
    shown_ = !file.empty() && read_ && read_->file == file ? read_ : nullptr;
    if (file.empty() || shown_) {
        return;
    }
    task_.start("reading the background picture", [this, file](const Progress &) -> BackgroundTask::Finish {
        const auto result = std::make_shared<const Result<std::shared_ptr<const Picture>>>(readPicture(file));
        return [this, result] {
            if (*result) {
                accept(**result);
            } else {
                failed_ = true;
                faults_ = result->faults();
            }
        };
    });
}

void PictureStore::accept(std::shared_ptr<const Picture> picture) {
    read_ = std::move(picture);
    file_ = read_->file.string();
    shown_ = read_;
    failed_ = false;
    task_.cancel();
}

bool PictureStore::refresh(Diagnostics &faults) {
    const bool news = task_.refresh();
    if (task_.ready()) {
        task_.finish();
    }
    faults.insert(faults.end(), faults_.begin(), faults_.end());
    faults_.clear();
    return news;
}

} // namespace forefront
