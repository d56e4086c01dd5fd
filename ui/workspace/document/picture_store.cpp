#include "ui/workspace/document/picture_store.hpp"

#include <filesystem>
#include <optional>
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
    watch_.forget();
    shown_ = !file.empty() && read_ && read_->file == file ? read_ : nullptr;
    if (shown_) {
        watch_.watch(file, shown_->stamp);
    } else if (!file.empty()) {
        startReading();
    }
}

void PictureStore::startReading() {
    task_.start("reading the background picture", [this, file = file_](const Progress &) -> BackgroundTask::Finish {
        const auto result = std::make_shared<const Result<std::shared_ptr<const Picture>>>(readPicture(file));
        return [this, result, file] {
            if (*result) {
                accept(**result);
                return;
            }
            failed_ = shown_ == nullptr;
            news_ = result->faults();
            watch_.watch(file, {}); // from what it is now on
        };
    });
}

void PictureStore::accept(std::shared_ptr<const Picture> picture) {
    read_ = std::move(picture);
    file_ = read_->file.string();
    shown_ = read_;
    failed_ = false;
    task_.cancel();
    watch_.watch(file_, read_->stamp);
}

/// Reads the picture again if another program has changed its file.
void PictureStore::takeChange(Diagnostics &news) {
    const std::optional<FileStamp> now = watch_.takeNews();
    if (!now) {
        return;
    }
    const std::string name = std::filesystem::path(file_).filename().string();
    Diagnostic change{.severity = Severity::Note, .code = "picture-changed", .file = file_};
    if (now->kind == FileStamp::Kind::Missing) {
        change.severity = Severity::Warning;
        change.message = "another program has deleted or moved the background picture " + name;
        change.advice = "put it back, or choose another with File > Add background picture";
    } else {
        change.message = "the background picture " + name + " has changed on disk and was read again";
        startReading();
    }
    news.push_back(std::move(change));
}

bool PictureStore::refresh(Diagnostics &news) {
    const bool arrived = task_.refresh();
    if (task_.ready()) {
        task_.finish();
    }
    takeChange(news);
    news.insert(news.end(), news_.begin(), news_.end());
    news_.clear();
    return arrived;
}

} // namespace forefront
