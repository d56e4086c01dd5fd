#pragma once

#include "core/engine/base/vec2.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace forefront {

/// The meaning of a line or label in a figure; the window draws each in its canvas colour.
enum class FigureInk : std::uint8_t { Edge, Boundary, Front, Base, Candidate, Accepted, Rejected, Cell, Text };

/// A line of a figure; a dot if both ends are equal.
struct FigureLine {
    Vec2 a, b;
    FigureInk ink = FigureInk::Edge;
};

struct FigureLabel {
    Vec2 at; ///< middle of the text
    std::string_view text;
    FigureInk ink = FigureInk::Text;
};

/// A small drawing in its own units, y up.
struct Figure {
    std::vector<std::array<Vec2, 3>> elements;
    std::vector<FigureLine> lines;
    std::vector<FigureLabel> labels;

    Box2 bounds() const;
};

/// A term of the glossary.
struct GlossaryTerm {
    std::string_view id;                   ///< stable, lower case: "ideal-point"
    std::string_view name;                 ///< "Ideal point C"
    std::vector<std::string_view> phrases; ///< lower case; a text that contains one of them mentions the term
    std::string_view text;
    std::vector<std::string_view> related; ///< ids of other terms
    Figure (*figure)();
};

/// Returns all terms in reading order.
std::span<const GlossaryTerm> glossary();
/// Returns the term with this id, or null.
const GlossaryTerm *glossaryTerm(std::string_view id);
/// Returns the terms that a text mentions, in the order of the glossary.
std::vector<const GlossaryTerm *> termsIn(std::string_view text);

} // namespace forefront
