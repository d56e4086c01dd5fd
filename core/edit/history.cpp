#include "core/edit/history.hpp"

#include "core/edit/equality.hpp"

namespace forefront {

History::History(Document start, std::string label) {
    entries_.push_back({std::move(label), std::make_shared<const Document>(std::move(start)), nextRevision_++});
    markSaved();
}

bool History::commit(std::string label, Document document, std::string_view stroke) {
    if (sameContent(document, this->document())) {
        return false;
    }
    const bool goesOn = !stroke.empty() && stroke == stroke_ && !canRedo() && position_ > 0 && dirty();
    entries_.resize(position_ + 1);
    Entry entry{std::move(label), std::make_shared<const Document>(std::move(document)), nextRevision_++};
    if (goesOn) {
        entries_.back() = std::move(entry);
    } else {
        entries_.push_back(std::move(entry));
        ++position_;
    }
    stroke_ = stroke;
    return true;
}

void History::abandonStroke() {
    if (!stroke_.empty() && undo()) {
        entries_.resize(position_ + 1);
    }
    endStroke();
}

std::string_view History::undoLabel() const {
    return canUndo() ? std::string_view(entries_[position_].label) : std::string_view();
}

std::string_view History::redoLabel() const {
    return canRedo() ? std::string_view(entries_[position_ + 1].label) : std::string_view();
}

bool History::undo() {
    if (!canUndo()) {
        return false;
    }
    goTo(position_ - 1);
    return true;
}

bool History::redo() {
    if (!canRedo()) {
        return false;
    }
    goTo(position_ + 1);
    return true;
}

void History::goTo(std::size_t entry) {
    FOREFRONT_ASSERT(entry < entries_.size());
    position_ = entry;
    endStroke();
}

} // namespace forefront
