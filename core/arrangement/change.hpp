#pragma once

#include "core/base/diagnostic.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// What an arrangement did to its input.
enum class ChangeKind : std::uint8_t {
    WeldedNodes,      ///< a node moved onto another one
    ShortPieces,      ///< a piece vanished because its ends were welded
    CrossingSegments, ///< a node was added where pieces cross
    TouchingSegments, ///< a piece was split at a node on it
    BentSegments,     ///< a piece was routed through a node near it
    FoldedOutlines,   ///< an outline runs back along itself; both parts vanish
    OverlapsDecided,  ///< several features cover a face, and one was chosen
    InnerOutlines,    ///< an outline with the same feature on both sides vanished
    OutsideLines,     ///< a constraint line outside the domain vanished
    OutsidePoints     ///< a constraint point outside the domain vanished
};
inline constexpr std::size_t kChangeKinds = 10;

/// All changes of one kind.
struct ArrangementChange {
    static constexpr std::size_t kPlaces = 3;

    ChangeKind kind = ChangeKind::WeldedNodes;
    std::size_t count = 0;
    double displacement = 0.0; ///< maximum, in domain units; for OverlapsDecided the area instead
    std::vector<Vec2> places;  ///< the first ones, at most kPlaces
    std::uint32_t piece = 0;   ///< the first piece concerned
    std::string between;       ///< for OverlapsDecided: names of the first two features
};

/// Returns true if the change makes the domain differ from what its file says; false for outlines that vanish because
/// the fill rule or the union of shapes makes them meaningless.
bool altersInput(ChangeKind kind);

/// Returns one note per kind, with count and greatest displacement, at its first place.
Diagnostics notesOf(const std::vector<ArrangementChange> &changes);
/// Returns " at (1, 2)" or ", first at (1, 2), (3, 4)", to be appended to the message of a note.
std::string placesOf(const ArrangementChange &change);

} // namespace forefront
