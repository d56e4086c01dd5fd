#pragma once

#include "core/files/source/file_stamp.hpp"
#include "ui/background/background_list.hpp"
#include "ui/background/leavable_thread.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace forefront {

/// Watches a file for changes by other programs. A thread of its own looks at it every few seconds, since the disc may
/// be slow or no longer answer. Call all members from one thread; none of them waits.
class FileWatch final : public BackgroundActivity {
  public:
    /// `start`: replaced by tests. If no thread can be started, nothing is watched.
    explicit FileWatch(BackgroundList &list, ThreadStarter start = startThread)
        : BackgroundActivity(list), start_(std::move(start)) {}
    ~FileWatch() override { forget(); }

    /// Watches `file`, which held `known` when it was last read or written, in place of the earlier one.
    void watch(const std::filesystem::path &file, const FileStamp &known);
    /// Watches nothing.
    void forget();
    const std::filesystem::path &file() const { return file_; }
    /// Looks at the file at once, such as when the window gets the focus.
    void lookNow();
    /// Returns false: the window does not wait for a change.
    bool working() const override { return false; }
    bool hasNews() const override;
    /// Returns the new state of the file if another program has changed or deleted it since the last call.
    std::optional<FileStamp> takeNews();

    static constexpr std::chrono::milliseconds kPeriod{2000};

  private:
    /// The state shared by the thread and its owner.
    struct Shared {
        std::mutex mutex;
        std::condition_variable_any changed;
        std::filesystem::path file;
        FileStamp known;
        std::optional<FileStamp> news;
        std::function<void()> wake;
        std::uint64_t watched = 0; ///< counts the calls of watch()
        bool look = false;
    };
    static void run(Shared &shared, const std::stop_token &stop);

    ThreadStarter start_;
    std::filesystem::path file_;
    std::shared_ptr<Shared> shared_;
    std::unique_ptr<LeavableThread> thread_; ///< null: nothing is watched
};

} // namespace forefront
