#pragma once

#include "core/drawing/constraints/shape_unknowns.hpp"
#include "core/drawing/constraints/sketch_joints.hpp"
#include "core/drawing/document/document.hpp"
#include "core/drawing/sketch/sketch_system.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

/// The unknowns of the parts of a document that constraints name, as a sketch that the solver can work on. Shapes and
/// nodes that no constraint names are not in it. Parts that are asked for must exist: see formOfPart(). Numbers of
/// locked shapes and numbers with formulas are held. Keeps a reference to the document.
class DocumentSketch {
  public:
    /// An unknown centre and radius.
    struct Round {
        SketchPoint centre; ///< not of a rounded corner
        std::uint32_t radius = 0;
    };
    struct Ends {
        SketchPoint a, b;
    };
    struct Axes {
        SketchPoint centre, u, v;
    };
    /// A Bézier segment: its ends, and its control points as offsets from these.
    struct Cubic {
        SketchPoint start, end, startOffset, endOffset;
    };

    explicit DocumentSketch(const Document &document) : document_(document) {}

    const Document &document() const { return document_; }
    SketchSystem system;
    std::vector<SketchJoint> joints; ///< whose equations belong to the constraints jointId(0), jointId(1), and so on
    /// Unknowns of segments that nodes of the sketch lie on, and of what is joined with these. They should stay as they
    /// are where there is a solution without moving them.
    std::vector<std::uint32_t> standing;
    /// Returns for each unknown whether it is in `standing`.
    std::vector<bool> isStanding() const;
    std::uint32_t jointId(std::size_t joint) const { return document_.nextId + static_cast<std::uint32_t>(joint); }

    SketchPoint point(const SketchPart &part);
    /// Returns two points on a line: the ends of a segment. For the side of a slot these are the points where its ends
    /// begin.
    Ends line(const SketchPart &part);
    /// Returns two points in the direction of a line, from its start to its end, with fewer unknowns than line().
    Ends direction(const SketchPart &part);
    Round round(const SketchPart &part);
    Axes ellipse(const SketchPart &part);
    Cubic cubic(const SketchPart &part);
    /// Returns the centre of a circle or an ellipse.
    SketchPoint centre(const SketchPart &part);

    /// Adds the equations of numbers with formulas that are no unknowns themselves, such as the width of a rectangle,
    /// the equations of joints, and the corners, edges and radii to be kept. Call it after all parts were added.
    void finish(const JointSource &source = {});

    /// Returns the index of an unknown, if the sketch has it.
    std::optional<std::uint32_t> find(const ShapeUnknown &unknown) const;
    /// Returns the numbers of shapes that are unknowns, with their indices.
    const std::map<ShapeUnknown, std::uint32_t> &unknowns() const { return indices_; }
    /// Returns the numbers of shapes that belong to some part asked for.
    std::vector<std::uint32_t> unknownsOf(const SketchPart &part);
    /// Returns the document with the values of a solution. Shapes whose values are unchanged are shared with it.
    Document withValues(const std::vector<double> &values) const;
    /// Returns another document, with shapes that have the same numbers, with the values of a solution.
    Document withValues(const std::vector<double> &values, Document of) const;
    /// Returns true if some number that formulas or locks hold belongs to the sketch.
    bool holdsNumbers() const;

  private:
    const Shape &shapeOf(std::uint32_t id) const;
    std::uint32_t unknown(const Shape &shape, ShapeUnknown::Role role, std::uint32_t index);
    SketchPoint node(const Shape &shape, std::uint32_t index);
    SketchPoint corner(const Shape &rectangle, std::uint32_t index);
    SketchPoint moved(const Shape &shape, SketchPoint from, SketchPoint offset, const SketchPart &part);
    SketchPoint constant(Vec2 at);
    Ends pathEnds(const Shape &path, std::uint32_t segment);
    Round arc(const Shape &path, std::uint32_t segment);
    Axes axes(const Shape &ellipse);
    Cubic cubicOf(const Shape &path, std::uint32_t segment);
    Ends slotSide(const Shape &slot, std::uint32_t segment);
    void holdFormulas();
    void holdFormula(const NumberAddress &address);
    void hold(const ShapeUnknown &unknown);
    void addGuards(const Shape &shape);

    const Document &document_;
    std::map<ShapeUnknown, std::uint32_t> indices_;
    std::map<SketchPart, SketchPoint> derived_; ///< points with unknowns of their own, defined by equations
    std::map<SketchPart, Ends> sides_;          ///< of slots
    std::set<std::pair<std::uint32_t, std::uint32_t>> arcs_;
    std::set<std::uint32_t> ellipses_, shapes_;
    std::set<NumberAddress> lengths_; ///< with formulas, whose equations have been added
    std::optional<SketchPoint> zero_, origin_, alongX_, alongY_;
    bool holdsNumbers_ = false;
};

} // namespace forefront
