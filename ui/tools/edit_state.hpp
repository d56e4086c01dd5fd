#pragma once

#include "core/base/result.hpp"
#include "core/edit/pick_index.hpp"
#include "core/edit/snap.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace forefront {

struct AppContext;
class CanvasPainter;

namespace ui {
class Flow;
}

/// What the editing tools share: the index for picking, snapping, and what the user has set in their strips.
struct EditState {
    bool snapToGrid = true;
    bool snapToDrawing = true;
    std::int32_t boundaryTag = 1;   ///< of the next boundary drawn
    std::int32_t constraintTag = 2; ///< of the next constraint drawn
    double brushRadius = 0.0;       ///< domain units; 0: from the size of the view, when first used
    double brushSpacing = 0.0;      ///< painted ρ; 0: from ρ under the pointer, when first used
    int sourceShape = 0;            ///< SourceShape
    double sourceSize = 0.0;        ///< 0: from ρ under the pointer, when first used
    double sourceGrowth = 0.2;

    /// Index of the current document; built when the document has changed.
    const std::shared_ptr<const PickIndex> &index(const AppContext &context);
    /// A key for DocumentStore::apply() that no stroke had before.
    std::string newStroke();
    /// Makes `next` the document; where it was refused, says so in the log. True if it is.
    static bool apply(AppContext &context, Result<Document> next, const std::string &label,
                      const std::string &merge = {});
    /// Reach of the pointer in domain units.
    static double reach(const AppContext &context, double designPixels);
    /// Snaps as switched on; `angle` and `off` by the modifiers of the event.
    SnapQuery query(const AppContext &context, Vec2 place, bool angle, bool off) const;
    /// The same with two digits, for numbers that nobody asked for.
    static double twoDigits(double value);
    /// Two switches for the strip of a tool.
    void drawSnapOptions(AppContext &context, ui::Flow &flow);

  private:
    std::shared_ptr<const PickIndex> index_;
    std::uint64_t revision_ = 0;
    std::uint64_t strokes_ = 0;
};

/// Mark at a place that something was drawn to, in the way of its kind.
void drawSnapMark(CanvasPainter &painter, const AppContext &context, const Snapped &snapped);

} // namespace forefront
