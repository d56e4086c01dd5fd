#include "core/drawing/document/history.hpp"

#include "core/drawing/document/equality.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace forefront {

History::History(Document start, std::string label) {
    entries_.push_back({std::move(label), std::make_shared<const Document>(std::move(start)), nextRevision_++});
    markSaved();
}

bool History::commit(std::string label, Document document, std::string_view stroke) {
    if (sameContent(document, this->document())) {
        return false;
    }
    const bool continuesStroke = !stroke.empty() && stroke == stroke_ && !canRedo() && position_ > 0 && dirty();
    Entry entry{std::move(label), std::make_shared<const Document>(std::move(document)), nextRevision_++};
    if (continuesStroke) {
        entries_.back() = std::move(entry);
    } else {
        const auto tail = entries_.begin() + static_cast<std::ptrdiff_t>(++position_);
        discarded_.clear();
        if (!stroke.empty()) {
            discarded_.assign(std::make_move_iterator(tail), std::make_move_iterator(entries_.end()));
        }
        entries_.erase(tail, entries_.end());
        entries_.push_back(std::move(entry));
    }
    stroke_ = stroke;
    return true;
}

void History::endStroke() {
    stroke_.clear();
    discarded_.clear();
}

void History::abandonStroke(std::string_view stroke) {
    if (stroke_.empty() || stroke != stroke_ || !canUndo()) {
        return;
    }
    entries_.resize(position_--);
    std::move(discarded_.begin(), discarded_.end(), std::back_inserter(entries_));
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
