#include "core/drawing/arrangement/assembly/assembler.hpp"

#include "core/drawing/arrangement/snapping/stretch_part.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/rows.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace forefront {

Assembler::Assembler(const ArrangementInput &input, const JoinedLines &joined, Faces faces)
    : input_(input), joined_(joined), snapped_(joined.snapped), faces_(std::move(faces)) {}

Arrangement Assembler::run() {
    collectRuns();
    std::vector<ClippedLine> lines = clippedLines();
    cover_ = coverFaces(input_, snapped_.nodes, snapped_.edges, runs_, faces_, lines);
    for (const ClippedLine &line : lines) {
        (line.shown ? isLine_ : hidden_)[line.edge] = 1;
    }
    decideFates();
    findRepeats();
    chooseTags();
    buildDomain();
    if (input_.markRegions) {
        markRegions();
    }
    result_.areaChange = areaChange();
    report();
    return std::move(result_);
}

/// Sorts the outlines by the edges they run along.
void Assembler::collectRuns() {
    const std::size_t edgeCount = snapped_.edges.size();
    isLine_.assign(edgeCount, 0);
    const auto forEach = [&](const auto &visit) {
        for (std::uint32_t i = 0; i < lineCount(); ++i) {
            for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1]; ++k) {
                visit(pieceOf(i), snapped_.ways[k]);
            }
        }
    };
    forEach([&](const ArrangementPiece &piece, std::uint32_t way) {
        if (piece.role != PieceRole::Outline && piece.limit == kNoClip) {
            isLine_[way / 2] = 1;
        }
    });
    Rows<ContourRun> runs(edgeCount, [&](const auto &add) {
        forEach([&](const ArrangementPiece &piece, std::uint32_t way) {
            if (piece.role == PieceRole::Outline) {
                add(way / 2, ContourRun{piece.contour, way % 2 == 0 ? 1 : -1});
            }
        });
    });
    runs_.starts.push_back(0);
    for (std::size_t e = 0; e < edgeCount; ++e) {
        const std::span<ContourRun> row = runs[e];
        const auto first = row.begin(), last = row.end();
        std::sort(first, last, [](const ContourRun &s, const ContourRun &t) { return s.contour < t.contour; });
        for (auto run = first; run != last; ++run) {
            if (run != first && runs_.runs.back().contour == run->contour) {
                runs_.runs.back().times += run->times;
            } else {
                runs_.runs.push_back(*run);
            }
        }
        runs_.starts.push_back(static_cast<std::uint32_t>(runs_.runs.size()));
    }
}

/// Returns the lines that clips limit, by the edges they run along.
std::vector<ClippedLine> Assembler::clippedLines() {
    std::vector<ClippedLine> lines;
    if (input_.clips.empty()) {
        return lines;
    }
    hidden_.assign(snapped_.edges.size(), 0);
    for (std::uint32_t i = 0; i < lineCount(); ++i) {
        const ArrangementPiece &piece = pieceOf(i);
        for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1] && piece.limit != kNoClip; ++k) {
            lines.push_back({snapped_.ways[k] / 2, piece.limit});
        }
    }
    std::sort(lines.begin(), lines.end(), [](const ClippedLine &s, const ClippedLine &t) { return s.edge < t.edge; });
    return lines;
}

Assembler::Fate Assembler::fateOf(std::uint32_t edge) const {
    const std::uint32_t left = faces_.left[edge], right = faces_.right[edge];
    if (inside(left) != inside(right)) {
        return Fate::Boundary;
    }
    const bool isLine = isLine_[edge] != 0;
    if (!inside(left)) {
        return !isLine ? Fate::Inner : input_.keepOutside ? Fate::Constraint : Fate::Outside;
    }
    return isLine || separates(edge) ? Fate::Constraint : Fate::Inner;
}

/// Returns true if an edge bounds a shape that covers one of its sides.
bool Assembler::separates(std::uint32_t edge) const {
    const std::uint32_t left = faces_.left[edge], right = faces_.right[edge];
    if (inside(left) != inside(right)) {
        return true;
    }
    // All shapes of the left face end here: those of the right one only touch them.
    const bool touch = left != right && cover_.ends[edge] == cover_.shapes[left];
    return inside(left) && (touch || cover_.owner[left] != cover_.owner[right]);
}

void Assembler::decideFates() {
    fate_.resize(snapped_.edges.size());
    for (std::uint32_t e = 0; e < fate_.size(); ++e) {
        fate_[e] = fateOf(e);
        const auto first = runs_.runs.begin() + runs_.starts[e], last = runs_.runs.begin() + runs_.starts[e + 1];
        const bool folded =
            first != last && std::all_of(first, last, [&](const ContourRun &run) {
                return input_.contours[run.contour].rule == FillRule::EvenOdd ? run.times % 2 == 0 : run.times == 0;
            });
        if (fate_[e] == Fate::Inner && folded) {
            fate_[e] = input_.keepFolds && inside(faces_.left[e]) ? Fate::Shared : Fate::Folded;
        }
        if (!input_.clips.empty() && !kept(e)) {
            fate_[e] = clippedFate(e, fate_[e]);
        }
    }
}

/// Finds the lines that repeat an outline: the gap between them would be full of tiny or very long elements.
void Assembler::findRepeats() {
    const auto isLoose = [](const ArrangementPiece &piece) { return piece.reach > 0.0; };
    if (std::none_of(input_.pieces.begin(), input_.pieces.end(), isLoose)) {
        return;
    }
    beside_ = edgesBeside();
    repeats_ = findRepeatedOutlines(snapped_.nodes, snapped_.edges, beside_, input_.curves);
    for (const RepeatingEdge &found : repeats_.edges) {
        fate_[found.edge] = Fate::Repeated;
        repeated_.emplace(found.edge, found.distance);
    }
}

std::optional<ReducedDrawing> Assembler::reduced() const {
    if (repeats_.edges.empty()) {
        return std::nullopt;
    }
    RepeatedOutlines gone = repeats_;
    for (std::uint32_t e = 0; e < fate_.size(); ++e) {
        if (fate_[e] == Fate::Outside) { // or it would still cross the outlines
            gone.edges.push_back({e, 0.0});
        }
    }
    return withoutRepeats(input_, joined_, gone, beside_);
}

/// Describes the edges for the search for lines that repeat outlines.
std::vector<BesideEdge> Assembler::edgesBeside() const {
    std::vector<BesideEdge> about(fate_.size());
    for (std::uint32_t e = 0; e < about.size(); ++e) {
        about[e].role = !kept(e) ? BesideRole::Dropped : separates(e) ? BesideRole::Outline : BesideRole::LooseLine;
        about[e].reach = std::numeric_limits<double>::infinity();
        about[e].divides = faces_.left[e] != faces_.right[e];
    }
    for (std::uint32_t i = 0; i < lineCount(); ++i) {
        for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1]; ++k) {
            BesideEdge &edge = about[snapped_.ways[k] / 2];
            if (pieceOf(i).role == PieceRole::Constraint) {
                edge.reach = std::min(edge.reach, pieceOf(i).reach);
            }
            if (edge.role != BesideRole::Dropped && !edge.stretch.follows() && joined_.stretches[i].follows()) {
                const PlaneEdge &ends = snapped_.edges[snapped_.ways[k] / 2];
                edge.stretch = stretchOf(i, ends.a, ends.b).stretch;
            }
        }
    }
    for (BesideEdge &edge : about) {
        if (edge.role == BesideRole::LooseLine && !(edge.reach > 0.0)) {
            edge.role = BesideRole::Line;
        }
    }
    return about;
}

/// Returns the reason why an edge is dropped if that has to do with clips, else the given one.
Assembler::Fate Assembler::clippedFate(std::uint32_t edge, Fate fate) const {
    bool ofShape = false, limited = hidden_[edge] != 0;
    for (std::uint32_t k = runs_.starts[edge]; k < runs_.starts[edge + 1]; ++k) {
        const ArrangementShape &shape = input_.shapes[input_.contours[runs_.runs[k].contour].shape];
        ofShape = ofShape || shape.partOf == kNoClip;
        limited = limited || (shape.partOf == kNoClip && shape.limit != kNoClip && !inside(faces_.left[edge]));
    }
    const bool isLine = isLine_[edge] != 0;
    return isLine || (ofShape && !limited) ? fate : limited ? Fate::Clipped : Fate::OfClip;
}

/// Chooses the tag of each edge: the tag of the last constraint line along it or else of the first outline that bounds
/// the feature on either side, or else of the first outline of a clip.
void Assembler::chooseTags() {
    enum Rank : std::uint8_t { None, Any, Bounding, Line };
    std::vector<Rank> rank(snapped_.edges.size(), None);
    tag_.assign(snapped_.edges.size(), 1);
    for (std::uint32_t i = 0; i < lineCount(); ++i) {
        const ArrangementPiece &piece = pieceOf(i);
        for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1]; ++k) {
            const std::uint32_t edge = snapped_.ways[k] / 2;
            Rank own = isLine_[edge] != 0 ? Line : None; // none: a line that is clipped away
            if (piece.role == PieceRole::Outline) {
                const std::uint32_t feature = input_.shapes[input_.contours[piece.contour].shape].feature;
                const bool bounds =
                    cover_.owner[faces_.left[edge]] == feature || cover_.owner[faces_.right[edge]] == feature;
                own = bounds && !input_.ofClip(piece) ? Bounding : Any;
            }
            if (own > rank[edge] || own == Line) {
                rank[edge] = own;
                tag_[edge] = piece.tag;
            }
        }
    }
}

std::uint32_t Assembler::node(std::uint32_t snappedNode, std::uint32_t piece) {
    std::uint32_t &number = number_[snappedNode];
    if (number == kNoIndex) {
        number = static_cast<std::uint32_t>(result_.domain.nodes.size());
        result_.domain.nodes.push_back(snapped_.nodes[snappedNode]);
        result_.nodePiece.push_back(piece);
    }
    return number;
}

void Assembler::buildDomain() {
    number_.assign(snapped_.nodes.size(), kNoIndex);
    nodeSide_.assign(snapped_.nodes.size(), 0);
    hasPoint_.assign(snapped_.nodes.size(), 0);
    added_.assign(snapped_.edges.size(), 0);
    for (std::uint32_t e = 0; e < snapped_.edges.size(); ++e) {
        const bool beside = inside(faces_.left[e]) || inside(faces_.right[e]);
        for (const std::uint32_t end : {snapped_.edges[e].a, snapped_.edges[e].b}) {
            nodeSide_[end] = std::max<std::uint8_t>(nodeSide_[end], beside ? 2 : 1);
        }
    }
    for (std::uint32_t i = 0; i < lineCount(); ++i) {
        pieceOf(i).role == PieceRole::Point ? addPoint(i) : addSegments(i);
    }
    takeCurves();
}

/// Adds the curves that segments follow, numbered in the order of the segments.
void Assembler::takeCurves() {
    std::vector<std::uint32_t> number(input_.curves.size(), kNoCurve);
    for (std::size_t s = 0; s < result_.domain.segments.size(); ++s) {
        const CurveStretch &stretch = result_.stretches[s].stretch;
        if (stretch.curve >= number.size()) {
            continue;
        }
        if (number[stretch.curve] == kNoCurve) {
            number[stretch.curve] = static_cast<std::uint32_t>(result_.domain.curves.size());
            result_.domain.curves.push_back(input_.curves[stretch.curve]);
        }
        result_.domain.segments[s].stretch = {number[stretch.curve], stretch.t0, stretch.t1};
    }
}

/// Adds the edges along a line that no line before it has added.
void Assembler::addSegments(std::uint32_t line) {
    const std::uint32_t piece = joined_.source[line];
    for (std::uint32_t k = snapped_.starts[line]; k < snapped_.starts[line + 1]; ++k) {
        const std::uint32_t edge = snapped_.ways[k] / 2;
        if (!kept(edge) || added_[edge] != 0) {
            continue;
        }
        added_[edge] = 1;
        const bool back = snapped_.ways[k] % 2 != 0;
        const std::uint32_t from = back ? snapped_.edges[edge].b : snapped_.edges[edge].a;
        const std::uint32_t to = back ? snapped_.edges[edge].a : snapped_.edges[edge].b;
        const std::uint32_t a = node(from, piece), b = node(to, piece);
        result_.domain.segments.push_back(
            {a, b, tag_[edge], fate_[edge] == Fate::Boundary ? SegmentRole::Boundary : SegmentRole::Constraint});
        result_.stretches.push_back(stretchOf(line, from, to));
        result_.isLine.push_back(separates(edge) ? 0 : 1);
    }
}

/// Returns the part of the line's curve between two nodes on its path.
PieceStretch Assembler::stretchOf(std::uint32_t line, std::uint32_t from, std::uint32_t to) const {
    return {joined_.source[line], stretchAlong(joined_.stretches[line], input_.curves, joined_.lines[line],
                                               snapped_.nodes[from], snapped_.nodes[to])};
}

bool Assembler::pointInside(std::uint32_t node) const {
    return input_.keepOutside || (nodeSide_[node] != 0 ? nodeSide_[node] == 2 : inside(faces_.ofPoint[node]));
}

void Assembler::addPoint(std::uint32_t line) {
    const std::uint32_t at = snapped_.first[line], piece = joined_.source[line];
    if (!pointInside(at)) {
        changes_.add(ChangeKind::OutsidePoints, snapped_.nodes[at], 0.0, line);
        return;
    }
    if (hasPoint_[at] == 0) {
        hasPoint_[at] = 1;
        result_.domain.points.push_back({node(at, piece), input_.pieces[piece].tag});
        result_.pointPiece.push_back(piece);
    }
}

/// Compares the areas that contours run around before and after joining.
double Assembler::areaChange() const {
    std::vector<Vec2> origin(input_.contours.size());
    std::vector<std::uint8_t> known(input_.contours.size(), 0);
    std::vector<CompensatedSum> given(input_.contours.size()), change(input_.contours.size());
    for (std::uint32_t i = 0; i < lineCount(); ++i) {
        if (pieceOf(i).role != PieceRole::Outline || input_.ofClip(pieceOf(i))) {
            continue;
        }
        const std::uint32_t contour = pieceOf(i).contour;
        const SnapLine &line = joined_.lines[i];
        if (known[contour] == 0) {
            known[contour] = 1;
            origin[contour] = line.a;
        }
        const Vec2 from = origin[contour];
        const double own = cross(line.a - from, line.b - from);
        given[contour].add(own);
        change[contour].add(-own);
        for (std::uint32_t k = snapped_.starts[i]; k < snapped_.starts[i + 1]; ++k) {
            const PlaneEdge &edge = snapped_.edges[snapped_.ways[k] / 2];
            const double area = cross(snapped_.nodes[edge.a] - from, snapped_.nodes[edge.b] - from);
            change[contour].add(snapped_.ways[k] % 2 == 0 ? area : -area);
        }
    }
    double whole = 0.0, changed = 0.0, covered = 0.0;
    for (std::size_t c = 0; c < given.size(); ++c) {
        whole += 0.5 * std::fabs(given[c].value());
        changed += 0.5 * std::fabs(change[c].value());
    }
    for (std::uint32_t face = 1; face < faces_.count; ++face) {
        covered += inside(face) ? cover_.area[face] : 0.0; // counts self-crossing contours
    }
    return changed > 0.0 ? changed / std::max(whole, covered) : 0.0;
}

} // namespace forefront
