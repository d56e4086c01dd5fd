#pragma once

#include "core/edit/history.hpp"

#include <cstdint>
#include <filesystem>
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
    /// Differs between any two documents that were ever open here; undo returns to the number from before.
    std::uint64_t revision() const { return (loads_ << 40) + history_.revision(); }
    /// Names the step of the history that the current document belongs to. Differs between documents opened one after
    /// the other; stays the same while a stroke goes on.
    std::string step() const { return std::to_string(loads_) + '/' + std::to_string(history_.position()); }
    /// Makes `next` the current document. Changes that follow one another with the same non-empty `stroke` are one undo
    /// step until endStroke(): a drag, a stroke of the brush. False if nothing changed.
    bool apply(Document next, std::string label, std::string_view stroke = {}) {
        return history_.commit(std::move(label), std::move(next), stroke);
    }
    void endStroke() { history_.endStroke(); }
    void abandonStroke() { history_.abandonStroke(); }
    bool undo() { return history_.undo(); }
    bool redo() { return history_.redo(); }
    std::string undoLabel() const { return std::string(history_.undoLabel()); }
    std::string redoLabel() const { return std::string(history_.redoLabel()); }
    History &history() { return history_; }
    const History &history() const { return history_; }

    /// Another document altogether; its history starts here. `path` empty: in no file yet. `dirty`: asks to be saved
    /// although nothing was done to it (recovered, imported).
    /// `title`: what to call it while it is in no file.
    void load(Document document, std::filesystem::path path, bool dirty = false, std::string title = {}) {
        history_ = History(std::move(document), "Open");
        dirty ? history_.markUnsaved() : history_.markSaved();
        path_ = std::move(path);
        title_ = std::move(title);
        ++loads_;
    }
    const std::filesystem::path &path() const { return path_; }
    /// Name of the file, or what else the document is called.
    std::string title() const {
        return !path_.empty() ? path_.filename().string() : title_.empty() ? "untitled" : title_;
    }
    bool dirty() const { return history_.dirty(); }
    void markSaved(std::filesystem::path path) {
        path_ = std::move(path);
        history_.markSaved();
    }

  private:
    History history_;
    std::filesystem::path path_;
    std::string title_;
    std::uint64_t loads_ = 1;
};

} // namespace forefront
