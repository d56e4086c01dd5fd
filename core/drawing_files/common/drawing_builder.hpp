#pragma once

#include "core/drawing/arrangement/arrangement.hpp"
#include "core/drawing/arrangement/cover/united.hpp"
#include "core/drawing_files/common/line_outline.hpp"
#include "core/files/common/tag_allocator.hpp"
#include "core/files/source/source.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

/// Collects outlines, lines and points of a drawing or map and arranges them into a domain, with notes on the changes.
class DrawingBuilder {
  public:
    explicit DrawingBuilder(const SourceText &source);

    /// Sets the byte offsets in the text of the nodes added next; nodes beyond the list get its last offset.
    void from(std::vector<std::size_t> offsets) { offsets_ = std::move(offsets); }
    std::uint32_t addFeature(std::int32_t regionTag, std::string name = {});
    std::uint32_t addShape(std::uint32_t feature, std::string name = {}, std::uint32_t limit = kNoClip) {
        return input_.addShape(feature, std::move(name), limit);
    }
    /// Adds a clip that shapes and lines may be limited to.
    std::uint32_t addClip(std::uint32_t within = kNoClip) { return input_.addClip(within); }
    std::uint32_t addClipPart(std::uint32_t clip, std::uint32_t limit, bool removes) {
        return input_.addClipPart(clip, limit, removes);
    }
    std::uint32_t addContour(std::uint32_t shape, FillRule rule, bool hole = false);
    /// The origin of a piece of a synthetic area.
    struct MadeFrom {
        std::int32_t tag = 1;
        std::size_t offset = 0; ///< in the text
        std::uint32_t shape = 0;
    };
    /// Adds a synthetic area, one derived from elements of the file, such as the area of a stroke. The labels of its
    /// pieces are indices into `parts`.
    void addMadeArea(std::uint32_t shape, const OutlinedArea &area, std::span<const MadeFrom> parts);
    /// Adds curves and renumbers the stretches that refer to them.
    void addCurves(std::span<const Curve> curves, std::span<CurveStretch> stretches);
    /// Adds a closed loop to a contour, its first node not repeated. The stretches, if given, are the parts of curves
    /// that the segments from each node on are chords of; the last ones may be missing.
    void addRing(std::uint32_t contour, std::span<const Vec2> nodes, std::int32_t tag,
                 std::span<const CurveStretch> stretches = {});
    /// Adds a line; where it lies on an outline, the outline takes the tag of the line. The parts that repeat an
    /// outline within half of `width`, the width that it is drawn with, are dropped.
    void addChain(std::span<const Vec2> nodes, std::int32_t tag, std::span<const CurveStretch> stretches = {},
                  std::uint32_t limit = kNoClip, double width = 0.0);
    void addPoint(Vec2 at, std::int32_t tag);
    /// Puts region markers into the domain; without them all elements have the tag 1.
    void markRegions() { input_.markRegions = true; }
    /// Lets later features hide the parts of earlier ones that they cover.
    void layer() { input_.layered = true; }

    /// Sets the default tolerance, limited to ten times the usual one.
    void preferTolerance(double tolerance) { preferred_ = tolerance; }
    /// Lets lines that form closed loops bound the domain beside its outlines, too, and keeps a side that two outlines
    /// share as a line; for drawings in which nothing is filled, so that outlines differ from lines only in how they
    /// were drawn. `names`: how warnings name tags, such as by layers; not copied.
    void letLinesBound(const TagAllocator &names) {
        linesBound_ = true;
        names_ = &names;
        input_.keepFolds = true;
    }

    /// Returns true if there are outlines of shapes, not counting outlines of clips.
    bool hasOutlines() const;

    /// Arranges everything. Lines that form closed loops bound the domain if there are no outlines, or if they may.
    /// Faults: those of arrange(); empty-domain; with ImportOptions::strict, every change that would be needed.
    Result<Domain> finish();

  private:
    std::size_t offset(std::size_t node) const;
    /// Returns the byte offset of a piece in the text; 0 if that is unknown.
    std::size_t offsetOf(std::uint32_t piece) const;
    Result<Arrangement> arrangeByDefault();
    Result<Arrangement> arrangeParts();
    Result<Arrangement> arrangeBounded(const Arrangement &lines, std::size_t count);
    ArrangementInput withOutline(const Arrangement &lines) const;
    Diagnostics report(const Arrangement &arrangement) const;
    void noteLoopsLeft(const Arrangement &lines, const LineLoops &loops) const;
    void warnOfOverlaps() const;
    void warnOfCrossings(const Arrangement &lines) const;
    std::string pairText(std::uint32_t first, std::uint32_t second) const;
    void noteLineGaps(const Arrangement &lines, std::size_t boundary);
    void noteSmallDomain(const Domain &domain, const Box2 &lines) const;
    void noteFeatureGaps(const Arrangement &arrangement) const;
    void noteShortSegments(const Arrangement &arrangement) const;
    void noteLines(const Arrangement &arrangement) const;
    void noteManyLines(const Arrangement &arrangement, std::size_t lines) const;
    void noteNearLines(const Arrangement &arrangement) const;
    void recordOrigin(const Arrangement &arrangement) const;

    const SourceText &source_;
    ArrangementInput input_;
    std::vector<std::uint32_t> rings_; ///< the first piece of each ring
    bool linesBound_ = false;
    bool open_ = false;                   ///< a warning names an outline that does not close
    const TagAllocator *names_ = nullptr; ///< set with linesBound_
    double preferred_ = 0.0;              ///< tolerance
    std::vector<std::size_t> offsets_;
    std::vector<std::size_t> places_; ///< byte offsets in the text of the ends of the pieces, two per piece
};

} // namespace forefront
