#include "core/drawing/constraints/constraint_drag.hpp"

#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/sketch/sketch_drag.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

class ConstraintDrag::State {
  public:
    State(std::shared_ptr<const Document> start, const std::set<NodeRef> &apart)
        : start_(std::move(start)), sketch_(sketchOf(*start_, *start_, {.places = start_.get(), .apart = apart})),
          drag_(standing()) {}

    Document carry(const Document &moved) {
        const std::vector<double> &start = sketch_.system.values;
        std::vector<SketchPull> pulls;
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
        release(pulls);
        drag_.pull(pulls); // if it fails, the values are those of the step before
        std::vector<double> solved = drag_.values();
        if (solved != start) {
            align(solved);
        }
        return sketch_.withValues(solved, moved);
    }

  private:
    /// Returns the sketch in which the segments that it lies on stand still, but for those that are pulled.
    SketchSystem standing() const {
        SketchSystem system = sketch_.system;
        for (const std::uint32_t unknown : sketch_.standing) {
            system.held[unknown] = system.held[unknown] || !released_.contains(unknown);
        }
        return system;
    }

    /// Makes joints exact, where they have moved.
    void align(std::vector<double> &values) const {
        const SketchSystem &system = sketch_.system;
        std::vector<std::uint32_t> moved;
        for (std::uint32_t k = 0; k < system.equations.size(); ++k) {
            const auto used = system.equations[k].used();
            if (std::any_of(used.begin(), used.end(), [&](std::uint32_t u) { return values[u] != system.values[u]; })) {
                moved.push_back(k);
            }
        }
        alignJoints(sketch_, moved, values, [](std::uint32_t) { return 1; });
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
    DocumentSketch sketch_;
    std::set<std::uint32_t> released_; ///< unknowns of `standing` that were pulled
    SketchDrag drag_;
};

ConstraintDrag::ConstraintDrag(std::shared_ptr<const Document> start, const std::set<NodeRef> &apart)
    : state_(std::make_unique<State>(std::move(start), apart)) {}
ConstraintDrag::~ConstraintDrag() = default;
ConstraintDrag::ConstraintDrag(ConstraintDrag &&) noexcept = default;
ConstraintDrag &ConstraintDrag::operator=(ConstraintDrag &&) noexcept = default;

Document ConstraintDrag::carry(const Document &moved) {
    return state_->carry(moved);
}

} // namespace forefront
