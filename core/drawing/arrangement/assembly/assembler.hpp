#pragma once

#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/arrangement/change.hpp"
#include "core/drawing/arrangement/cover/cover.hpp"
#include "core/drawing/arrangement/curves/joined_lines.hpp"
#include "core/drawing/arrangement/repeated_lines/beside_outlines.hpp"
#include "core/drawing/arrangement/repeated_lines/without_repeats.hpp"
#include "core/engine/domain/faces.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace forefront {

/// Puts the domain together from snapped pieces and their faces.
class Assembler {
  public:
    /// `joined`: the pieces as lines.
    Assembler(const ArrangementInput &input, const JoinedLines &joined, Faces faces);

    Arrangement run();
    /// Returns the drawing without the lines that repeat outlines if there are any, to be arranged again: the nodes
    /// that those leave on outlines would still be in the way.
    std::optional<ReducedDrawing> reduced() const;

  private:
    /// The role of an edge in the domain, or the reason why it is dropped.
    /// Shared: a line of outlines that run along each other.
    enum class Fate : std::uint8_t { Boundary, Constraint, Shared, Inner, Folded, Outside, Clipped, OfClip, Repeated };

    void collectRuns();
    std::vector<ClippedLine> clippedLines();
    void decideFates();
    Fate fateOf(std::uint32_t edge) const;
    bool separates(std::uint32_t edge) const;
    Fate clippedFate(std::uint32_t edge, Fate fate) const;
    void findRepeats();
    std::vector<BesideEdge> edgesBeside() const;
    void chooseTags();
    void buildDomain();
    void takeCurves();
    void addSegments(std::uint32_t line);
    void addPoint(std::uint32_t line);
    std::uint32_t node(std::uint32_t snappedNode, std::uint32_t piece);
    PieceStretch stretchOf(std::uint32_t line, std::uint32_t from, std::uint32_t to) const;
    bool pointInside(std::uint32_t node) const;
    std::vector<std::uint32_t> joinFaces() const;
    void markRegions();
    double areaChange() const;
    void report();
    std::vector<std::uint8_t> asidePieces() const;
    void reportHidden(std::uint32_t piece);
    void reportLine(std::uint32_t line);
    void reportOverlaps();
    void reportVanished();
    Vec2 placeInside(std::uint32_t face) const;
    std::uint32_t firstLineAround(std::uint32_t face) const;
    bool overlap(std::uint32_t face) const;

    std::uint32_t lineCount() const { return static_cast<std::uint32_t>(joined_.lines.size()); }
    const ArrangementPiece &pieceOf(std::uint32_t line) const { return input_.pieces[joined_.source[line]]; }
    bool inside(std::uint32_t face) const { return cover_.shapes[face] > 0; }
    bool kept(std::uint32_t edge) const { return fate_[edge] <= Fate::Shared; }

    const ArrangementInput &input_;
    const JoinedLines &joined_;
    const SnappedLines &snapped_;
    Faces faces_;
    EdgeRuns runs_;
    FaceCover cover_;
    std::vector<std::uint8_t> isLine_; ///< per edge: a constraint runs along it and is not clipped away
    std::vector<std::uint8_t> hidden_; ///< per edge: a constraint along it is clipped away; empty without clips
    std::vector<Fate> fate_;           ///< per edge
    std::vector<BesideEdge> beside_;   ///< per edge; empty if no line may be dropped
    RepeatedOutlines repeats_;
    std::map<std::uint32_t, double> repeated_; ///< the edges that repeat outlines, with their distance from them
    std::vector<std::int32_t> tag_;            ///< per edge
    std::vector<std::uint8_t> added_;          ///< per edge: it is in the domain
    std::vector<std::uint32_t> number_;        ///< per snapped node: its index in the domain
    std::vector<std::uint8_t> nodeSide_;       ///< per snapped node: 1 if it has edges, 2 if some face around is inside
    std::vector<std::uint8_t> hasPoint_;       ///< per snapped node: it is a constraint point of the domain
    ChangeList changes_;
    Arrangement result_;
};

} // namespace forefront
