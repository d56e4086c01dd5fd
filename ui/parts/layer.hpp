#pragma once

#include "core/engine/session/snapshot.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/canvas/picture.hpp"
#include "ui/platform/platform.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/theme.hpp"
#include "ui/workspace/document/document_examiner.hpp"
#include "ui/workspace/judging.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace forefront {

class CanvasPainter;
class GlKit;
class NearFront;
struct Document;
struct DrawSlice;
struct Judgement;
struct LayerSlot;
struct Selection;

/// The data that layers draw, valid for one frame.
struct LayerFrame {
    const Camera &camera;
    const Theme &theme;
    const Fonts &fonts;
    double scale;     ///< pixels per design pixel
    double roomScale; ///< the same where the room for labels is measured, which a presentation does not make scarcer
    double gridStep;  ///< see Snapping
    const SessionSnapshot &snapshot;
    const Breakpoints &breakpoints;
    const Document &document;
    const Domain &domain;   ///< of the document as drawn
    std::uint64_t revision; ///< of the document
    const DocumentPreview &preview;
    std::shared_ptr<const SpacingRaster> raster;
    std::shared_ptr<const LayerPlan> layerPlan; ///< of the document or, until it is found, of an earlier revision
    const Selection &selection;
    std::optional<Vec2> pointer;          ///< place under the pointer while it is over the canvas
    std::set<std::uint32_t> blamed;       ///< ids of the constraints that the refusal of the last act names
    std::optional<Vec2> facePlace;        ///< in the face that the tool points at
    std::optional<std::size_t> candidate; ///< chosen in the table of the explained advance
    const Judgement &judgement;           ///< of the mesh shown now or a moment ago
    std::optional<int> isolatedBin;
    ColourRange measureRange;    ///< of the colours of the chosen measure
    ColourMap measureMap;        ///< ... and their map
    MeasureBounds measureBounds; ///< beyond which values are bad
    bool outOfDate;
    double fresh;                                ///< of the elements of this step: 1 when they appear, 0 from 250 ms on
    std::shared_ptr<const MeshSnapshot> gliding; ///< the mesh on its way to that of the snapshot; null: it is there
    std::shared_ptr<const Picture> picture;      ///< of the document; null: none, or it is not there
    bool pictureFailed;                          ///< the document has a picture that cannot be read
    const std::vector<LayerSlot> &layers;
    GlKit &gl;                  ///< shared shaders and buffers
    NearFront &nearFront;       ///< of the explained advance, shared by its labels
    DrawSlice *slice = nullptr; ///< the part of a large mesh that drawStill() draws; null: all

    bool visible(std::string_view id) const;
    /// Returns a colour for areas: translucent where it would hide a background picture.
    Colour area(Colour colour) const;
};

/// A layer of the canvas. To add one, write its file, add a line to makeLayers(), and list it in the presets of the
/// workspaces that show it. Layers are drawn in the order of
/// makeLayers(): first the still parts of all (see drawStill()), then their live parts, then their overlays.
class Layer {
  public:
    virtual ~Layer() = default;
    /// Returns the stable name of the layer; its switch is the widget "layer/ID".
    virtual const char *id() const = 0;
    virtual const char *name() const = 0;
    /// Returns true if the layer colours the domain or its elements by a value. At most one such layer is visible at a
    /// time, so that colours never mix and always match the legend.
    virtual bool coloursByValue() const { return false; }
    /// Requests the parts of the snapshot that the layer needs while it is visible.
    virtual void request(SnapshotLayers &) const {}

    /// Returns the version of the still part, which is cached in a texture and redrawn only when the camera, the theme
    /// or this number changes.
    virtual std::uint64_t stillVersion(const LayerFrame &) const { return 0; }
    virtual void drawStill(const LayerFrame &) {}
    /// Returns the version of the still part without its style. A picture that takes several frames begins again when
    /// it changes; other changes wait for the next picture, or dragging a slider could keep it from being completed.
    virtual std::uint64_t stillShape(const LayerFrame &frame) const { return stillVersion(frame); }
    /// Returns the number of elements that drawStill() draws. If there are many, a picture of them stands in while the
    /// camera moves.
    virtual std::size_t stillElements(const LayerFrame &) const { return 0; }
    /// Draws with OpenGL in every frame, over all still parts.
    virtual void drawLive(const LayerFrame &) {}
    /// Draws a few lines and texts over everything drawn with OpenGL.
    virtual void drawOverlay(CanvasPainter &, const LayerFrame &) {}
    /// Returns true if the layer can have a legend in the lower right corner of the canvas.
    virtual bool hasLegend() const { return false; }
    /// Draws the legend with its lower right corner at `corner` (pixels). Returns false if there is nothing to explain.
    virtual bool drawLegend(CanvasPainter &, const LayerFrame &, Pixel corner) {
        static_cast<void>(corner);
        return false;
    }
};

struct LayerSlot {
    std::unique_ptr<Layer> layer;
    bool visible = true;
};

/// Shows or hides a layer. Showing one that colours by value hides the others that do.
void showLayer(std::vector<LayerSlot> &layers, std::string_view id, bool visible);
/// Returns true if a layer is there and visible.
bool showsLayer(const std::vector<LayerSlot> &layers, std::string_view id);

} // namespace forefront
