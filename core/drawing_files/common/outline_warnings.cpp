#include "core/drawing_files/common/drawing_builder.hpp"
#include "core/drawing_files/common/outline_overlaps.hpp"
#include "core/engine/base/number_text.hpp"

namespace forefront {

namespace {

/// Returns " at (1, 2)" or ", first at (1, 2), (3, 4)", to be appended to a message.
std::string placesText(std::size_t count, const std::vector<Vec2> &places) {
    ArrangementChange change;
    change.count = count;
    change.places = places;
    return placesOf(change);
}

} // namespace

/// Returns the names and places of two outlines: "those of 'A' (line 12) and 'B' (line 40)".
std::string DrawingBuilder::pairText(std::uint32_t first, std::uint32_t second) const {
    const auto text = [&](std::uint32_t piece) {
        const std::string line = "line " + std::to_string(placeOf(source_.text, offsetOf(piece)).line);
        const auto name = names_->names().find(input_.pieces[piece].tag);
        return name == names_->names().end() ? line : inQuotes(name->second) + " (" + line + ')';
    };
    return "those of " + text(first) + " and " + text(second);
}

/// Warns of closed outlines that overlap: where nothing is filled, what both enclose is a hole, which is seldom meant.
void DrawingBuilder::warnOfOverlaps() const {
    const OutlineOverlaps found = findOutlineOverlaps(input_, rings_);
    if (found.count > 0) {
        source_.warn("overlapping-outlines",
                     "closed outlines overlap in " + countText(found.count, "place") + ", " +
                         numberText(found.area, 3) + " in area, such as " + pairText(found.first, found.second) +
                         placesText(found.count, found.places) +
                         ": what both enclose is a hole; unite or trim them in the drawing, or join them with Union in "
                         "the editor",
                     offsetOf(found.first));
    }
}

/// Warns of lines that bound the domain on both sides of where they cross.
void DrawingBuilder::warnOfCrossings(const Arrangement &lines) const {
    const OutlineCrossings found = findOutlineCrossings(input_, lines);
    if (found.count > 0) {
        source_.warn("crossing-outlines",
                     "outlines made of lines cross in " + countText(found.count, "place") + ", such as " +
                         pairText(found.first, found.second) + placesText(found.count, found.places) +
                         ": what two outlines enclose is a hole; trim the lines, or draw closed outlines and join them "
                         "with Union in the editor",
                     offsetOf(found.first));
    }
}

} // namespace forefront
