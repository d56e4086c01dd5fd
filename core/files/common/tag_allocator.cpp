#include "core/files/common/tag_allocator.hpp"

namespace forefront {

std::int32_t TagAllocator::of(const std::string &name) {
    const auto known = tags_.find(name);
    if (known != tags_.end()) {
        return known->second;
    }
    std::int32_t tag = static_cast<std::int32_t>(tags_.size()) + 1;
    while (!taken_.insert(tag).second) {
        ++tag;
    }
    tags_.emplace(name, tag);
    if (!name.empty()) {
        names_.emplace(tag, name);
    }
    return tag;
}

std::optional<std::int32_t> TagAllocator::find(const std::string &name) const {
    const auto known = tags_.find(name);
    return known == tags_.end() ? std::nullopt : std::optional(known->second);
}

} // namespace forefront
