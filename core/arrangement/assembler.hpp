#pragma once

#include "core/arrangement/arrangement.hpp"
#include "core/arrangement/cover.hpp"
#include "core/arrangement/snap.hpp"
#include "core/domain/faces.hpp"

namespace forefront {

/// Puts the domain together from snapped pieces and their faces.
class Assembler {
  public:
    Assembler(const ArrangementInput &input, const SnappedLines &snapped, Faces faces);

    Arrangement run();

  private:
    /// What becomes of an edge.
    enum class Fate : std::uint8_t { Boundary, Constraint, Inner, Folded, Outside };

    void collectRuns();
    void decideFates();
    Fate fateOf(std::uint32_t edge) const;
    void chooseTags();
    void buildDomain();
    void addSegments(std::uint32_t piece);
    void addPoint(std::uint32_t piece);
    std::uint32_t node(std::uint32_t snappedNode, std::uint32_t piece);
    PieceStretch stretchOf(std::uint32_t piece, std::uint32_t from, std::uint32_t to) const;
    bool pointInside(std::uint32_t node) const;
    std::vector<std::uint32_t> joinFaces() const;
    void markRegions();
    void report();
    void reportNodes();
    void reportPiece(std::uint32_t piece);
    void reportOverlaps();
    bool overlap(std::uint32_t face) const;
    void note(ChangeKind kind, Vec2 at, double displacement, std::uint32_t piece);

    bool inside(std::uint32_t face) const { return cover_.shapes[face] > 0; }
    bool kept(std::uint32_t edge) const { return fate_[edge] == Fate::Boundary || fate_[edge] == Fate::Constraint; }

    const ArrangementInput &input_;
    const SnappedLines &snapped_;
    Faces faces_;
    EdgeRuns runs_;
    FaceCover cover_;
    std::vector<std::uint8_t> isLine_;   ///< per edge: a constraint runs along it
    std::vector<Fate> fate_;             ///< per edge
    std::vector<std::int32_t> tag_;      ///< per edge
    std::vector<std::uint8_t> added_;    ///< per edge: it is in the domain
    std::vector<std::uint32_t> number_;  ///< per snapped node: its index in the domain
    std::vector<std::uint8_t> nodeSide_; ///< per snapped node: 1 if it has edges, 2 if some face around is inside
    std::vector<std::uint8_t> hasPoint_; ///< per snapped node: it is a constraint point of the domain
    Arrangement result_;
};

} // namespace forefront
