#include "core/drawing/constraints/constraint_figures.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/constraint_glyphs.hpp"
#include "ui/canvas/dimension_lines.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/layers/layers.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Maximum numbers of glyphs, and of parts in a colour of their own; more would be clutter.
constexpr std::size_t kMaxGlyphs = 400, kMaxColoured = 4000;
constexpr double kGlyphGap = 2.0; ///< between glyphs, design pixels

std::string nameOf(std::uint32_t constraint, std::size_t k) {
    return "sketch/" + std::to_string(constraint) + '/' + std::to_string(k);
}

/// Draws the constraints of the sketch: glyphs beside their parts, dimension lines with their values, and the colours
/// of what is determined and of what cannot hold.
class SketchLayer final : public Layer {
  public:
    const char *id() const override { return "sketch"; }
    const char *name() const override { return "Sketch"; }
    bool hasLegend() const override { return legend_; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        update(frame);
        legend_ = !items_.empty();
        if (items_.empty()) {
            return;
        }
        drawColours(painter, frame);
        keepPlaces(frame);
        const std::size_t before = painter.labels().size();
        drawDimensions(painter, frame);
        drawGlyphs(painter, frame);
        drawChosen(painter, frame, before);
    }

    bool drawLegend(CanvasPainter &painter, const LayerFrame &frame, Pixel corner) override;

  private:
    /// A constraint with what it is drawn by.
    struct Item {
        std::shared_ptr<const SketchConstraint> constraint;
        std::vector<GlyphAnchor> anchors;
        std::optional<DimensionFigure> figure;
        std::string text; ///< of a dimension
    };

    void update(const LayerFrame &frame) {
        if (revision_ == frame.revision) {
            return;
        }
        revision_ = frame.revision;
        items_.clear();
        const Document &document = frame.document;
        for (const auto &constraint : document.constraints) {
            const bool hidden =
                std::any_of(constraint->parts.begin(), constraint->parts.end(), [&](const SketchPart &part) {
                    const Shape *const shape = findShape(document, part.shape);
                    return shape != nullptr && shape->hidden;
                });
            if (hidden) {
                continue;
            }
            Item item{constraint, {}, dimensionFigure(document, *constraint), {}};
            if (item.figure) {
                item.text = dimensionText(document, *constraint);
            } else {
                item.anchors = glyphAnchors(document, *constraint);
            }
            items_.push_back(std::move(item));
        }
    }

    /// Forgets where glyphs and values lie once the drawing or the view has changed. Until then they stay, so that a
    /// selection, a message or the first click of a double-click moves none of them.
    void keepPlaces(const LayerFrame &frame) {
        const Camera &camera = frame.camera;
        const SketchView view{frame.revision, camera.toPixel({0, 0}), camera.zoom, camera.viewport.width,
                              camera.viewport.height};
        if (view != view_) {
            view_ = view;
            places_.clear();
        }
    }

    /// Returns where the k-th glyph of a constraint, or its value, has been drawn.
    std::optional<Pixel> placeOf(const Item &item, std::size_t k) const {
        const auto place = places_.find({item.constraint->id, k});
        return place != places_.end() ? std::optional(place->second) : std::nullopt;
    }

    static bool isSelected(const LayerFrame &frame, const Item &item) {
        return frame.selection.constraints.contains(item.constraint->id);
    }

    /// Returns the colour of a constraint and the mark before its glyph or value, if anything is wrong with it.
    static std::pair<Colour, std::string> stateOf(const LayerFrame &frame, const Item &item) {
        const SketchState *const state = frame.preview.sketch.get();
        if (state != nullptr && state->violated.contains(item.constraint->id)) {
            return {frame.theme.bad, icon::kError};
        }
        if (state != nullptr && state->redundant.contains(item.constraint->id)) {
            return {frame.theme.warn, icon::kWarning};
        }
        return {frame.blamed.contains(item.constraint->id) ? frame.theme.bad : frame.theme.text, ""};
    }

    void drawDimensions(CanvasPainter &painter, const LayerFrame &frame) {
        constexpr double kGap = 18.0; // of parallel dimension lines, design pixels
        DimensionRoom room(kGap * painter.scale());
        for (const Item &item : items_) {
            if (!item.figure) {
                continue;
            }
            const auto [colour, mark] = stateOf(frame, item);
            const DimensionStyle style{isSelected(frame, item) ? frame.theme.selection : colour,
                                       labelPlate(frame.theme), frame.fonts.small, isSelected(frame, item),
                                       placeOf(item, 0)};
            if (const std::optional<Pixel> place =
                    drawDimension(painter, room, *item.figure, item.constraint->label, mark + item.text, style)) {
                places_.insert_or_assign({item.constraint->id, 0}, *place);
                painter.nameLabel(nameOf(item.constraint->id, 0));
            }
        }
    }

    void drawGlyphs(CanvasPainter &painter, const LayerFrame &frame) {
        const Box2 visible = frame.camera.visible();
        std::size_t drawn = 0;
        for (const Item &item : items_) {
            const auto [colour, mark] = stateOf(frame, item);
            const std::string text = mark + glyphOf(item.constraint->kind);
            for (std::size_t k = 0; k < item.anchors.size() && drawn < kMaxGlyphs; ++k) {
                const GlyphAnchor &anchor = item.anchors[k];
                if (!visible.contains(anchor.at)) {
                    continue;
                }
                std::optional<Pixel> place = placeOf(item, k);
                if (!place) {
                    const Pixel size = painter.labelSize(text, frame.fonts.small);
                    place =
                        painter.freeOffset(anchor.at, glyphOffsets(anchor, size, kGlyphGap), text, frame.fonts.small);
                }
                if (place) {
                    places_.insert_or_assign({item.constraint->id, k}, *place);
                    painter.fixedLabel(anchor.at, *place, text,
                                       isSelected(frame, item) ? frame.theme.selection : colour,
                                       labelPlate(frame.theme), frame.fonts.small);
                    painter.nameLabel(nameOf(item.constraint->id, k));
                    ++drawn;
                }
            }
        }
    }

    /// Highlights what selected constraints and the one under the pointer tie.
    void drawChosen(CanvasPainter &painter, const LayerFrame &frame, std::size_t firstLabel) const {
        const std::optional<Pixel> pointer =
            frame.pointer ? std::optional(frame.camera.toPixel(*frame.pointer)) : std::nullopt;
        std::string under;
        for (std::size_t k = firstLabel; k < painter.labels().size(); ++k) {
            const CanvasPainter::Placed &label = painter.labels()[k];
            if (pointer && label.rect.contains(*pointer)) {
                under = label.name;
                painter.frame(label.rect, frame.theme.selection);
            }
        }
        for (const Item &item : items_) {
            const std::string stem = nameOf(item.constraint->id, 0);
            const bool pointed = !under.empty() && under.starts_with(stem.substr(0, stem.size() - 1));
            if (pointed || isSelected(frame, item)) {
                for (const SketchPart &part : item.constraint->parts) {
                    drawPart(painter, frame, part, frame.theme.selection, 4.0, false);
                }
            }
            if (pointed) { // messages call it by this name
                constexpr Pixel kBeside{16.0, 14.0};
                painter.label(*frame.pointer, kBeside, item.constraint->name, frame.theme.text, frame.theme.popup,
                              frame.fonts.small);
                painter.nameLabel("canvas/constraint");
            }
        }
    }

    static void drawPart(CanvasPainter &painter, const LayerFrame &frame, const SketchPart &part, Colour colour,
                         double width, bool dashed) {
        if (const std::optional<Vec2> place = placeOfPart(frame.document, part)) {
            painter.ring(*place, 5.0, fade(colour, 0.8), 0.5 * width);
            return;
        }
        if (part.kind > SketchPartKind::Origin) {
            const Box2 visible = frame.camera.visible();
            const bool upright = part.kind == SketchPartKind::YAxis;
            painter.dashed(upright ? Vec2{0.0, visible.min.y} : Vec2{visible.min.x, 0.0},
                           upright ? Vec2{0.0, visible.max.y} : Vec2{visible.max.x, 0.0}, fade(colour, 0.6), 1.0);
            return;
        }
        const Shape *const shape = findShape(frame.document, part.shape);
        if (shape == nullptr) {
            return;
        }
        const Outline outline = outlineOf(*shape);
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            if (outline.part(k) == part.index) {
                if (dashed && !outline.isCurved(k)) {
                    painter.dashed(outline.from(k), outline.to(k), colour, width, 4.0);
                } else {
                    painter.curve(outline.curve(k), dashed ? colour : fade(colour, 0.6), width);
                }
            }
        }
    }

    /// Finds what is determined, once for each state of the sketch and document.
    void updateDetermined(const LayerFrame &frame) {
        const std::shared_ptr<const SketchState> &state = frame.preview.sketch;
        if (colouredState_ == state && colouredRevision_ == frame.revision) {
            return;
        }
        colouredState_ = state;
        colouredRevision_ = frame.revision;
        curves_.clear();
        dots_.clear();
        std::size_t taken = 0;
        const Shape *shape = nullptr;
        Outline outline;
        std::vector<Vec2> handles;
        for (const auto &[part, determined] : state->determined) { // by shape
            if (!determined || ++taken > kMaxColoured) {
                continue;
            }
            if (shape == nullptr || shape->id != part.shape) {
                shape = findShape(frame.document, part.shape);
                outline = shape != nullptr && !shape->hidden ? outlineOf(*shape) : Outline();
                handles = shape != nullptr && !shape->hidden ? handlesOf(*shape) : std::vector<Vec2>();
            }
            if (part.kind == SketchPartKind::Node && part.index < handles.size()) {
                dots_.push_back(handles[part.index]);
            }
            for (std::size_t k = 0; part.kind == SketchPartKind::Segment && k < outline.segmentCount(); ++k) {
                if (outline.part(k) == part.index) {
                    curves_.push_back(outline.curve(k));
                }
            }
        }
    }

    /// Draws the determined segments and nodes, and the parts of constraints that do not hold.
    void drawColours(CanvasPainter &painter, const LayerFrame &frame) {
        const SketchState *const state = frame.preview.sketch.get();
        if (state == nullptr) {
            return;
        }
        updateDetermined(frame);
        for (const Curve &curve : curves_) {
            painter.curve(curve, frame.theme.determined, 2.0);
        }
        for (const Vec2 dot : dots_) {
            painter.dot(dot, 2.5, frame.theme.determined);
        }
        for (const Item &item : items_) {
            if (state->violated.contains(item.constraint->id)) {
                for (const SketchPart &part : item.constraint->parts) {
                    drawPart(painter, frame, part, frame.theme.bad, 2.5, true);
                }
            }
        }
    }

    /// What the places of glyphs and values depend on, apart from what they are to stay for.
    struct SketchView {
        std::uint64_t revision = 0;
        Pixel origin{};
        double zoom = 0.0, width = 0.0, height = 0.0;
        friend bool operator==(const SketchView &, const SketchView &) = default;
    };

    std::vector<Item> items_; ///< of the document with revision_
    SketchView view_;
    std::map<std::pair<std::uint32_t, std::size_t>, Pixel> places_; ///< offsets by constraint and number, for view_
    std::uint64_t revision_ = 0;
    std::vector<Curve> curves_; ///< determined segments, of colouredState_ and the document with colouredRevision_
    std::vector<Vec2> dots_;    ///< determined nodes
    std::shared_ptr<const SketchState> colouredState_;
    std::uint64_t colouredRevision_ = 0;
    bool legend_ = false; ///< shown in the last frame
};

bool SketchLayer::drawLegend(CanvasPainter &painter, const LayerFrame &frame, Pixel corner) {
    const SketchState *const state = frame.preview.sketch.get();
    if (!legend_ || state == nullptr) {
        return false;
    }
    const double s = frame.scale;
    const auto at = [](double x, double y) { return ImVec2{static_cast<float>(x), static_cast<float>(y)}; };
    const double left = std::round(corner.x - kLegendWidth * s), top = std::round(corner.y - kLegendHeight * s);
    ImDrawList &list = painter.list();
    const auto round = static_cast<float>(6.0 * s);
    list.AddRectFilled(at(left, top), at(corner.x, corner.y), labelPlate(frame.theme), round);
    list.AddRect(at(left, top), at(corner.x, corner.y), frame.theme.popupBorder, round);
    ImFont *const font = frame.fonts.small;
    const std::string title = !state->violated.empty() ? "Sketch: constraints that do not hold"
                              : state->degrees == 0    ? "Sketch: fully determined"
                                                    : "Sketch: " + countText(state->degrees, "degree") + " of freedom";
    list.AddText(font, imgui::lineOf(*font), at(left + 12.0 * s, top + 6.0 * s), frame.theme.muted, title.c_str());
    const std::array<std::pair<Colour, const char *>, 3> entries{
        {{frame.theme.boundary, "free"}, {frame.theme.determined, "determined"}, {frame.theme.bad, "conflict"}}};
    double x = left + 12.0 * s;
    const double y = top + 40.0 * s;
    for (const auto &[colour, text] : entries) {
        const bool dashed = colour == frame.theme.bad;
        for (const double from : {0.0, 7.0}) { // two dashes, joined where the line is whole
            const double end = dashed ? from + 4.5 : 12.0;
            list.AddLine(at(x + from * s, y), at(x + end * s, y), colour, static_cast<float>(2.5 * s));
        }
        x += 16.0 * s;
        list.AddText(font, imgui::lineOf(*font), at(x, y - 8.0 * s), frame.theme.text, text);
        x += static_cast<double>(font->CalcTextSizeA(imgui::lineOf(*font), 1e9F, 0.0F, text).x) + 10.0 * s;
    }
    return true;
}

} // namespace

std::unique_ptr<Layer> makeSketchLayer() {
    return std::make_unique<SketchLayer>();
}

} // namespace forefront
