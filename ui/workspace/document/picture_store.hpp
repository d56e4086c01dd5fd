#pragma once

#include "core/drawing/document/document.hpp"
#include "ui/background/background_task.hpp"
#include "ui/background/file_watch.hpp"
#include "ui/canvas/picture.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace forefront {

/// Keeps the pixels of the document's background picture, which are read on a separate thread, and again when another
/// program has changed the file.
class PictureStore {
  public:
    explicit PictureStore(BackgroundList &list) : task_(list), watch_(list) {}

    /// Reads the picture of a document unless that has been done. `loads` identifies the opened document, see
    /// DocumentStore::loads(): a file that was missing is looked for again when its document is opened again.
    void follow(const Document &document, std::uint64_t loads);
    /// Uses a picture that was read elsewhere.
    void accept(std::shared_ptr<const Picture> picture);
    /// Takes the result of the other thread. Returns true if there is one. Adds to `news` the reasons why the picture
    /// cannot be shown, and notes that its file has changed.
    bool refresh(Diagnostics &news);
    /// Looks at once whether the file has changed.
    void lookNow() { watch_.lookNow(); }

    /// Returns the picture of the document; null if it has none, or its pixels are missing.
    const std::shared_ptr<const Picture> &shown() const { return shown_; }
    /// Returns true if the document has a picture that cannot be read.
    bool failed() const { return failed_; }

  private:
    void startReading();
    void takeChange(Diagnostics &news);

    BackgroundTask task_;
    FileWatch watch_;
    std::shared_ptr<const Picture> read_; ///< the last one read, so that undo and redo do not read it again
    std::shared_ptr<const Picture> shown_;
    std::string file_; ///< of the document's picture; empty: none
    std::uint64_t loads_ = 0;
    bool failed_ = false;
    Diagnostics news_; ///< not taken yet
};

} // namespace forefront
