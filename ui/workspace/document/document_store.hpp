#pragma once

#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/document/history.hpp"
#include "core/drawing/domain/shared_domain.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/spacing/shared_spacing.hpp"
#include "core/files/source/file_stamp.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace forefront {

/// A document, its history and its file.
struct OpenDocument {
    History history;
    std::filesystem::path path; ///< empty: it has no file yet
    FileStamp stamp;            ///< of the file when it was last read or written
    std::string title = "Untitled";
    std::uint64_t loads = 1; ///< number of documents opened before it and with it
    std::shared_ptr<SharedSpacing> spacing = std::make_shared<SharedSpacing>();
    std::shared_ptr<SharedDomain> domain = std::make_shared<SharedDomain>(history.shared());

    /// Returns the name of the file, or the title of a document without one.
    std::string name() const { return path.empty() ? title : path.filename().string(); }
    /// See DocumentStore::revision().
    std::uint64_t revision() const { return (loads << 40) + history.revision(); }
};

/// The open document, its history and its file. Documents are immutable; every change is a labelled command that can be
/// undone.
class DocumentStore {
  public:
    std::shared_ptr<const Document> current() const { return open_.history.shared(); }
    /// Returns a number that identifies the current state of the document among all states of all documents opened in
    /// this store; undo restores the earlier number.
    std::uint64_t revision() const { return open_.revision(); }
    /// Returns an id of the history step that the current document belongs to. It is unique across all documents
    /// opened, and stays the same during a stroke.
    std::string step() const { return std::to_string(open_.loads) + '/' + std::to_string(open_.history.position()); }
    /// Makes `next` the current document. Consecutive changes with the same non-empty `stroke` form one undo step until
    /// endStroke(), such as a drag or a brush stroke. Sizes of segments stay at their places, divided segments share
    /// their number of elements, numbers that were edited directly lose their formulas, and constraints follow and move
    /// what they must. Error: constraint-conflict, see settleCommand(); the document then stays as it is.
    Status tryApply(Document next, std::string label, std::string_view stroke = {}) {
        Result<Document> completed = completeCommand(*current(), std::move(next));
        if (!completed) {
            return completed.faults();
        }
        tell(open_.history.commit(std::move(label), *std::move(completed), stroke));
        return {};
    }
    /// Does the same for a command that moves no shapes, and so contradicts no constraint. Returns false if nothing
    /// changed.
    bool apply(Document next, std::string label, std::string_view stroke = {}) {
        const std::uint64_t before = revision();
        static_cast<void>(tryApply(std::move(next), std::move(label), stroke));
        return revision() != before;
    }
    /// Makes `next` the current document as it is, as one command that can be undone. Returns false if nothing changed.
    bool replace(Document next, std::string label) {
        return tell(open_.history.commit(std::move(label), std::move(next)));
    }
    void endStroke() { open_.history.endStroke(); }
    void abandonStroke(std::string_view stroke) {
        open_.history.abandonStroke(stroke);
        tell(true);
    }
    bool undo() { return tell(open_.history.undo()); }
    bool redo() { return tell(open_.history.redo()); }
    /// Makes the document after a command of the history current.
    void goTo(std::size_t entry) {
        open_.history.goTo(entry);
        tell(true);
    }
    std::string undoLabel() const { return std::string(open_.history.undoLabel()); }
    std::string redoLabel() const { return std::string(open_.history.redoLabel()); }
    const History &history() const { return open_.history; }

    /// Opens another document with a new history. `path` is empty if the document has no file yet. `dirty` marks it
    /// unsaved although it was not edited (recovered, imported). `title` names it while it has no file; empty:
    /// "Untitled 2" or the like. `stamp`: of the file when it was read; unknown: changes of the file do not matter.
    void load(Document document, std::filesystem::path path, bool dirty = false, std::string title = {},
              const FileStamp &stamp = {}) {
        const bool fresh = path.empty() && title.empty();
        const bool unused =
            untitled() && open_.history.size() == 1 && !open_.history.dirty(); // leaves its name to the next one
        if (fresh && !unused) {
            title = untitledName(++untitled_);
        } else if (!fresh && unused && open_.title == untitledName(untitled_)) {
            --untitled_; // nobody has used that name
        }
        open_.history = History(std::move(document), "Open");
        dirty ? open_.history.markUnsaved() : open_.history.markSaved();
        open_.path = std::move(path);
        setStamp(stamp);
        open_.title = fresh && unused ? open_.title : std::move(title);
        open_.loads = ++loads_;
        tell(true);
    }
    /// Opens an empty document and returns the one that was open, whose history is kept.
    OpenDocument leave() {
        OpenDocument fresh;
        fresh.loads = ++loads_;
        return enter(std::move(fresh));
    }
    /// Gives a document without a file a name of its own.
    void giveName() { open_.title = untitledName(++untitled_); }
    /// Opens a document that was left, and returns the one that was open.
    OpenDocument enter(OpenDocument other) {
        std::swap(open_, other);
        ++fileUses_;
        if (observer_) {
            observer_(*current());
        }
        return other;
    }
    const std::filesystem::path &path() const { return open_.path; }
    /// Returns the name of the file, or the title of a document without one.
    std::string title() const { return open_.name(); }
    /// Keeps a title such as "Untitled 2", that of a document to be recovered, from being given to another one.
    void reserveTitle(std::string_view title) {
        for (int number = 1; number <= kMaxReserved; ++number) {
            untitled_ = title == untitledName(number) ? std::max(untitled_, number) : untitled_;
        }
        if (untitled() && open_.title == title) {
            open_.title = untitledName(++untitled_);
        }
    }
    /// Returns a number that changes when another document is opened.
    std::uint64_t loads() const { return open_.loads; }
    bool dirty() const { return open_.history.dirty(); }
    /// Marks the current document as that of the file; `stamp`: of the file, as for load().
    void markSaved(std::filesystem::path path, const FileStamp &stamp = {}) {
        open_.path = std::move(path);
        setStamp(stamp);
        open_.history.markSaved();
    }
    /// Returns the stamp of the file when it was last read or written.
    const FileStamp &stamp() const { return open_.stamp; }
    /// Returns a number that changes when the file is read or written.
    std::uint64_t fileUses() const { return fileUses_; }

    /// Returns where the spacing field of the current document is built, once for the preview and the mesh.
    const std::shared_ptr<SharedSpacing> &spacing() const { return open_.spacing; }
    /// Returns where the domain of the current document is made, once for all who need it.
    const std::shared_ptr<SharedDomain> &sharedDomain() const { return open_.domain; }
    /// Returns the domain of the current document.
    std::shared_ptr<const Domain> domain() const { return open_.domain->get(); }

    /// Calls `observer` with the new document whenever the current document changes.
    void observe(std::function<void(const Document &)> observer) { observer_ = std::move(observer); }

  private:
    static constexpr int kMaxReserved = 1000;

    static std::string untitledName(int number) {
        return number == 1 ? "Untitled" : "Untitled " + std::to_string(number);
    }
    bool untitled() const { return open_.path.empty() && open_.title.starts_with("Untitled"); }
    void setStamp(const FileStamp &stamp) {
        open_.stamp = stamp;
        ++fileUses_;
    }
    bool tell(bool changed) {
        if (changed) {
            open_.spacing = std::make_shared<SharedSpacing>();
            open_.domain = std::make_shared<SharedDomain>(current());
        }
        if (changed && observer_) {
            observer_(*current());
        }
        return changed;
    }

    OpenDocument open_;
    std::uint64_t fileUses_ = 0;
    int untitled_ = 1;        ///< documents that got a name of their own, counting the first
    std::uint64_t loads_ = 1; ///< documents opened so far
    std::function<void(const Document &)> observer_;
};

} // namespace forefront
