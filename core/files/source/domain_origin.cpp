#include "core/files/source/domain_origin.hpp"

#include "core/files/source/text_place.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Returns the bytes at which the lines of a text begin.
std::vector<std::size_t> lineStarts(std::string_view text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
        starts.push_back(at + 1);
    }
    return starts;
}

} // namespace

void addPlaces(Diagnostics &faults, const DomainOrigin &origin, std::string_view text) {
    const std::vector<std::size_t> starts = lineStarts(text);
    for (Diagnostic &fault : faults) {
        if (!fault.file.empty()) {
            continue; // its places are in that file
        }
        if (fault.code.starts_with("expression-") && origin.spacingExpression != PartOrigin::kNowhere) {
            const TextPlace place = placeOf(text, origin.spacingExpression);
            fault.line = place.line;
            fault.column = place.column;
        }
        for (DomainPart &part : fault.parts) {
            const std::vector<PartOrigin> &known = origin.of(part.kind);
            if (part.index >= known.size()) {
                continue; // such as a node that repair has added
            }
            const PartOrigin &place = known[part.index];
            part.number = place.number;
            if (place.offset == PartOrigin::kNowhere) {
                continue;
            }
            const auto line = std::upper_bound(starts.begin(), starts.end(), place.offset) - 1;
            part.line = static_cast<int>(line - starts.begin()) + 1;
            part.column = origin.showsColumns ? static_cast<int>(place.offset - *line) + 1 : 0;
            if (fault.line == 0) {
                fault.line = part.line;
                fault.column = part.column;
            }
        }
    }
}

} // namespace forefront
