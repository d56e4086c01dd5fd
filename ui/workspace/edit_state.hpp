#pragma once

#include "core/drawing/picking/pick_index.hpp"
#include "core/drawing/picking/pointer_snap.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/spacing/parts/paint/paint.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

struct Workspace;

namespace ui {
class Flow;
}

/// How the polygon and polyline tools draw a path.
enum class PenMode : std::uint8_t { Corners, Spline, Freehand };

template <>
struct EnumWords<PenMode> {
    static constexpr auto kLast = PenMode::Freehand;
    static constexpr std::array<std::string_view, 3> kList = {"corners", "spline", "freehand"};
};

/// How the arc tool draws.
enum class ArcMode : std::uint8_t { Points, Centre };

template <>
struct EnumWords<ArcMode> {
    static constexpr auto kLast = ArcMode::Centre;
    static constexpr std::array<std::string_view, 2> kList = {"three points", "centre"};
};

/// The result of a freehand stroke.
enum class FreehandPath : std::uint8_t {
    Smooth, ///< curves, with corners where the hand turned sharply
    Corners ///< straight segments
};

template <>
struct EnumWords<FreehandPath> {
    static constexpr auto kLast = FreehandPath::Corners;
    static constexpr std::array<std::string_view, 2> kList = {"smooth", "corners"};
};

/// The kinds of items that the select tool picks.
struct SelectionFilter {
    bool shapes = true; ///< also their segments
    bool nodes = true;  ///< nodes of shapes that can be picked
    bool sources = true, markers = true;
    bool constraints = true; ///< of the sketch

    /// Removes items of other kinds from a selection.
    void apply(Selection &selection) const;
};

/// State shared by the editing tools: the picking index and the options in their strips.
struct EditState {
    /// Tags of the next boundaries and constraints drawn, as chosen by the user; absent: see tagOfNext().
    std::optional<std::int32_t> boundaryTag, constraintTag;
    double brushRadius = 0.0; ///< domain units; 0: not set by the user, follows the view
    ArcMode arcMode = ArcMode::Points;
    FreehandPath freehandPath = FreehandPath::Smooth;
    double freehandTolerance = 0.0; ///< maximum distance from the stroke, domain units; 0: two pixels
    SelectionFilter picks;
    DabMode brushMode = DabMode::Set;
    double brushStrength = 1.0; ///< see Dab, in (0, 1]
    double brushFalloff = 0.3;  ///< fraction of the radius over which a dab fades, in [0, 1]
    double brushSpacing = 0.0;  ///< painted ρ; 0: not set by the user, follows the present ρ
    SourceShape sourceShape = SourceShape::Point;
    double sourceSize = 0.0;             ///< 0: derived from ρ under the pointer
    std::optional<double> sourceEndSize; ///< of a line, at its second end; absent: the same
    double sourceGrowth = 0.2;
    std::string sourceSizeFormula, sourceGrowthFormula; ///< expressions of the two numbers; empty: plain numbers
    double gradientSize = 0.0, gradientEndSize = 0.0;   ///< 0: derived from ρ under the pointer
    bool gradientGeometric = false;
    std::uint64_t placed = 0;         ///< number of places that the drawing tools have taken, to tell what came last
    bool gradientInSelection = false; ///< paint the selected shapes rather than cover the plane

    /// Returns the index of the current document; rebuilds it if the document has changed.
    const std::shared_ptr<const PickIndex> &index(const Workspace &context);
    /// Returns the index that was asked for last; null: none yet.
    const std::shared_ptr<const PickIndex> &lastIndex() const { return index_; }
    /// Returns the tag of the next shape drawn: the one that the user has chosen, else 1 for boundaries and 2 for
    /// constraints, or a free one where that part has a name, a size or a number of elements, or 2 is a hole's.
    std::int32_t tagOfNext(ShapeUse use, const Document &document) const;
    /// Returns the tag of a shape that is drawn now: like tagOfNext(), but if the user has chosen none, a boundary that
    /// lies inside another, such as a hole, gets a tag of its own, so that it can be named alone.
    std::int32_t tagOfDrawn(const Shape &shape, const Document &document) const;
    /// Resets tags of the next shapes and sizes in domain units, which belong to one drawing.
    void forgetNumbers();
    /// Sets a number in domain units to the one that a tool has used, so that it stays for the next use. It counts as
    /// proposed unless it was set already.
    void propose(double EditState::*number, double value, const Workspace &context);
    /// Returns a number in domain units; 0 if none is set, or if it was proposed while the drawing had less than half
    /// or more than twice its present extent, as before a picture was calibrated.
    double held(double EditState::*number, const Workspace &context) const;
    /// Returns a new stroke key for DocumentStore::apply().
    std::string newStroke();
    /// Converts a distance around the pointer from design pixels to domain units.
    static double reach(const Workspace &context, double designPixels);
    /// Returns the step of the drawing grid as it is shown.
    static double gridStep(const Workspace &context);
    /// Returns a snap query with the current options; `angle` and `off` come from the modifiers of the event.
    SnapQuery query(const Workspace &context, Vec2 place, bool angle, bool off) const;
    /// Draws the snapping switches in the options strip.
    void drawSnapOptions(Workspace &context, ui::Flow &flow);

  private:
    static void drawGridStep(Workspace &context);

    struct Proposal {
        double EditState::*number;
        double value, extent; ///< diagonal of the drawing then
    };
    double extent(const Workspace &context) const;

    std::vector<Proposal> proposals_; ///< one for each number
    mutable double extent_ = 0.0;     ///< of the drawing with the revision
    mutable std::uint64_t extentRevision_ = 0;
    std::shared_ptr<const PickIndex> index_;
    std::uint64_t revision_ = 0;
    std::uint64_t strokes_ = 0;
};

} // namespace forefront
