#include "core/drawing/constraints/constraint_drag.hpp"

#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/sketch/sketch_drag.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {

class ConstraintDrag::State {
  public:
    explicit State(std::shared_ptr<const Document> start)
        : start_(std::move(start)), sketch_(sketchOf(*start_, *start_)), drag_(sketch_.system) {}

    Document carry(const Document &moved) {
        const std::vector<double> &start = sketch_.system.values;
        std::vector<SketchPull> pulls;
        std::map<ShapeUnknown, double> places;
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            const Shape *const old = findShape(*start_, unknown.shape), *const now = findShape(moved, unknown.shape);
            if (now == nullptr || now == old) {
                continue;
            }
            const std::optional<double> place = valueOf(*now, unknown.role, unknown.index);
            if (place && *place != start[index] && !sketch_.system.held[index]) {
                pulls.push_back({index, *place});
            }
        }
        drag_.pull(pulls); // if it fails, the values are those of the step before
        std::map<std::uint32_t, std::map<ShapeUnknown, double>> changes;
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            changes[unknown.shape].emplace(unknown, drag_.values()[index]);
        }
        Document next = moved;
        for (const auto &[id, values] : changes) {
            const std::size_t at = positionOf(next, id);
            if (at < next.shapes.size() && differs(*next.shapes[at], values)) {
                Shape shape = *next.shapes[at];
                setUnknowns(shape, values);
                next.shapes[at] = std::make_shared<const Shape>(std::move(shape));
            }
        }
        return next;
    }

  private:
    static bool differs(const Shape &shape, const std::map<ShapeUnknown, double> &values) {
        for (const auto &[unknown, value] : values) {
            if (valueOf(shape, unknown.role, unknown.index) != value) {
                return true;
            }
        }
        return false;
    }

    std::shared_ptr<const Document> start_;
    DocumentSketch sketch_;
    SketchDrag drag_;
};

ConstraintDrag::ConstraintDrag(std::shared_ptr<const Document> start)
    : state_(std::make_unique<State>(std::move(start))) {}
ConstraintDrag::~ConstraintDrag() = default;
ConstraintDrag::ConstraintDrag(ConstraintDrag &&) noexcept = default;
ConstraintDrag &ConstraintDrag::operator=(ConstraintDrag &&) noexcept = default;

Document ConstraintDrag::carry(const Document &moved) {
    return state_->carry(moved);
}

} // namespace forefront
