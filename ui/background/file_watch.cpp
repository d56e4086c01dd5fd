#include "ui/background/file_watch.hpp"

#include <stop_token>
#include <system_error>
#include <utility>

namespace forefront {

void FileWatch::watch(const std::filesystem::path &file, const FileStamp &known) {
    file_ = file;
    const bool starts = shared_ == nullptr;
    if (starts) {
        shared_ = std::make_shared<Shared>();
        shared_->wake = list().wake();
    }
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->file = file;
        shared_->known = known;
        shared_->news.reset();
        ++shared_->watched;
        shared_->look = true;
        shared_->changed.notify_all();
    }
    if (starts) {
        try {
            thread_ = std::make_unique<LeavableThread>(
                [shared = shared_](const std::stop_token &stop) { run(*shared, stop); }, LeavableThread::kPatience,
                start_);
        } catch (const std::system_error &) { // the next file tries again; until then, changes are not noticed
            forget();
        }
    }
}

void FileWatch::forget() {
    if (shared_) {
        const std::lock_guard lock(shared_->mutex);
        shared_->wake = {}; // what it uses may be gone before the thread ends
    }
    thread_.reset();
    shared_.reset();
    file_.clear();
}

void FileWatch::lookNow() {
    if (shared_) {
        const std::lock_guard lock(shared_->mutex);
        shared_->look = true;
        shared_->changed.notify_all();
    }
}

bool FileWatch::hasNews() const {
    if (!shared_) {
        return false;
    }
    const std::lock_guard lock(shared_->mutex);
    return shared_->news.has_value();
}

std::optional<FileStamp> FileWatch::takeNews() {
    if (!shared_) {
        return std::nullopt;
    }
    const std::lock_guard lock(shared_->mutex);
    return std::exchange(shared_->news, std::nullopt);
}

void FileWatch::run(Shared &shared, const std::stop_token &stop) {
    std::unique_lock lock(shared.mutex);
    while (!stop.stop_requested()) {
        shared.look = false;
        const std::filesystem::path file = shared.file;
        const FileStamp known = shared.known;
        const std::uint64_t watched = shared.watched;
        lock.unlock();
        const FileStamp now = stampOf(file, known);
        lock.lock();
        if (now.known() && watched == shared.watched) {
            const bool changed = known.known() && !now.sameContent(known);
            shared.known = now;
            if (changed) {
                shared.news = now;
                if (shared.wake) {
                    shared.wake();
                }
            }
        }
        shared.changed.wait_for(lock, stop, kPeriod, [&shared] { return shared.look; });
    }
}

} // namespace forefront
