#include "core/drawing/constraints/constraint_drag.hpp"

#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/document/shape.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/sketch/sketch_drag.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

class ConstraintDrag::State {
  public:
    State(std::shared_ptr<const Document> start, const std::set<NodeRef> &apart, std::set<NodeRef> grabbed)
        : start_(std::move(start)), grabbed_(std::move(grabbed)),
          sketch_(sketchOf(*start_, *start_, {.places = start_.get(), .apart = apart})), drag_(standing()) {}

    Document carry(const Document &moved) {
        const std::vector<double> &start = sketch_.system.values;
        const std::vector<SketchPull> pulls = pullsTo(moved);
        release(pulls);
        drag_.pull(pulls); // if it fails, the values are those of the step before
        std::vector<double> solved = drag_.values();
        if (solved != start) {
            align(solved, pulls);
        }
        return sketch_.withValues(solved, moved);
    }

  private:
    /// Returns the numbers of what has moved. Both coordinates of a node are pulled where one has changed: that which
    /// has not is where the pointer is, too.
    std::vector<SketchPull> pullsTo(const Document &moved) const {
        std::set<NodeRef> nodes;
        std::vector<std::pair<ShapeUnknown, SketchPull>> places;
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            const Shape *const old = findShape(*start_, unknown.shape), *const now = findShape(moved, unknown.shape);
            const std::optional<double> place =
                now != nullptr && now != old ? valueOf(*now, unknown.role, unknown.index) : std::nullopt;
            if (place && !sketch_.system.held[index]) {
                places.push_back({unknown, {index, *place, isGrabbed(unknown)}});
                if (*place != sketch_.system.values[index] && isOfNode(*old, unknown)) {
                    nodes.insert({unknown.shape, unknown.index});
                }
            }
        }
        std::vector<SketchPull> pulls;
        for (const auto &[unknown, pull] : places) {
            const bool ofNode = isOfNode(*findShape(*start_, unknown.shape), unknown);
            if (ofNode ? nodes.contains({unknown.shape, unknown.index})
                       : pull.value != sketch_.system.values[pull.unknown]) {
                pulls.push_back(pull);
            }
        }
        return pulls;
    }

    /// Returns true if an unknown is a coordinate of a node. Those of a rectangle belong to its sides.
    static bool isOfNode(const Shape &shape, const ShapeUnknown &unknown) {
        return unknown.role <= ShapeUnknown::Role::Y && !shape.is<RectangleForm>();
    }

    bool isGrabbed(const ShapeUnknown &unknown) const {
        const Shape *const shape = findShape(*start_, unknown.shape);
        const NodeRef first{unknown.shape, isOfNode(*shape, unknown) ? unknown.index : 0};
        const auto found = grabbed_.lower_bound(first);
        return grabbed_.empty() ||
               (found != grabbed_.end() && (isOfNode(*shape, unknown) ? *found == first : found->shape == first.shape));
    }

    /// Returns the sketch in which the segments that it lies on stand still, but for those that are pulled.
    SketchSystem standing() const {
        SketchSystem system = sketch_.system;
        for (const std::uint32_t unknown : sketch_.standing) {
            system.held[unknown] = system.held[unknown] || !released_.contains(unknown);
        }
        return system;
    }

    /// Makes joints exact, where they have moved. What is right where it was pulled to leads.
    void align(std::vector<double> &values, const std::vector<SketchPull> &pulls) const {
        const SketchSystem &system = sketch_.system;
        std::vector<std::uint32_t> moved;
        for (std::uint32_t k = 0; k < system.equations.size(); ++k) {
            const auto used = system.equations[k].used();
            if (std::any_of(used.begin(), used.end(), [&](std::uint32_t u) { return values[u] != system.values[u]; })) {
                moved.push_back(k);
            }
        }
        std::set<std::uint32_t> reached;
        for (const SketchPull &pull : pulls) {
            if (values[pull.unknown] == pull.value) {
                reached.insert(pull.unknown);
            }
        }
        alignJoints(sketch_, moved, values, [&](std::uint32_t unknown) { return reached.contains(unknown) ? 1 : 2; });
    }

    /// Lets segments move that stood still and are pulled themselves.
    void release(const std::vector<SketchPull> &pulls) {
        const std::size_t before = released_.size();
        for (const SketchPull &pull : pulls) {
            if (std::find(sketch_.standing.begin(), sketch_.standing.end(), pull.unknown) != sketch_.standing.end()) {
                released_.insert(pull.unknown);
            }
        }
        if (released_.size() > before) {
            drag_ = SketchDrag(standing());
        }
    }

    std::shared_ptr<const Document> start_;
    std::set<NodeRef> grabbed_;
    DocumentSketch sketch_;
    std::set<std::uint32_t> released_; ///< unknowns of `standing` that were pulled
    SketchDrag drag_;
};

ConstraintDrag::ConstraintDrag(std::shared_ptr<const Document> start, const std::set<NodeRef> &apart,
                               std::set<NodeRef> grabbed)
    : state_(std::make_unique<State>(std::move(start), apart, std::move(grabbed))) {}
ConstraintDrag::~ConstraintDrag() = default;
ConstraintDrag::ConstraintDrag(ConstraintDrag &&) noexcept = default;
ConstraintDrag &ConstraintDrag::operator=(ConstraintDrag &&) noexcept = default;

Document ConstraintDrag::carry(const Document &moved) {
    return state_->carry(moved);
}

} // namespace forefront
