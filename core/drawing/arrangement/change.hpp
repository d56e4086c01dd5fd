#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// Kinds of changes that an arrangement or a repair makes to its input.
enum class ChangeKind : std::uint8_t {
    WeldedNodes,      ///< a node moved onto another node
    RepeatedNodes,    ///< nodes of a domain with equal coordinates were merged
    ShortPieces,      ///< a piece vanished because its ends were welded
    EmptySegments,    ///< a segment of a domain vanished because it has no length
    CrossingSegments, ///< a node was added where pieces cross
    TouchingSegments, ///< a piece was split at a node on it
    TouchingCurves,   ///< two curves touch, or are within the tolerance of each other, and were joined there
    UndividedCurves,  ///< an edge of a curve was not divided enough to keep clear of nearby edges
    BentSegments,     ///< a piece was routed through a nearby node
    RepeatedSegments, ///< of coinciding segments of a domain, one was kept
    SharedBoundaries, ///< a boundary segment between two inner faces of a domain became a constraint
    FoldedOutlines,   ///< an outline runs back along itself; both parts vanish
    OverlapsDecided,  ///< several features cover a face, and one was chosen
    VanishedShapes,   ///< nothing is left of a feature or, if there is only one, of a shape
    InnerOutlines,    ///< an outline with the same feature on both sides vanished
    ClippedSegments,  ///< a part of an outline or line that its clip does not show vanished
    RepeatedOutlines, ///< a part of a line that repeats an outline nearby vanished
    OutsideLines,     ///< a constraint line outside the domain vanished
    OutsidePoints,    ///< a constraint point outside the domain vanished
    OutsideMarkers,   ///< a hole marker vanished because its hole was open to the outside
    HolesBeyond,      ///< a part of a hole beyond the outline that the hole crosses is no part of the domain
    UnusedNodes       ///< a node of a domain vanished because nothing refers to it
};

/// All changes of one kind.
struct ArrangementChange {
    static constexpr std::size_t kPlaces = 3;

    ChangeKind kind = ChangeKind::WeldedNodes;
    std::size_t count = 0;
    double displacement = 0.0; ///< maximum, in domain units; for OverlapsDecided the area instead
    std::vector<Vec2> places;  ///< the first ones, at most kPlaces
    std::uint32_t piece = 0;   ///< the first piece concerned
    /// For OverlapsDecided "A and B", the first two features; for VanishedShapes the names of the first ones.
    std::string names;
    std::optional<DomainPart> part = {}; ///< of the given domain at the first place; absent for drawings
};

/// Collects changes, one entry per kind.
class ChangeList {
  public:
    /// Adds one change. `displacement`: distance moved, or the area for OverlapsDecided. `piece`: the index of the
    /// piece concerned.
    void add(ChangeKind kind, Vec2 at, double displacement, std::uint32_t piece);
    /// Replaces each index k of a piece by numbers[k].
    void renumberPieces(std::span<const std::uint32_t> numbers);
    /// Returns the changes ordered by kind.
    std::vector<ArrangementChange> take();
    /// Returns the entry of a kind, or null.
    ArrangementChange *find(ChangeKind kind);

  private:
    std::vector<ArrangementChange> changes_;
};

/// Returns true if the change makes the domain differ from its file; false for outlines that vanish because the fill
/// rule or the union of shapes makes them meaningless.
bool altersInput(ChangeKind kind);

/// Returns one note per kind, with count and maximum displacement, at its first place.
Diagnostics notesOf(const std::vector<ArrangementChange> &changes);
/// Returns " at (1, 2)" or ", first at (1, 2), (3, 4)", to be appended to the message of a note.
std::string placesOf(const ArrangementChange &change);
/// Returns the notes with all known places in their messages, for output as text.
Diagnostics notesWithPlaces(const std::vector<ArrangementChange> &changes);

} // namespace forefront
