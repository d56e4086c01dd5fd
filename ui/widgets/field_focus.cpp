#include "ui/widgets/field_focus.hpp"

#include <algorithm>
#include <utility>

namespace forefront {
namespace {

constexpr int kMaxFrames = 8; ///< that a request waits for its field

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
    asked_ = false;
    framesLeft_ = kMaxFrames;
}

void FieldFocus::gotFocus(std::string_view name) {
    if (wanted_ == name) {
        wanted_.clear();
    }
}

bool FieldFocus::takes(std::string_view name) {
    const bool now = !wanted_.empty() && wanted_ == name && !asked_;
    asked_ = asked_ || now;
    return now;
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
    leaving_ = false;
    if (entry && !inSight(entry->name)) {
        entry.reset(); // its field is gone
    }
    if (--framesLeft_ <= 0) {
        wanted_.clear();
    }
    if (!inSight(held_)) {
        held_.clear();
    }
    followTab();
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
        request(fields[(back_ ? previous : next) % fields.size()]);
    }
}

} // namespace forefront
