#pragma once

#include "core/drawing_files/svg/svg.hpp"
#include "core/engine/domain/domain.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace forefront::testing {

/// Returns an SVG file whose content begins in line 2.
inline std::string svgDrawing(const std::string &content, const std::string &attributes = "viewBox=\"0 0 10 10\"") {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" " + attributes +
           ">\n" + content + "\n</svg>\n";
}

/// Reads an SVG file, with what is beyond its page.
inline Domain svgDomain(const std::string &text, ImportNotes *notes = nullptr) {
    SourceText source = sourceOf(text, "drawing.svg");
    source.notes = notes;
    source.options.beyondPage = true;
    const auto domain = readSvg(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    return *domain;
}

/// Returns the absolute area enclosed by the boundary segments, for loops that do not overlap and run alike.
inline double enclosedArea(const Domain &domain) {
    double area = 0.0;
    for (const DomainSegment &segment : domain.segments) {
        area += 0.5 * cross(domain.nodes[segment.a], domain.nodes[segment.b]);
    }
    return std::fabs(area);
}

} // namespace forefront::testing
