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
    if (!tabbed_) {
        return;
    }
    const auto here = std::find_if(order_.begin(), order_.end(), [&](const Field &f) { return f.name == *tabbed_; });
    tabbed_.reset();
    if (here == order_.end()) {
        return;
    }
    std::vector<std::string> group;
    std::size_t at = 0;
    for (const Field &field : order_) {
        if (field.group == here->group) {
            at = &field == &*here ? group.size() : at;
            group.push_back(field.name);
        }
    }
    request(group[(at + (back_ ? group.size() - 1 : 1)) % group.size()]);
}

} // namespace forefront
