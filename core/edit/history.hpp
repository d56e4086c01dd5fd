#pragma once

#include "core/edit/document.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Unlimited undo and redo over immutable documents. Every entry is a labelled command with the document that it made;
/// what did not change is shared between entries. Never empty: entry 0 is the document as opened.
class History {
  public:
    explicit History(Document start = {}, std::string label = "New document");

    const Document &document() const { return *entries_[position_].document; }
    std::shared_ptr<const Document> shared() const { return entries_[position_].document; }
    /// Differs between any two documents that have ever been current here: a key for caches.
    std::uint64_t revision() const { return entries_[position_].revision; }

    /// Makes `document` current and forgets what had been undone. With a non-empty `stroke`, commands that follow one
    /// another with the same stroke become one (a drag, a stroke of the brush), until endStroke(). A document that
    /// says the same as the current one is not recorded. Returns whether something changed.
    bool commit(std::string label, Document document, std::string_view stroke = {});
    void endStroke() { stroke_.clear(); }
    /// Undoes the stroke in progress as if it had never begun (Esc during a drag).
    void abandonStroke();

    bool canUndo() const { return position_ > 0; }
    bool canRedo() const { return position_ + 1 < entries_.size(); }
    /// Label of the command that undo() would take back; empty if there is none.
    std::string_view undoLabel() const;
    std::string_view redoLabel() const;
    bool undo();
    bool redo();
    /// Goes to an entry in [0, size).
    void goTo(std::size_t entry);
    std::size_t size() const { return entries_.size(); }
    std::size_t position() const { return position_; }
    std::string_view label(std::size_t entry) const { return entries_[entry].label; }

    /// The current document is what the file holds.
    void markSaved() { saved_ = revision(); }
    /// The current document is in no file (recovered or imported).
    void markUnsaved() { saved_ = 0; }
    bool dirty() const { return revision() != saved_; }

  private:
    struct Entry {
        std::string label;
        std::shared_ptr<const Document> document;
        std::uint64_t revision = 0;
    };

    std::vector<Entry> entries_;
    std::size_t position_ = 0;
    std::uint64_t nextRevision_ = 1;
    std::uint64_t saved_ = 0;
    std::string stroke_; ///< of the current entry; empty: closed
};

} // namespace forefront
