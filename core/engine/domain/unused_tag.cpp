#include "core/engine/domain/unused_tag.hpp"

#include "core/engine/domain/domain.hpp"

namespace forefront {

std::int32_t unusedTag(const std::set<std::int32_t> &taken, const std::map<std::int32_t, std::string> &names,
                       TagKind kind) {
    std::set<std::string> used;
    for (const auto &[tag, name] : names) {
        used.insert(name);
    }
    std::int32_t tag = 1;
    while (taken.count(tag) > 0 || names.count(tag) > 0 ||
           used.count(kind == TagKind::Region ? regionName({}, tag) : boundaryName({}, tag)) > 0) {
        ++tag;
    }
    return tag;
}

} // namespace forefront
