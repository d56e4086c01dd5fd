#include "ui/workspace/messages/blamed_constraints.hpp"

namespace forefront {

std::set<std::uint32_t> blamedConstraints(const MessageLog &log, std::uint64_t revision) {
    const auto &entries = log.entries();
    for (auto entry = entries.rbegin(); entry != entries.rend() && entry->revision == revision; ++entry) {
        if (entry->diagnostic.code.starts_with("constraint-")) {
            return {entry->diagnostic.ids.begin(), entry->diagnostic.ids.end()};
        }
    }
    return {};
}

} // namespace forefront
