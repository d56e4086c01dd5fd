#include "app/batch/exit_code.hpp"

#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/files/files.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Translates advice into the options of the command line.
std::string inOptions(std::string advice) {
    constexpr std::pair<std::string_view, std::string_view> kOptions[] = {
        {"repair the domain with a weld tolerance of", "add --repair --weld"},
        {"repair the domain", "add --repair"},
        {"lower the weld tolerance", "lower --weld"},
        {"raise the maximum number of elements", "raise --max-elements"},
        {"choose an element size of", "choose a --size of"},
        {"set a gradation", "add --gradation G"},
        {"let segments be divided", "leave out --keep-boundary"}};
    for (const auto &[words, option] : kOptions) {
        if (const std::size_t at = advice.find(words); at != std::string::npos) {
            advice.replace(at, words.size(), option);
        }
    }
    return advice;
}

/// Replaces parts of a repaired domain by the parts of the input domain that they come from; drops new ones.
void restoreParts(std::vector<DomainPart> &parts, const Repaired &repaired) {
    for (DomainPart &part : parts) {
        const std::vector<std::uint32_t> *const source =
            part.kind == DomainPartKind::Node              ? &repaired.nodeSource
            : part.kind == DomainPartKind::Segment         ? &repaired.segmentSource
            : part.kind == DomainPartKind::ConstraintPoint ? &repaired.pointSource
            : part.kind == DomainPartKind::HoleMarker      ? &repaired.holeMarkerSource
                                                           : nullptr;
        if (source != nullptr) {
            part.index = part.index < source->size() ? (*source)[part.index] : kNoIndex;
        } // a repair keeps region markers
    }
    std::erase_if(parts, [](const DomainPart &part) { return part.index == kNoIndex; });
}

} // namespace

void printFaults(const Diagnostics &faults) {
    for (Diagnostic fault : faults) {
        fault.advice = inOptions(std::move(fault.advice));
        std::fprintf(stderr, "%s\n", toString(fault).c_str());
    }
}

Diagnostics locateInDomain(Diagnostics faults, const Input &input, const Repaired *repaired) {
    Diagnostics ofDomain;
    std::vector<std::size_t> position;
    for (std::size_t k = 0; k < faults.size(); ++k) {
        if (!faults[k].parts.empty() && faults[k].file.empty()) {
            position.push_back(k);
            ofDomain.push_back(std::move(faults[k]));
            if (repaired != nullptr) {
                restoreParts(ofDomain.back().parts, *repaired);
            }
        }
    }
    if (!ofDomain.empty()) {
        ofDomain = allFormats().locateFaults(input.path, std::move(ofDomain), input.options);
    }
    for (std::size_t k = 0; k < position.size(); ++k) {
        faults[position[k]] = std::move(ofDomain[k]);
    }
    return faults;
}

Diagnostics locateSpacing(Diagnostics faults, const Input &project) {
    const bool any = std::any_of(faults.begin(), faults.end(),
                                 [](const Diagnostic &fault) { return fault.code.starts_with("expression-"); });
    return any ? allFormats().locateFaults(project.path, std::move(faults), project.options) : faults;
}

Diagnostics meshingFaults(const Diagnostics &faults, const Domain &domain, const Input &input,
                          const Repaired *repaired) {
    if (hasCode(faults, "cancelled")) {
        return faults;
    }
    Diagnostics own = validate(domain);
    for (Diagnostic &fault : own) {
        if (repaired != nullptr) {
            restoreParts(fault.parts, *repaired);
        }
    }
    return own.empty() ? faults : allFormats().locateFaults(input.path, std::move(own), input.options);
}

} // namespace forefront
