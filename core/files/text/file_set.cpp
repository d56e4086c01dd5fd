#include "core/files/text/file_set.hpp"

#include "core/engine/platform/file_handle.hpp"
#include "core/files/text/atomic_file.hpp"
#include "core/files/text/temporary_names.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace forefront {

namespace {

/// Adds to a fault that the other files of a set were left as they were.
Status nothingReplaced(Status faults, std::size_t files) {
    if (files > 1 && !faults.empty()) {
        faults.front().message += "; the other files that belong to it were not replaced either";
    }
    return faults;
}

} // namespace

FileSet::FileSet() = default;
FileSet::~FileSet() {
    files_.clear(); // with their temporary files
    removeFolders();
}

bool FileSet::write(const std::filesystem::path &path, const std::function<void(TextWriter &)> &fill,
                    const Progress &progress, std::size_t expectedBytes) {
    if (!status_.empty()) {
        return false;
    }
    files_.push_back(std::make_unique<AtomicFile>(path, progress, expectedBytes));
    AtomicFile &file = *files_.back();
    {
        TextWriter out(file);
        fill(out);
        out.flush();
    }
    status_ = nothingReplaced(file.finish(), files_.size());
    return status_.empty();
}

bool FileSet::makeFolder(const std::filesystem::path &folder) {
    std::vector<std::filesystem::path> missing;
    std::error_code problem;
    for (std::filesystem::path each = folder; !each.empty() && !std::filesystem::is_directory(each, problem);
         each = each.parent_path()) {
        missing.push_back(each);
    }
    for (; status_.empty() && !missing.empty(); missing.pop_back()) {
        if (std::filesystem::create_directory(missing.back(), problem)) {
            folders_.push_back(missing.back());
        } else {
            status_ = error("cannot-write",
                            "cannot make the folder: " + (problem ? problem.message() : "a file has its name"));
            status_.front().file = missing.back().string();
        }
    }
    return status_.empty();
}

void FileSet::removeFolders() {
    for (; !folders_.empty(); folders_.pop_back()) {
        std::error_code none;
        std::filesystem::remove(folders_.back(), none); // fails, rightly, if others have put files there
    }
}

bool FileSet::write(const std::filesystem::path &path, std::string_view bytes) {
    return write(path, [bytes](TextWriter &out) { out << bytes; });
}

Status FileSet::commit() {
    for (std::size_t k = 0; k < files_.size() && status_.empty(); ++k) {
        status_ = nothingReplaced(files_[k]->publish(), files_.size());
    }
    if (!status_.empty()) {
        for (std::size_t k = files_.size(); k-- > 0;) {
            files_[k]->withdraw();
        }
        files_.clear(); // with their temporary files
        removeFolders();
        return status_;
    }
    std::set<std::filesystem::path> folders;
    for (const std::unique_ptr<AtomicFile> &file : files_) {
        file->release();
        folders.insert(folderOf(file->target()));
    }
    std::for_each(folders.begin(), folders.end(), syncFolder);
    files_.clear();
    folders_.clear();
    return status_;
}

} // namespace forefront
