#include "core/arrangement/change.hpp"

#include <cstdio>

namespace forefront {

namespace {

/// Words of a message about one kind of change; the count goes between them.
struct Words {
    ChangeKind kind;
    const char *code;
    const char *one;
    const char *several;
    bool alters;
};

constexpr Words kWords[] = {
    {ChangeKind::WeldedNodes, "welded-nodes", "moved 1 node onto another one", "moved %zu nodes onto others", true},
    {ChangeKind::ShortPieces, "short-segments", "dropped 1 segment shorter than the tolerance",
     "dropped %zu segments shorter than the tolerance", true},
    {ChangeKind::CrossingSegments, "crossing-segments", "added a node where segments cross",
     "added nodes in %zu places where segments cross", true},
    {ChangeKind::TouchingSegments, "touching-segments", "split 1 segment at a node on it",
     "split segments at %zu nodes on them", true},
    {ChangeKind::BentSegments, "bent-segments", "led 1 segment through a node near it",
     "led segments through nodes near them in %zu places", true},
    {ChangeKind::FoldedOutlines, "folded-outlines", "dropped 1 segment where an outline runs back along itself",
     "dropped %zu segments where outlines run back along themselves", true},
    {ChangeKind::OverlapsDecided, "overlapping-features", "decided 1 overlap of features",
     "decided %zu overlaps of features", true},
    {ChangeKind::InnerOutlines, "inner-outlines", "dropped 1 outline segment with the same inside on both sides",
     "dropped %zu outline segments with the same inside on both sides", false},
    {ChangeKind::OutsideLines, "segment-outside", "dropped 1 segment of a line outside the domain",
     "dropped %zu segments of lines outside the domain", true},
    {ChangeKind::OutsidePoints, "point-outside", "dropped 1 point outside the domain",
     "dropped %zu points outside the domain", true},
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
            char text[120];
            std::snprintf(text, sizeof text, words.several, change.count);
            note.message = text;
        }
        if (change.kind == ChangeKind::OverlapsDecided) {
            note.message += ", " + shown(change.displacement) + " in area";
            if (!change.between.empty()) {
                note.message += (change.count == 1 ? ", between " : ", the first between ") + change.between;
            }
        } else if (change.displacement > 0.0) {
            note.message += ", at most " + shown(change.displacement) + " away";
        }
        if (!change.places.empty()) {
            note.at = change.places.front();
        }
        notes.push_back(std::move(note));
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
