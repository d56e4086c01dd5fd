#include "core/drawing/commands/guide_commands.hpp"

#include <cmath>

namespace forefront {
namespace {

Diagnostics guideFault(const Document &document, std::size_t index, double at) {
    if (index >= document.guides.size()) {
        return error("no-such-guide", "guide not found");
    }
    return std::isfinite(at) ? Diagnostics() : error("bad-number", "expected a finite co-ordinate of a guide");
}

} // namespace

Result<Document> addGuide(const Document &document, Guide guide) {
    Document next = document;
    next.guides.push_back(guide);
    Diagnostics faults = guideFault(next, document.guides.size(), guide.at);
    return faults.empty() ? Result<Document>(std::move(next)) : Result<Document>(std::move(faults));
}

Result<Document> moveGuide(const Document &document, std::size_t index, double at) {
    if (Diagnostics faults = guideFault(document, index, at); !faults.empty()) {
        return faults;
    }
    Document next = document;
    next.guides[index].at = at;
    return next;
}

Result<Document> removeGuide(const Document &document, std::size_t index) {
    if (Diagnostics faults = guideFault(document, index, 0.0); !faults.empty()) {
        return faults;
    }
    Document next = document;
    next.guides.erase(next.guides.begin() + static_cast<std::ptrdiff_t>(index));
    return next;
}

} // namespace forefront
