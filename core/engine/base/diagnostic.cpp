#include "core/engine/base/diagnostic.hpp"

#include "core/engine/base/number_text.hpp"

#include <algorithm>

namespace forefront {

namespace {

const char *word(DomainPartKind kind) {
    switch (kind) {
    case DomainPartKind::Node:
        return "node";
    case DomainPartKind::Segment:
        return "segment";
    case DomainPartKind::ConstraintPoint:
        return "inner point";
    case DomainPartKind::HoleMarker:
        return "hole marker";
    case DomainPartKind::RegionMarker:
        return "region marker";
    }
    return "";
}

/// Returns ": segment 3 (line 7) and segment 5 (line 9)"; empty if only the indices are known.
std::string partsText(const std::vector<DomainPart> &parts) {
    std::string text;
    for (const DomainPart &part : parts) {
        if (!part.number && part.line == 0) {
            continue;
        }
        text += (text.empty() ? ": " : " and ") + std::string(word(part.kind));
        text += part.number ? ' ' + std::to_string(*part.number) : std::string();
        if (part.line > 0) {
            text += " (line " + std::to_string(part.line);
            text += (part.column > 0 ? ", column " + std::to_string(part.column) : std::string()) + ')';
        }
    }
    return text;
}

} // namespace

std::string toString(const Diagnostic &diagnostic) {
    std::string text;
    if (!diagnostic.file.empty()) {
        text += diagnostic.file;
        if (diagnostic.line > 0) {
            text += ':' + std::to_string(diagnostic.line);
            if (diagnostic.column > 0) {
                text += ':' + std::to_string(diagnostic.column);
            }
        }
        text += ": ";
    }
    switch (diagnostic.severity) {
    case Severity::Error:
        text += "error: ";
        break;
    case Severity::Warning:
        text += "warning: ";
        break;
    case Severity::Note:
        text += "note: ";
        break;
    }
    text += diagnostic.message;
    if (diagnostic.at) {
        text += " at (" + numberText(diagnostic.at->x, 9) + ", " + numberText(diagnostic.at->y, 9) + ')';
    }
    text += partsText(diagnostic.parts);
    if (!diagnostic.code.empty()) {
        text += " [" + diagnostic.code + ']';
    }
    if (!diagnostic.advice.empty()) {
        text += "; " + diagnostic.advice;
    }
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

bool hasErrors(const Diagnostics &diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic &d) { return d.severity == Severity::Error; });
}

bool hasCode(const Diagnostics &diagnostics, std::string_view code) {
    return std::any_of(diagnostics.begin(), diagnostics.end(), [code](const Diagnostic &d) { return d.code == code; });
}

Diagnostics error(std::string code, std::string message, std::string advice) {
    Diagnostic diagnostic;
    diagnostic.code = std::move(code);
    diagnostic.message = std::move(message);
    diagnostic.advice = std::move(advice);
    return {std::move(diagnostic)};
}

} // namespace forefront
