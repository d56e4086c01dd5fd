#pragma once

#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/constraints/constraint_drag.hpp"
#include "ui/parts/guide_drag.hpp"
#include "ui/parts/naming.hpp"
#include "ui/parts/tool.hpp"
#include "ui/tools/common/numeric_entry.hpp"
#include "ui/tools/select/transform_handles.hpp"
#include "ui/workspace/edit_state.hpp"

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {

/// Selects by click (groups as one, single shapes of them with Ctrl), box and, with Alt, lasso; drags nodes, control
/// points, segments, shapes, sources and markers; inserts a node by a double-click on a segment, renames by one on a
/// label; scales and rotates the selection with its handles.
class SelectTool final : public Tool {
  public:
    explicit SelectTool(std::shared_ptr<EditState> state) : state_(state), transform_(std::move(state)) {}

    const char *id() const override { return "select"; }
    const char *name() const override { return "Select and move"; }
    const char *icon() const override;
    int key() const override { return 'V'; }
    CursorShape cursor() const override;
    void deactivate(Shell &context) override;
    void forget(Shell &context) override { deactivate(context); }
    bool handle(const CanvasEvent &event, Shell &context) override;
    void reserveOverlay(CanvasPainter &painter, const Shell &context) override;
    void drawOverlay(CanvasPainter &painter, Shell &context) override;
    bool hasOptions(const Shell &) const override { return true; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    std::string statusText(const Shell &context) const override;

  private:
    enum class Mode : std::uint8_t { Idle, Grabbed, Moving, Transforming, Boxing, Labelling, Guiding };
    /// The item under the pointer; smaller items take precedence.
    struct Hit {
        enum class Kind : std::uint8_t {
            Nothing,
            Control,
            Constraint,
            Node,
            Source,
            Marker,
            Transform,
            Segment,
            Guide,
            Inside
        } kind = Kind::Nothing;
        TransformHandles::Handle transform;
        ControlRef control;
        NodeRef node;
        std::optional<SegmentHit> segment;
        PickIndex::SourceHit source;
        std::uint32_t marker = 0;
        std::size_t guide = 0;        ///< index into Document::guides
        std::uint32_t constraint = 0; ///< SketchConstraint::id
        std::uint32_t shape = kNoIndex;
        Vec2 at;
    };
    Hit hitAt(Vec2 place, Shell &context) const;
    /// Returns the region marker under the pointer, or whose label is there.
    std::optional<std::uint32_t> markerAt(Vec2 place, Shell &context) const;
    /// Returns the constraint whose glyph or value is under the pointer.
    std::optional<Hit> constraintAt(Vec2 place, Shell &context) const;
    /// Opens the field for the value of the dimension under a double-click. Returns false if there is none.
    bool editDimension(const CanvasEvent &event, Shell &context);
    /// Moves the text of the dimension that is dragged.
    void placeLabel(const CanvasEvent &event, Shell &context);
    /// Highlights the face of the region marker under the pointer.
    void pointAtFace(Shell &context) const;
    /// Returns the node near a place. Nodes of shapes that are not selected are not drawn, so they are found only right
    /// at the place.
    std::optional<NodeHit> nodeAt(Vec2 place, const PickIndex::Filter &pickable, Shell &context) const;
    /// Returns the control point of the selection under the pointer.
    std::optional<Control> controlAt(Vec2 place, Shell &context) const;
    bool isSelected(const Hit &hit, const Selection &selection) const;
    void select(const Hit &hit, bool adds, Selection &selection) const;
    /// Selects a shape with its group, or alone if Ctrl was down at the press; with `adds`, adds or removes them.
    void selectShape(std::uint32_t shape, bool adds, Selection &selection) const;
    void press(const CanvasEvent &event, Shell &context);
    bool pressLabel(const CanvasEvent &event, Shell &context);
    void openMenu(const CanvasEvent &event, Shell &context);
    void drag(const CanvasEvent &event, Shell &context);
    void beginMove(Shell &context);
    /// Moves the selection to where the pointer or the typed numbers say.
    void updateMove(Shell &context);
    /// Adds the relations that the dragged node has snapped to, if they are to become constraints.
    void addRelations(Shell &context);
    /// Joins what was dragged by a node to the segments on which its nodes now lie, as drawing does.
    void joinMoved(Shell &context);
    /// Says what holds the numbers that were typed for a move, where what was moved is not as typed.
    void tellWhereHeld(Shell &context) const;
    /// Handles numbers typed during a drag. Returns true if the event was used.
    bool typedMove(const CanvasEvent &event, Shell &context);
    void release(const CanvasEvent &event, Shell &context);
    /// Selects what is inside the box or the lasso.
    void selectInside(Vec2 end, Shell &context);
    bool key(const CanvasEvent &event, Shell &context);
    void insertAt(const Hit &hit, Shell &context);
    void nudge(Vec2 direction, bool far, bool repeated, Shell &context);
    Result<Document> moved(Vec2 to) const;
    /// Drops what was kept for a drag.
    void endDrag();
    /// Applies the constraints of the document where the drag began to a step of it.
    Document constrained(const Document &moved);
    /// Where constraints hold the dragged node elsewhere than the pointer has it, shows that place instead of the snap
    /// target, and what holds a node that does not move at all.
    void showWhereHeld(const Document &wanted, const Document &held);
    std::string moveLabel() const;
    void drawHandles(CanvasPainter &painter, Shell &context) const;
    /// Returns for each handle of a shape whether it is marked as joined; those after the list are not.
    const std::vector<bool> &jointMarks(std::uint32_t shape, Shell &context) const;
    /// Returns the joints of the current document; finds them again if the document has changed.
    const std::shared_ptr<const Joints> &joints(const Shell &context) const;
    void drawFilter(Shell &context);
    void drawControls(CanvasPainter &painter, Shell &context) const;
    void drawSourceHandles(CanvasPainter &painter, Shell &context) const;

    std::shared_ptr<EditState> state_;
    std::optional<NamedThing> pressedLabel_; ///< under the last press
    Mode mode_ = Mode::Idle;
    Hit hover_, grabbed_;
    bool over_ = false;
    bool wasSelected_ = false; ///< the pressed item was already selected
    bool adds_ = false;        ///< Shift was down
    bool single_ = false;      ///< a shape is selected without its group: a click with Ctrl
    bool pressedControl_ = false;
    Selection selectedBefore_; ///< at the press
    bool alone_ = false;       ///< Alt is down: nodes leave their joints, a control point moves without its opposite
    std::uint32_t clicked_ = kNoIndex; ///< shape under the last click that did not move anything
    Pixel pressPixel_{};
    Vec2 pressPlace_, boxPlace_;
    std::vector<Vec2> lasso_; ///< the places of a drag with Alt, which selects inside them; empty: a box does
    CanvasEvent last_;        ///< of the drag
    NumericEntry entry_;
    Snapped snapped_;
    Vec2 asked_; ///< place that the pointer or the typed numbers ask for, which constraints may not allow
    std::shared_ptr<const Document> start_; ///< document when the drag began
    std::shared_ptr<const PickIndex> startIndex_;
    std::shared_ptr<const Joints> startJoints_; ///< of start_, set while Moving
    /// Constraints of start_, made when first needed while Moving: with joints, and without those of what is dragged.
    std::optional<ConstraintDrag> startConstraints_, aloneConstraints_;
    Selection moving_;
    PickIndex::Filter targets_;      ///< of moving_ and what is joined with it
    PickIndex::Filter aloneTargets_; ///< of moving_ alone
    std::vector<Vec2> linesTo_;      ///< see linesToNode()
    std::string stroke_, nudgeStroke_;
    std::optional<std::string> heldBy_;                        ///< what holds the dragged node, once it was asked for
    std::string fault_;                                        ///< why what is dragged cannot go where the pointer is
    mutable std::map<std::uint32_t, std::vector<bool>> marks_; ///< by shape, of marked_
    mutable std::shared_ptr<const Joints> marked_, joints_;
    TransformHandles transform_;
    GuideDrag guide_;
};

} // namespace forefront
