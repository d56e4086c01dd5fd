#include "core/drawing_files/common/drawing_builder.hpp"

#include "core/drawing/arrangement/assembly/feature_gaps.hpp"
#include "core/drawing/arrangement/assembly/short_segments.hpp"
#include "core/drawing/arrangement/repeated_lines/near_lines.hpp"
#include "core/drawing/arrangement/snapping/snap_lines.hpp"
#include "core/drawing_files/common/line_outline.hpp"
#include "core/drawing_files/common/open_outline.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace forefront {

namespace {

constexpr double kMaxPreferred = 10.0;     ///< default tolerances
constexpr double kSpare = 1.05;            ///< by which an advised tolerance exceeds the gap
constexpr double kDefaultTolerance = 1e-6; ///< fraction of the diagonal: the error of relative path data and digitising

Box2 boundsOf(const ArrangementInput &input) {
    Box2 box;
    for (const ArrangementPiece &piece : input.pieces) {
        if (!input.ofClip(piece)) { // a clip may be much larger than what it shows
            box.add(piece.a);
            box.add(piece.b);
        }
    }
    return box;
}

Box2 boundsOfLines(const ArrangementInput &input) {
    Box2 box;
    for (const ArrangementPiece &piece : input.pieces) {
        if (piece.role == PieceRole::Constraint && piece.limit == kNoClip) {
            box.add(piece.a);
            box.add(piece.b);
        }
    }
    return box;
}

Box2 boundaryBox(const Domain &domain) {
    Box2 box;
    for (const DomainSegment &segment : domain.segments) {
        if (segment.role == SegmentRole::Boundary) {
            box.add(domain.nodes[segment.a]);
            box.add(domain.nodes[segment.b]);
        }
    }
    return box;
}

double areaOf(const Box2 &box) {
    return box.size().x * box.size().y;
}

} // namespace

DrawingBuilder::DrawingBuilder(const SourceText &source) : source_(source) {
    input_.overlap = source.options.overlap;
    if (source.origin != nullptr) {
        source.origin->showsColumns = true;
    }
}

std::size_t DrawingBuilder::offsetOf(std::uint32_t piece) const {
    const std::size_t place = places_[2 * piece];
    return place == PartOrigin::kNowhere ? 0 : place;
}

std::size_t DrawingBuilder::offset(std::size_t node) const {
    return offsets_.empty() ? PartOrigin::kNowhere : offsets_[std::min(node, offsets_.size() - 1)];
}

std::uint32_t DrawingBuilder::addFeature(std::int32_t regionTag, std::string name) {
    return input_.addFeature(regionTag, std::move(name));
}

std::uint32_t DrawingBuilder::addContour(std::uint32_t shape, FillRule rule, bool hole) {
    return input_.addContour(shape, rule, hole);
}

void DrawingBuilder::addMadeArea(std::uint32_t shape, const OutlinedArea &area, std::span<const MadeFrom> parts) {
    const std::size_t first = input_.pieces.size();
    input_.contours[addArea(input_, shape, area)].synthetic = true;
    for (std::size_t k = first; k < input_.pieces.size(); ++k) {
        ArrangementPiece &piece = input_.pieces[k];
        const MadeFrom &part = parts[static_cast<std::size_t>(piece.tag - 1)]; // of its label
        piece.tag = part.tag;
        piece.shows = part.shape;
        places_.insert(places_.end(), {part.offset, part.offset});
    }
}

void DrawingBuilder::addCurves(std::span<const Curve> curves, std::span<CurveStretch> stretches) {
    const auto first = static_cast<std::uint32_t>(input_.curves.size());
    input_.curves.insert(input_.curves.end(), curves.begin(), curves.end());
    for (CurveStretch &stretch : stretches) {
        stretch.curve += stretch.follows() ? first : 0;
    }
}

void DrawingBuilder::addRing(std::uint32_t contour, std::span<const Vec2> nodes, std::int32_t tag,
                             std::span<const CurveStretch> stretches) {
    rings_.push_back(static_cast<std::uint32_t>(input_.pieces.size()));
    input_.addRing(contour, nodes, tag, stretches);
    if (input_.pieces.size() == rings_.back()) { // all nodes are equal
        rings_.pop_back();
    }
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::size_t next = (k + 1) % nodes.size();
        if (nodes[k] != nodes[next]) {
            places_.insert(places_.end(), {offset(k), offset(next)});
        }
    }
}

void DrawingBuilder::addChain(std::span<const Vec2> nodes, std::int32_t tag, std::span<const CurveStretch> stretches,
                              std::uint32_t limit, double width) {
    constexpr double kHalf = 0.505; // strokes inside an outline are drawn half their width beside it, rounded
    input_.addChain(nodes, tag, stretches, limit, kHalf * width);
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        if (nodes[k - 1] != nodes[k]) {
            places_.insert(places_.end(), {offset(k - 1), offset(k)});
        }
    }
}

void DrawingBuilder::addPoint(Vec2 at, std::int32_t tag) {
    input_.addPoint(at, tag);
    places_.insert(places_.end(), {offset(0), offset(0)});
}

bool DrawingBuilder::hasOutlines() const {
    return std::any_of(input_.contours.begin(), input_.contours.end(), [&](const ArrangementContour &contour) {
        return input_.shapes[contour.shape].partOf == kNoClip;
    });
}

Result<Domain> DrawingBuilder::finish() {
    const Box2 lines = hasOutlines() && !linesBound_ ? Box2{} : boundsOfLines(input_);
    Result<Arrangement> arranged = arrangeParts();
    if (!arranged) {
        Diagnostics faults = arranged.faults();
        for (Diagnostic &fault : faults) {
            if (fault.file.empty()) {
                const TextPlace start = placeOf(source_.text, 0);
                fault.file = source_.name;
                fault.line = start.line;
                fault.column = start.column;
            }
        }
        return faults;
    }
    if (Diagnostics faults = report(*arranged); !faults.empty()) {
        return faults;
    }
    if (arranged->domain.segments.empty()) {
        return Diagnostics{faultAt(source_, 0, "empty-domain", "the outlines enclose no area",
                                   "draw a closed outline, or lower the weld tolerance")};
    }
    if (!open_) { // which says more
        noteSmallDomain(arranged->domain, lines);
    }
    noteFeatureGaps(*arranged);
    noteShortSegments(*arranged);
    noteLines(*arranged);
    recordOrigin(*arranged);
    return std::move(arranged->domain);
}

Result<Arrangement> DrawingBuilder::arrangeParts() {
    const std::optional<double> &chosen = source_.options.weldTolerance;
    const double standard = kDefaultTolerance * boundsOf(input_).diagonal();
    input_.tolerance = chosen.value_or(std::max(standard, std::min(preferred_, kMaxPreferred * standard)));
    if (linesBound_ && source_.notes != nullptr) {
        warnOfOverlaps();
    }
    const bool outlines = hasOutlines();
    const bool lines = std::any_of(input_.pieces.begin(), input_.pieces.end(),
                                   [](const ArrangementPiece &piece) { return piece.role == PieceRole::Constraint; });
    if (!outlines || (linesBound_ && lines)) {
        input_.keepOutside = true;
        Result<Arrangement> arranged = arrange(input_);
        const LineLoops loops = arranged ? takeLinesAsOutline(arranged->domain) : LineLoops{};
        if (arranged && (outlines || loops.segments > 0)) {
            noteLineGaps(*arranged, loops.segments);
            noteLoopsLeft(*arranged, loops);
        }
        if (loops.segments > 0) {
            return arrangeBounded(*arranged, loops.segments);
        }
        if (!outlines) {
            return arranged; // validation reports why nothing is enclosed
        }
        input_.keepOutside = false;
    }
    return chosen ? arrange(input_) : arrangeByDefault();
}

/// Arranges with the default tolerance, or with a smaller one where that would change the area of outlines visibly: all
/// of a drawing may be thinner than a millionth of its length.
Result<Arrangement> DrawingBuilder::arrangeByDefault() {
    constexpr double kMaxAreaChange = 1e-3;
    constexpr double kStep = 1.0 / 32.0;
    const double standard = input_.tolerance, minimum = resolutionOf(boundsOf(input_));
    for (;; input_.tolerance *= kStep) {
        Result<Arrangement> arranged = arrange(input_);
        if (arranged && arranged->areaChange > kMaxAreaChange && input_.tolerance > minimum) {
            continue;
        }
        if (input_.tolerance < standard) {
            source_.note("finer-weld",
                         "used a weld tolerance of " + numberText(input_.tolerance, 3) + " instead of " +
                             numberText(standard, 3) + ", which would change the area by over 0.1 %",
                         places_.front());
        }
        return arranged;
    }
}

/// Arranges lines whose loops bound the domain: they are joined, and then everything is arranged again with an outline.
Result<Arrangement> DrawingBuilder::arrangeBounded(const Arrangement &lines, std::size_t count) {
    source_.note("lines-as-outline",
                 (hasOutlines() ? "nothing is filled: lines that form closed loops are outlines, too ("
                                : "no closed outline found: using the lines that form closed loops as the outline (") +
                     std::to_string(count) + " segments)",
                 places_.front());
    warnOfCrossings(lines);
    ArrangementInput outlines = withOutline(lines);
    std::vector<std::size_t> places;
    for (const PieceStretch &stretch : lines.stretches) {
        places.insert(places.end(), {places_[2 * stretch.piece], places_[2 * stretch.piece + 1]});
    }
    for (const std::uint32_t piece : lines.pointPiece) {
        places.insert(places.end(), 2, places_[2 * piece]);
    }
    if (Diagnostics faults = report(lines); !faults.empty()) {
        return faults;
    }
    input_ = std::move(outlines);
    places_ = std::move(places);
    return arrange(input_);
}

/// Returns joined lines as input again, with those on the boundary of the domain as an outline.
ArrangementInput DrawingBuilder::withOutline(const Arrangement &lines) const {
    ArrangementInput outlines;
    const Domain &domain = lines.domain;
    outlines.curves = domain.curves;
    const std::uint32_t contour = outlines.addContour(outlines.addShape(outlines.addFeature(1)), FillRule::EvenOdd);
    for (const DomainSegment &segment : domain.segments) {
        outlines.pieces.push_back({domain.nodes[segment.a], domain.nodes[segment.b], contour, segment.tag,
                                   segment.role == SegmentRole::Boundary ? PieceRole::Outline : PieceRole::Constraint,
                                   segment.stretch});
    }
    for (const ConstraintPoint &point : domain.points) {
        outlines.addPoint(domain.nodes[point.node], point.tag);
    }
    return outlines;
}

/// Reports the changes as notes, or as faults if changes are not allowed.
Diagnostics DrawingBuilder::report(const Arrangement &arrangement) const {
    Diagnostics faults;
    const Diagnostics notes = notesOf(arrangement.changes);
    const double rounding = resolutionOf(boundsOf(input_)); // ends of arcs meet those of lines only up to that
    for (std::size_t k = 0; k < notes.size(); ++k) {
        if (arrangement.changes[k].kind == ChangeKind::WeldedNodes && arrangement.changes[k].displacement <= rounding) {
            continue;
        }
        const std::size_t at = offsetOf(arrangement.changes[k].piece);
        if (source_.options.strict && altersInput(arrangement.changes[k].kind)) {
            Diagnostic fault = faultAt(source_, at, notes[k].code, "the input would be changed: " + notes[k].message,
                                       "correct the file, or leave out --strict");
            fault.at = notes[k].at;
            faults.push_back(std::move(fault));
        } else {
            source_.note(notes[k].code, notes[k].message + placesOf(arrangement.changes[k]), at);
        }
    }
    return faults;
}

/// Reports loops of lines that may be meant as outlines.
void DrawingBuilder::noteLoopsLeft(const Arrangement &lines, const LineLoops &loops) const {
    if (loops.left > 0) {
        const DomainSegment &segment = lines.domain.segments[loops.firstLeft];
        source_.note("line-loops",
                     std::to_string(loops.left) +
                         (loops.left == 1
                              ? " loop of lines is no outline, because others cross or touch it, at "
                              : " loops of lines are no outlines, because others cross or touch them, first "
                                "at ") +
                         placeText(midpoint(lines.domain.nodes[segment.a], lines.domain.nodes[segment.b])) +
                         "; draw outlines as closed paths",
                     offsetOf(lines.stretches[loops.firstLeft].piece));
    }
}

/// Warns of outlines that do not close, and reports other lines whose ends nearly meet.
void DrawingBuilder::noteLineGaps(const Arrangement &lines, std::size_t boundary) {
    if (source_.notes == nullptr) {
        return;
    }
    const GapFindings found = examineGaps(input_, lines, boundary);
    const std::optional<OpenOutline> open = found.open ? found.open : findOpenOutline(lines.domain);
    if (open) {
        source_.warn("open-outline", openOutlineText(*open, found.open ? found.weld : 0.0),
                     offsetOf(lines.stretches[open->segment].piece));
        open_ = open->outer;
    } else if (const LineGaps &gaps = found.gaps; gaps.count > 0) {
        source_.note("line-gaps",
                     countText(gaps.count, "end") + " of lines nearly " + (gaps.count == 1 ? "meets" : "meet") +
                         " another end, at most " + numberText(gaps.widest, 3) + " away, first at " +
                         placeText(gaps.ends.front().at) + "; " +
                         (found.weld > 0.0 ? "--weld " + numberText(found.weld, 3) + " joins them"
                                           : std::string("join them in the drawing")),
                     offsetOf(lines.stretches[gaps.ends.front().segment].piece));
    }
}

/// Reports a domain that contains only a part of the drawn lines.
void DrawingBuilder::noteSmallDomain(const Domain &domain, const Box2 &lines) const {
    constexpr double kSmall = 0.25; // fraction of the area that everything extends over
    const Box2 box = boundaryBox(domain);
    Box2 whole = box;
    whole.add(lines);
    if (!lines.empty() && !box.empty() && areaOf(box) < kSmall * areaOf(whole)) {
        source_.note("small-domain",
                     "the domain is only a part of the drawing, from " + placeText(box.min) + " to " +
                         placeText(box.max) + ": the lines around it form no outline",
                     0);
    }
}

/// Reports neighbours in a map that nearly touch: the mesh would not connect them.
void DrawingBuilder::noteFeatureGaps(const Arrangement &arrangement) const {
    constexpr double kNear = 2e-4; // fraction of the diagonal
    if (input_.features.size() < 2 || !hasOutlines() || source_.notes == nullptr) {
        return;
    }
    std::vector<std::uint32_t> features;
    for (const PieceStretch &stretch : arrangement.stretches) {
        const ArrangementPiece &piece = input_.pieces[stretch.piece];
        features.push_back(
            piece.role == PieceRole::Outline ? input_.shapes[input_.contours[piece.contour].shape].feature : kNoIndex);
    }
    const Domain &domain = arrangement.domain;
    const FeatureGaps gaps = findFeatureGaps(domain, features, kNear * domain.bounds().diagonal());
    if (gaps.count > 0) {
        source_.note("feature-gaps",
                     "features nearly touch in " + std::to_string(gaps.count) +
                         (gaps.count == 1 ? " place, " : " places, at most ") + numberText(gaps.widest, 3) +
                         " apart, first at " + placeText(gaps.first) + "; --weld " +
                         numberText(kSpare * gaps.widest, 3) + " joins them",
                     offsetOf(arrangement.stretches[gaps.segment].piece));
    }
}

/// Reports pairs of nodes so close together that the mesh is refined around them, as where a line crosses both sides
/// of a sliver.
void DrawingBuilder::noteShortSegments(const Arrangement &arrangement) const {
    constexpr double kNear = 2e-4; // fraction of the diagonal
    if (source_.notes == nullptr) {
        return;
    }
    const Domain &domain = arrangement.domain;
    const ShortSegments found = findShortSegments(domain, kNear * domain.bounds().diagonal());
    if (found.count > 0) {
        const bool one = found.count == 1;
        source_.note(
            "close-nodes",
            (one ? std::string("two nodes are only ") : std::to_string(found.count) + " pairs of nodes are at most ") +
                numberText(found.longest, 3) + " apart, which refines the mesh " + (one ? "at " : "first at ") +
                placeText(found.first) + "; --weld " + numberText(kSpare * found.longest, 3) + " merges them",
            offsetOf(arrangement.stretches[found.segment].piece));
    }
}

/// Reports lines inside the domain that decide most of the mesh, or that spoil it.
void DrawingBuilder::noteLines(const Arrangement &arrangement) const {
    const auto lines = static_cast<std::size_t>(std::count(arrangement.isLine.begin(), arrangement.isLine.end(), 1));
    if (hasOutlines() && source_.notes != nullptr && lines > 0) {
        noteManyLines(arrangement, lines);
        noteNearLines(arrangement);
    }
}

/// Reports lines with far more segments than everything else: the mesh may have a hundred times the elements that the
/// outlines need.
void DrawingBuilder::noteManyLines(const Arrangement &arrangement, std::size_t lines) const {
    constexpr std::size_t kMany = 500; // segments
    constexpr double kMostly = 0.6;
    const std::vector<std::uint8_t> &isLine = arrangement.isLine;
    if (lines >= kMany && static_cast<double>(lines) >= kMostly * static_cast<double>(isLine.size())) {
        const auto first = std::find(isLine.begin(), isLine.end(), 1) - isLine.begin();
        source_.note("many-lines",
                     std::to_string(lines) + " of the " + std::to_string(isLine.size()) +
                         " segments belong to lines inside the domain, which decide how fine most of the mesh is; "
                         "--drop-lines leaves lines out",
                     offsetOf(arrangement.stretches[static_cast<std::size_t>(first)].piece));
    }
}

/// Reports lines that nearly follow the boundary but stay, such as those with a name.
void DrawingBuilder::noteNearLines(const Arrangement &arrangement) const {
    const NearLines near = findNearLines(arrangement.domain, arrangement.isLine);
    if (near.count > 0) {
        source_.note("near-lines",
                     std::to_string(near.count) +
                         (near.count == 1 ? " segment of a line nearly follows the boundary"
                                          : " segments of lines nearly follow the boundary") +
                         ", " + (near.count == 1 ? "" : "at least ") + numberText(near.nearest, 3) + " away, " +
                         (near.count == 1 ? "at " : "first at ") + placeText(near.first) +
                         "; --drop-lines leaves lines out",
                     offsetOf(arrangement.stretches[near.segment].piece));
    }
}

void DrawingBuilder::recordOrigin(const Arrangement &arrangement) const {
    if (source_.origin == nullptr) {
        return;
    }
    const auto record = [&](DomainPartKind kind, std::size_t place) {
        source_.origin->of(kind).push_back({place, {}});
    };
    for (std::size_t n = 0; n < arrangement.domain.nodes.size(); ++n) {
        const std::uint32_t piece = arrangement.nodePiece[n];
        const bool isEnd = arrangement.domain.nodes[n] == input_.pieces[piece].b;
        record(DomainPartKind::Node, places_[2 * piece + (isEnd ? 1 : 0)]);
    }
    for (const PieceStretch &stretch : arrangement.stretches) {
        record(DomainPartKind::Segment, places_[2 * stretch.piece]);
    }
    for (const std::uint32_t piece : arrangement.pointPiece) {
        record(DomainPartKind::ConstraintPoint, places_[2 * piece]);
    }
    for (std::size_t k = 0; k < arrangement.domain.regionMarkers.size(); ++k) {
        record(DomainPartKind::RegionMarker, PartOrigin::kNowhere);
    }
}

} // namespace forefront
