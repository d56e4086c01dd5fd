#include "core/drawing/arrangement/change.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace forefront {

namespace {

/// The words of a message about one kind of change, before and after the count.
struct Words {
    ChangeKind kind;
    const char *code;
    const char *one;
    const char *several;
    bool alters;
};

constexpr Words kWords[] = {
    {ChangeKind::WeldedNodes, "welded-nodes", "moved 1 node onto another", "moved %zu nodes onto others", true},
    {ChangeKind::RepeatedNodes, "duplicate-node", "merged 1 node with another at the same position",
     "merged %zu nodes with others at the same position", true},
    {ChangeKind::ShortPieces, "short-segments", "dropped 1 segment shorter than the tolerance",
     "dropped %zu segments shorter than the tolerance", true},
    {ChangeKind::EmptySegments, "zero-length", "dropped 1 segment of zero length",
     "dropped %zu segments of zero length", true},
    {ChangeKind::CrossingSegments, "crossing-segments", "added a node where segments cross",
     "added nodes in %zu places where segments cross", true},
    {ChangeKind::TouchingSegments, "touching-segments", "split 1 segment at a node on it",
     "split segments at %zu nodes on them", true},
    {ChangeKind::TouchingCurves, "touching-curves", "joined 2 curves where they touch",
     "joined curves in %zu places where they touch", true},
    {ChangeKind::UndividedCurves, "undivided-curves",
     "left 1 edge of a curve undivided, where curves are too close; it may be joined with others",
     "left %zu edges of curves undivided, where curves are too close; they may be joined with others", true},
    {ChangeKind::BentSegments, "bent-segments", "bent 1 segment through a nearby node",
     "bent segments through nearby nodes in %zu places", true},
    {ChangeKind::RepeatedSegments, "duplicate-segment", "dropped 1 duplicate segment", "dropped %zu duplicate segments",
     true},
    {ChangeKind::SharedBoundaries, "overlapping-segments",
     "turned 1 boundary segment shared by neighbours into an inner line",
     "turned %zu boundary segments shared by neighbours into inner lines", true},
    {ChangeKind::FoldedOutlines, "folded-outlines", "dropped 1 segment where an outline runs back along itself",
     "dropped %zu segments where outlines run back along themselves", true},
    {ChangeKind::OverlapsDecided, "overlapping-features", "resolved 1 overlap of features",
     "resolved %zu overlaps of features", true},
    {ChangeKind::VanishedShapes, "vanished-shapes",
     "dropped 1 shape with nothing left: it is merged with others or lies below them, is clipped away, "
     "or is thinner than the tolerance",
     "dropped %zu shapes with nothing left: they are merged with others or lie below them, are clipped "
     "away, or are thinner than the tolerance",
     false},
    {ChangeKind::InnerOutlines, "inner-outlines", "dropped 1 outline segment with the same feature on both sides",
     "dropped %zu outline segments with the same feature on both sides", false},
    {ChangeKind::ClippedSegments, "clipped-segments", "dropped 1 segment that a clip path or mask hides",
     "dropped %zu segments that clip paths, masks or the page hide", false},
    {ChangeKind::RepeatedOutlines, "repeated-outlines",
     "dropped 1 segment of a line, at least in part, where its stroke runs along an outline",
     "dropped %zu segments of lines, at least in part, where their strokes run along outlines", true},
    {ChangeKind::OutsideLines, "segment-outside", "dropped 1 segment of a line outside the domain",
     "dropped %zu segments of lines outside the domain", true},
    {ChangeKind::OutsidePoints, "point-outside", "dropped 1 point outside the domain",
     "dropped %zu points outside the domain", true},
    {ChangeKind::OutsideMarkers, "hole-outside", "dropped 1 hole marker in a hole that is open to the outside",
     "dropped %zu hole markers in holes that are open to the outside", true},
    {ChangeKind::HolesBeyond, "hole-crosses", "left out the part of a hole beyond the outline that it crosses",
     "left out %zu parts of holes beyond the outlines that they cross", true},
    {ChangeKind::UnusedNodes, "unreferenced-node", "dropped 1 node that belongs to no segment",
     "dropped %zu nodes that belong to no segment", true},
};

const Words &wordsOf(ChangeKind kind) {
    return kWords[static_cast<std::size_t>(kind)];
}

std::string shown(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string shown(Vec2 p) {
    char text[80];
    std::snprintf(text, sizeof text, "(%.6g, %.6g)", p.x, p.y);
    return text;
}

} // namespace

void ChangeList::add(ChangeKind kind, Vec2 at, double displacement, std::uint32_t piece) {
    ArrangementChange *change = find(kind);
    if (change == nullptr) {
        changes_.push_back({kind, 0, 0.0, {}, piece, {}, {}});
        change = &changes_.back();
    }
    ++change->count;
    change->displacement = kind == ChangeKind::OverlapsDecided ? change->displacement + displacement
                                                               : std::max(change->displacement, displacement);
    if (change->places.size() < ArrangementChange::kPlaces) {
        change->places.push_back(at);
    }
}

void ChangeList::renumberPieces(std::span<const std::uint32_t> numbers) {
    for (ArrangementChange &change : changes_) {
        change.piece = numbers[change.piece];
    }
}

std::vector<ArrangementChange> ChangeList::take() {
    std::sort(changes_.begin(), changes_.end(),
              [](const ArrangementChange &s, const ArrangementChange &t) { return s.kind < t.kind; });
    return std::exchange(changes_, {});
}

ArrangementChange *ChangeList::find(ChangeKind kind) {
    const auto known = std::find_if(changes_.begin(), changes_.end(),
                                    [&](const ArrangementChange &change) { return change.kind == kind; });
    return known == changes_.end() ? nullptr : &*known;
}

bool altersInput(ChangeKind kind) {
    return wordsOf(kind).alters;
}

Diagnostics notesOf(const std::vector<ArrangementChange> &changes) {
    Diagnostics notes;
    for (const ArrangementChange &change : changes) {
        const Words &words = wordsOf(change.kind);
        Diagnostic note;
        note.severity = Severity::Note;
        note.code = words.code;
        note.message = words.one;
        if (change.count != 1) {
            char text[160];
            std::snprintf(text, sizeof text, words.several, change.count);
            note.message = text;
        }
        if (change.kind == ChangeKind::OverlapsDecided) {
            note.message += ", " + shown(change.displacement) + " in area";
            if (!change.names.empty()) {
                note.message += (change.count == 1 ? ", between " : ", the first between ") + change.names;
            }
        } else if (change.displacement > 0.0) {
            note.message += ", at most " + shown(change.displacement) + " away";
        }
        if (change.kind == ChangeKind::VanishedShapes && !change.names.empty()) {
            note.message += (change.count == 1 ? "; " : "; among them ") + change.names;
        }
        if (!change.places.empty()) {
            note.at = change.places.front();
        }
        if (change.part) {
            note.parts.push_back(*change.part);
        }
        notes.push_back(std::move(note));
    }
    return notes;
}

Diagnostics notesWithPlaces(const std::vector<ArrangementChange> &changes) {
    Diagnostics notes = notesOf(changes);
    for (std::size_t k = 0; k < notes.size(); ++k) {
        notes[k].message += placesOf(changes[k]);
        notes[k].at.reset();
    }
    return notes;
}

std::string placesOf(const ArrangementChange &change) {
    std::string text;
    for (const Vec2 place : change.places) {
        text += (text.empty() ? (change.count == 1 ? " at " : ", first at ") : ", ") + shown(place);
    }
    return text;
}

} // namespace forefront
