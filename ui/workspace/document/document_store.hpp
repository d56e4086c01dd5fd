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

/// The open document, its history and its file. Documents are immutable; every change is a labelled command that can be
/// undone.
class DocumentStore {
  public:
    std::shared_ptr<const Document> current() const { return history_.shared(); }
    /// Returns a number that identifies the current state of the document among all states of all documents opened in
    /// this store; undo restores the earlier number.
    std::uint64_t revision() const { return (loads_ << 40) + history_.revision(); }
    /// Returns an id of the history step that the current document belongs to. It is unique across all documents
    /// opened, and stays the same during a stroke.
    std::string step() const { return std::to_string(loads_) + '/' + std::to_string(history_.position()); }
    /// Makes `next` the current document. Consecutive changes with the same non-empty `stroke` form one undo step until
    /// endStroke(), such as a drag or a brush stroke. Sizes of segments stay at their places, divided segments share
    /// their number of elements, numbers that were edited directly lose their formulas, and constraints follow and move
    /// what they must. Error: constraint-conflict, see settleCommand(); the document then stays as it is.
    Status tryApply(Document next, std::string label, std::string_view stroke = {}) {
        Result<Document> completed = completeCommand(*current(), std::move(next));
        if (!completed) {
            return completed.faults();
        }
        tell(history_.commit(std::move(label), *std::move(completed), stroke));
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
    bool replace(Document next, std::string label) { return tell(history_.commit(std::move(label), std::move(next))); }
    void endStroke() { history_.endStroke(); }
    void abandonStroke(std::string_view stroke) {
        history_.abandonStroke(stroke);
        tell(true);
    }
    bool undo() { return tell(history_.undo()); }
    bool redo() { return tell(history_.redo()); }
    /// Makes the document after a command of the history current.
    void goTo(std::size_t entry) {
        history_.goTo(entry);
        tell(true);
    }
    std::string undoLabel() const { return std::string(history_.undoLabel()); }
    std::string redoLabel() const { return std::string(history_.redoLabel()); }
    const History &history() const { return history_; }

    /// Opens another document with a new history. `path` is empty if the document has no file yet. `dirty` marks it
    /// unsaved although it was not edited (recovered, imported). `title` names it while it has no file; empty:
    /// "Untitled 2" or the like. `stamp`: of the file when it was read; unknown: changes of the file do not matter.
    void load(Document document, std::filesystem::path path, bool dirty = false, std::string title = {},
              const FileStamp &stamp = {}) {
        const bool fresh = path.empty() && title.empty();
        const bool unused = untitled() && history_.size() == 1 && !history_.dirty(); // leaves its name to the next one
        if (fresh && !unused) {
            title = untitledName(++untitled_);
        } else if (!fresh && unused && title_ == untitledName(untitled_)) {
            --untitled_; // nobody has used that name
        }
        history_ = History(std::move(document), "Open");
        dirty ? history_.markUnsaved() : history_.markSaved();
        path_ = std::move(path);
        setStamp(stamp);
        title_ = fresh && unused ? title_ : std::move(title);
        ++loads_;
        tell(true);
    }
    const std::filesystem::path &path() const { return path_; }
    /// Returns the name of the file, or the title of a document without one.
    std::string title() const { return path_.empty() ? title_ : path_.filename().string(); }
    /// Keeps a title such as "Untitled 2", that of a document to be recovered, from being given to another one.
    void reserveTitle(std::string_view title) {
        for (int number = 1; number <= kMaxReserved; ++number) {
            untitled_ = title == untitledName(number) ? std::max(untitled_, number) : untitled_;
        }
        if (untitled() && title_ == title) {
            title_ = untitledName(++untitled_);
        }
    }
    /// Returns a number that changes when another document is opened.
    std::uint64_t loads() const { return loads_; }
    bool dirty() const { return history_.dirty(); }
    /// Marks the current document as that of the file; `stamp`: of the file, as for load().
    void markSaved(std::filesystem::path path, const FileStamp &stamp = {}) {
        path_ = std::move(path);
        setStamp(stamp);
        history_.markSaved();
    }
    /// Returns the stamp of the file when it was last read or written.
    const FileStamp &stamp() const { return stamp_; }
    /// Returns a number that changes when the file is read or written.
    std::uint64_t fileUses() const { return fileUses_; }

    /// Returns where the spacing field of the current document is built, once for the preview and the mesh.
    const std::shared_ptr<SharedSpacing> &spacing() const { return spacing_; }
    /// Returns where the domain of the current document is made, once for all who need it.
    const std::shared_ptr<SharedDomain> &sharedDomain() const { return domain_; }
    /// Returns the domain of the current document.
    std::shared_ptr<const Domain> domain() const { return domain_->get(); }

    /// Calls `observer` with the new document whenever the current document changes.
    void observe(std::function<void(const Document &)> observer) { observer_ = std::move(observer); }

  private:
    static constexpr int kMaxReserved = 1000;

    static std::string untitledName(int number) {
        return number == 1 ? "Untitled" : "Untitled " + std::to_string(number);
    }
    bool untitled() const { return path_.empty() && title_.starts_with("Untitled"); }
    void setStamp(const FileStamp &stamp) {
        stamp_ = stamp;
        ++fileUses_;
    }
    bool tell(bool changed) {
        if (changed) {
            spacing_ = std::make_shared<SharedSpacing>();
            domain_ = std::make_shared<SharedDomain>(current());
        }
        if (changed && observer_) {
            observer_(*current());
        }
        return changed;
    }

    History history_;
    std::filesystem::path path_;
    FileStamp stamp_;
    std::uint64_t fileUses_ = 0;
    int untitled_ = 1; ///< documents that got a name of their own, counting the first
    std::string title_ = untitledName(1);
    std::uint64_t loads_ = 1;
    std::function<void(const Document &)> observer_;
    std::shared_ptr<SharedSpacing> spacing_ = std::make_shared<SharedSpacing>();
    std::shared_ptr<SharedDomain> domain_ = std::make_shared<SharedDomain>(current());
};

} // namespace forefront
