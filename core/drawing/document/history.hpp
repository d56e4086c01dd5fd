#pragma once

#include "core/drawing/document/document.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Unlimited undo and redo over immutable documents. Every entry is a labelled command with the document that it
/// produced; unchanged parts are shared between entries. Never empty: entry 0 is the document as opened.
class History {
  public:
    explicit History(Document start = {}, std::string label = "New document");

    const Document &document() const { return *entries_[position_].document; }
    std::shared_ptr<const Document> shared() const { return entries_[position_].document; }
    /// Returns a number that is different for every document that was ever current; a key for caches.
    std::uint64_t revision() const { return entries_[position_].revision; }

    /// Makes `document` current and discards everything that could be redone. Consecutive commands with the same
    /// non-empty `stroke` (a drag, a brush stroke) become one entry, until endStroke(). A document with the same
    /// content as the current one is not recorded. Returns true if something changed.
    bool commit(std::string label, Document document, std::string_view stroke = {});
    void endStroke();
    /// Cancels a stroke, as when Esc is pressed during a drag, and restores the redo steps from before it. No effect if
    /// the current entry is not of that stroke, which changed nothing then.
    void abandonStroke(std::string_view stroke);

    bool canUndo() const { return position_ > 0; }
    bool canRedo() const { return position_ + 1 < entries_.size(); }
    /// Returns the label of the command that undo() would undo; empty if there is none.
    std::string_view undoLabel() const;
    std::string_view redoLabel() const;
    bool undo();
    bool redo();
    /// Makes the document of an entry in [0, size()) current.
    void goTo(std::size_t entry);
    std::size_t size() const { return entries_.size(); }
    std::size_t position() const { return position_; }
    std::string_view label(std::size_t entry) const { return entries_[entry].label; }

    /// Records that the current document has been saved.
    void markSaved() { saved_ = revision(); }
    /// Records that the current document is not saved in any file, as after recovery or import.
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
    std::string stroke_;           ///< stroke of the current entry; empty: closed
    std::vector<Entry> discarded_; ///< redo steps from before the stroke
};

} // namespace forefront
