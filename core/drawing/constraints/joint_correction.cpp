#include "core/drawing/constraints/joint_correction.hpp"

#include "core/drawing/constraints/document_sketch.hpp"
#include "core/drawing/constraints/firm_numbers.hpp"
#include "core/drawing/constraints/moved_parts.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using Role = ShapeUnknown::Role;

/// Returns the shape whose handles are where those of a moved one began, with the indices of the moved one.
std::shared_ptr<const Shape> atStart(const std::shared_ptr<const Shape> &before,
                                     const std::shared_ptr<const Shape> &after) {
    if (before == after) {
        return before;
    }
    const bool turned = before->is<RectangleForm>() && isPath(*after); // becomes a path with the same corners
    const bool same = before->form.index() == after->form.index() || turned;
    if (!same || handleCount(*before) != handleCount(*after) || hasReorderedHandles(*before, *after)) {
        return after;
    }
    if (!turned) {
        return before;
    }
    Shape path = *after;
    moveNodes(path, handlesOf(*before));
    return std::make_shared<const Shape>(std::move(path));
}

/// Moves a node of a path or point to where it is in another document.
void placeAsIn(const Document &document, NodeRef node, Document &next) {
    const Vec2 at = findShape(document, node.shape)->nodes[node.node];
    std::shared_ptr<const Shape> &place = next.shapes[positionOf(next, node.shape)];
    Shape shape = *place;
    std::vector<Vec2> nodes = shape.nodes;
    nodes[node.node] = at;
    isPath(shape) ? moveNodes(shape, std::move(nodes)) : placeHandle(shape, node.node, at);
    place = std::make_shared<const Shape>(std::move(shape));
}

} // namespace

/// The joints of what moves, in the drawing where it began.
class MovedJoints {
  public:
    /// `start`: without constraints and formulas, which have their own solution.
    MovedJoints(Document start, std::vector<SketchPart> moved)
        : start_(std::move(start)),
          moved_(std::move(moved)), source_{.places = &start_, .moved = {moved_.begin(), moved_.end()}},
          sketch_(start_), scale_(drawingScale(start_)) {
        sketch_.finish(source_);
        for (const SketchEquation &equation : sketch_.system.equations) {
            gaps_.push_back(std::fabs(sketch_.system.residual(equation)));
        }
    }
    MovedJoints(const MovedJoints &) = delete;
    MovedJoints &operator=(const MovedJoints &) = delete;

    const std::vector<SketchPart> &moved() const { return moved_; }

    Result<Document> correct(Document moved, const std::set<NodeRef> &given) const {
        SketchSystem system = sketch_.system;
        system.values = valuesIn(moved);
        const std::vector<std::uint32_t> open = openJoints(system);
        if (open.empty()) {
            return moved;
        }
        const std::optional<SketchSolution> solution = solve(system, given);
        if (!solution) {
            return conflict(open.front());
        }
        return sketch_.withValues(aligned(solution->values), std::move(moved));
    }

  private:
    std::vector<double> valuesIn(const Document &document) const {
        std::vector<double> values = sketch_.system.values;
        const Shape *shape = nullptr;
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            shape = shape != nullptr && shape->id == unknown.shape ? shape : findShape(document, unknown.shape);
            values[index] =
                shape != nullptr ? valueOf(*shape, unknown.role, unknown.index).value_or(values[index]) : values[index];
        }
        return values;
    }

    /// Returns the equations that hold less well than at the start.
    std::vector<std::uint32_t> openJoints(const SketchSystem &system) const {
        constexpr double kRounding = 1e-14;
        std::vector<std::uint32_t> open;
        for (std::uint32_t k = 0; k < system.equations.size(); ++k) {
            if (std::fabs(system.residual(system.equations[k])) > gaps_[k] + kRounding * scale_) {
                open.push_back(k);
            }
        }
        return open;
    }

    std::optional<SketchSolution> solve(const SketchSystem &system, const std::set<NodeRef> &given) const {
        FirmNumbers numbers{std::vector<bool>(system.values.size(), false), sketch_.isStanding()};
        std::vector<bool> placed = numbers.firm;
        for (const NodeRef node : given) {
            place(node, placed);
        }
        auto next = given.begin();
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            while (next != given.end() && next->shape < unknown.shape) {
                ++next;
            }
            numbers.firm[index] = next != given.end() && next->shape == unknown.shape;
        }
        const SystemSolver plain = [](const SketchSystem &some) { return solveSketch(some, SolveEffort::Plain); };
        if (std::optional<SketchSolution> solution = solveAroundFirm(system, numbers, plain)) {
            return solution;
        }
        SketchSystem held = system;
        for (std::size_t k = 0; k < placed.size(); ++k) {
            held.held[k] = held.held[k] || placed[k];
        }
        return solveSketch(held, SolveEffort::Full);
    }

    /// Marks the numbers that place a handle.
    void place(NodeRef node, std::vector<bool> &placed) const {
        const Shape *const shape = findShape(start_, node.shape);
        const bool rectangle = shape != nullptr && shape->is<RectangleForm>();
        const std::uint32_t x = rectangle ? (node.node == 1 || node.node == 2 ? 1 : 0) : node.node;
        const std::uint32_t y = rectangle ? (node.node >= 2 ? 1 : 0) : node.node;
        for (const ShapeUnknown &unknown : {ShapeUnknown{node.shape, Role::X, x}, {node.shape, Role::Y, y}}) {
            if (const auto index = sketch_.find(unknown)) {
                placed[*index] = true;
            }
        }
    }

    /// Gives numbers that are equal the same bits.
    std::vector<double> aligned(std::vector<double> values) const {
        std::vector<std::uint32_t> all(sketch_.system.equations.size());
        for (std::uint32_t k = 0; k < all.size(); ++k) {
            all[k] = k;
        }
        const std::vector<double> solved = values;
        alignJoints(sketch_, all, values,
                    [&](std::uint32_t unknown) { return solved[unknown] == sketch_.system.values[unknown] ? 1 : 2; });
        return values;
    }

    Diagnostics conflict(std::uint32_t equation) const {
        const SketchJoint &joint = sketch_.joints[std::min<std::size_t>(
            sketch_.system.equations[equation].constraint - sketch_.jointId(0), sketch_.joints.size() - 1)];
        const Shape &first = *findShape(start_, joint.node.shape), &second = *findShape(start_, joint.other.shape);
        const bool upright = first.is<RectangleForm>() || second.is<RectangleForm>();
        return error("joint-conflict",
                     displayName(first) + " and " + displayName(second) + " would come apart at " + placeText(joint.at),
                     upright ? "convert the rectangle to a path, or drag with Alt to detach the node"
                             : "drag with Alt to detach the node, or unlock what cannot follow");
    }

    const Document start_;
    const std::vector<SketchPart> moved_;
    const JointSource source_;
    DocumentSketch sketch_;
    double scale_;
    std::vector<double> gaps_; ///< of the equations, at the start
};

class JointCorrection::State {
  public:
    explicit State(std::shared_ptr<const Document> start) : start_(std::move(start)) {}

    Result<Document> correct(Document moved, const std::set<NodeRef> &given, const std::set<NodeRef> &apart) {
        std::optional<Document> start; // only if it differs from that of the drag
        Document changed;              // the moved shapes alone: others cost time in large drawings
        for (std::size_t s = 0; s < moved.shapes.size(); ++s) {
            const std::shared_ptr<const Shape> &now = moved.shapes[s];
            const std::size_t at = positionLike(s, *now);
            if (at < start_->shapes.size() && start_->shapes[at] == now) {
                continue;
            }
            changed.shapes.push_back(now);
            const bool isNew = at == start_->shapes.size();
            if (isNew || at != s || atStart(start_->shapes[at], now) != start_->shapes[at]) {
                start = start ? std::move(start) : std::optional(startOf(moved));
            }
        }
        if (moved.shapes.size() != start_->shapes.size() || !apart.empty()) {
            start = start ? std::move(start) : std::optional(startOf(moved));
        }
        for (const NodeRef node : apart) {
            placeAsIn(moved, node, *start);
        }
        const std::vector<SketchPart> parts = movedParts(start ? *start : *start_, changed);
        if (parts.empty()) {
            return moved;
        }
        if (start || !isPlain_ || ofDrag_->moved() != parts) {
            isPlain_ = !start;
            ofDrag_ = std::make_unique<const MovedJoints>(start ? *std::move(start) : startOf(moved), parts);
        }
        return ofDrag_->correct(std::move(moved), given);
    }

  private:
    /// Returns the position at the start of a shape that is now at a position.
    std::size_t positionLike(std::size_t now, const Shape &shape) const {
        const auto &shapes = start_->shapes;
        return now < shapes.size() && (shapes[now].get() == &shape || shapes[now]->id == shape.id)
                   ? now
                   : positionOf(*start_, shape.id);
    }

    /// Returns the shapes of a document where they were at the start, without constraints and formulas.
    Document startOf(const Document &moved) const {
        Document start = moved;
        start.constraints.clear();
        start.formulas.clear();
        for (std::size_t s = 0; s < start.shapes.size(); ++s) {
            const std::size_t at = positionLike(s, *start.shapes[s]);
            start.shapes[s] =
                at < start_->shapes.size() ? atStart(start_->shapes[at], start.shapes[s]) : start.shapes[s];
        }
        return start;
    }

    std::shared_ptr<const Document> start_;
    std::unique_ptr<const MovedJoints> ofDrag_; ///< of the last step
    bool isPlain_ = false;                      ///< they are those of the drawing at the start itself
};

JointCorrection::JointCorrection(std::shared_ptr<const Document> start)
    : state_(std::make_unique<State>(std::move(start))) {}
JointCorrection::~JointCorrection() = default;
JointCorrection::JointCorrection(JointCorrection &&) noexcept = default;
JointCorrection &JointCorrection::operator=(JointCorrection &&) noexcept = default;

Result<Document> JointCorrection::correct(Document moved, const std::set<NodeRef> &given,
                                          const std::set<NodeRef> &apart) {
    return state_->correct(std::move(moved), given, apart);
}

} // namespace forefront
