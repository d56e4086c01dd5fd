#include "core/engine/domain/domain.hpp"

namespace forefront {

namespace {

std::string nameOf(const std::map<std::int32_t, std::string> &names, std::int32_t tag, const char *prefix) {
    const auto found = names.find(tag);
    return found != names.end() && !found->second.empty() ? found->second : prefix + std::to_string(tag);
}

} // namespace

Box2 Domain::bounds() const {
    Box2 box;
    for (const Vec2 node : nodes) {
        if (isFinite(node)) {
            box.add(node);
        }
    }
    return box;
}

std::string boundaryName(const std::map<std::int32_t, std::string> &names, std::int32_t tag) {
    return nameOf(names, tag, "boundary_");
}

std::string regionName(const std::map<std::int32_t, std::string> &names, std::int32_t tag) {
    return nameOf(names, tag, "region_");
}

} // namespace forefront
