#include "ui/widgets/field_focus.hpp"

#include <algorithm>
#include <utility>

namespace forefront {
namespace {

constexpr int kMaxFrames = 8; ///< that a request waits for its field
constexpr int kAskAgain = 3;  ///< frames after which Dear ImGui is asked for the focus again

} // namespace

void FieldFocus::tab(std::string_view name, bool back) {
    tabbed_ = name;
    back_ = back;
}

void FieldFocus::tabInto(unsigned group, bool back) {
    tabbedInto_ = group;
    back_ = back;
}

void FieldFocus::request(std::string_view name) {
    wanted_ = name;
    next_.clear();
    asked_ = 0;
    framesLeft_ = kMaxFrames;
}

void FieldFocus::gotFocus(std::string_view name) {
    focused_ = name;
    if (wanted_ == name) {
        wanted_.clear();
    }
}

bool FieldFocus::takes(std::string_view name) {
    if (!wants(name) || --asked_ > 0) {
        return false;
    }
    asked_ = kAskAgain;
    return true;
}

void FieldFocus::commit(Entry what, bool tookFocus) {
    committed = what.name;
    commit_ = std::move(what);
    tookFocus_ = tookFocus;
}

void FieldFocus::refuse(std::string_view name) {
    if (!commit_ || commit_->name != name) {
        return;
    }
    refused_ = {*std::exchange(commit_, std::nullopt), !tookFocus_};
    if (refused_->returns) { // also from the next field, if Tab was pressed
        tabbed_.reset();
        wanted_.clear();
    }
}

const FieldFocus::Refused *FieldFocus::refused(std::string_view name) const {
    return refused_ && refused_->entry.name == name ? &*refused_ : nullptr;
}

void FieldFocus::forgive(std::string_view name) {
    if (refused(name) != nullptr) {
        refused_.reset();
    }
}

bool FieldFocus::inSight(std::string_view name) const {
    return std::any_of(order_.begin(), order_.end(), [&](const Field &field) { return field.name == name; });
}

void FieldFocus::replace(std::string_view name, std::string text) {
    replaced_ = name;
    with_ = std::move(text);
    framesToReplace_ = kMaxFrames;
}

std::optional<std::string> FieldFocus::replacement(std::string_view name) {
    if (replaced_.empty() || replaced_ != name) {
        return std::nullopt;
    }
    replaced_.clear();
    return std::exchange(with_, {});
}

void FieldFocus::endFrame() {
    if (--framesToReplace_ <= 0) {
        replaced_.clear();
    }
    leaving_ = Leave::No;
    commit_.reset();
    if (entry && !inSight(entry->name)) {
        entry.reset(); // its field is gone
    }
    if (refused_ && !inSight(refused_->entry.name)) {
        refused_.reset();
    }
    if (--framesLeft_ <= 0) {
        wanted_.clear();
    }
    replaceMissing();
    if (!inSight(held_)) {
        held_.clear();
    }
    followTab();
}

/// If the field that Tab leads to has gone, because the text just committed changed the form, requests the next one.
void FieldFocus::replaceMissing() {
    if (wanted_.empty() || next_.empty() || inSight(wanted_)) {
        return;
    }
    const auto next =
        std::find_if(next_.begin(), next_.end(), [this](const std::string &name) { return inSight(name); });
    if (next != next_.end()) {
        request(std::string(*next));
    }
}

/// Requests the focus for the next field of the group, or its first or last one if none has it.
void FieldFocus::followTab() {
    const std::optional<std::string> from = std::exchange(tabbed_, {});
    std::optional<unsigned> group = std::exchange(tabbedInto_, {});
    if (from) {
        const auto here = std::find_if(order_.begin(), order_.end(), [&](const Field &f) { return f.name == *from; });
        group = here == order_.end() ? std::nullopt : std::optional(here->group);
    }
    std::vector<std::string> fields;
    std::size_t at = 0;
    for (const Field &field : order_) {
        if (field.group == group) {
            at = field.name == from ? fields.size() : at;
            fields.push_back(field.name);
        }
    }
    if (!fields.empty()) {
        const std::size_t next = from ? at + 1 : 0, previous = from ? at + fields.size() - 1 : fields.size() - 1;
        const std::size_t step = back_ ? fields.size() - 1 : 1;
        std::size_t to = (back_ ? previous : next) % fields.size();
        request(fields[to]);
        for (std::size_t k = 1; k < fields.size(); ++k) {
            to = (to + step) % fields.size();
            next_.push_back(fields[to]);
        }
    }
}

} // namespace forefront
