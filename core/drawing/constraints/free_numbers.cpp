#include "core/drawing/constraints/free_numbers.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace forefront {
namespace {

using Role = ShapeUnknown::Role;

/// Returns true for a number that holds an unknown of a shape if it has a formula.
bool holdsGeometry(Quantity quantity) {
    switch (quantity) {
    case Quantity::ArcRadius:
    case Quantity::Bottom:
    case Quantity::Height:
    case Quantity::Left:
    case Quantity::Length:
    case Quantity::Radius:
    case Quantity::Rx:
    case Quantity::Ry:
    case Quantity::Width:
    case Quantity::X:
    case Quantity::Y:
        return true;
    default:
        return false;
    }
}

/// Counts the free numbers of shapes that a sketch does not have.
class FreeNumbers {
  public:
    FreeNumbers(const DocumentSketch &sketch, const Document &document) : sketch_(sketch) {
        for (const auto &[unknown, index] : sketch.unknowns()) { // in the order of shapes
            if (reached_.empty() || reached_.back() != unknown.shape) {
                reached_.push_back(unknown.shape);
            }
        }
        for (const auto &[address, text] : document.formulas) {
            if (address.owner.kind == NumberOwner::Kind::Shape && holdsGeometry(address.quantity)) {
                ++formulas_[address.owner.id];
            }
        }
    }

    void add(const Shape &shape) {
        if (shape.locked) {
            return;
        }
        isReached_ = std::binary_search(reached_.begin(), reached_.end(), shape.id);
        shape_ = &shape;
        count_ = 0;
        countNodes();
        shape.visit([&](const PathForm &path) { countCurves(path); },
                    [&](const RectangleForm &form) { count(Role::Radius, 0, form.radius > 0.0 ? 1 : 0); },
                    [&](const CircleForm &) { count(Role::Radius, 0); }, [](const PointForm &) {},
                    [&](const EllipseForm &) { count(Role::AxisX, 1, hasRightAngle() ? 3 : 4); },
                    [&](const SlotForm &) { count(Role::Radius, 0); });
        const auto held = formulas_.find(shape.id);
        // The sketch knows which numbers of the shapes that it has are held.
        total_ += held != formulas_.end() && !isReached_ ? count_ - std::min(count_, held->second) : count_;
    }

    /// Returns the count. Nodes at the same place move together: each counts for the first shape there.
    std::size_t total() {
        std::sort(places_.begin(), places_.end(), [](const Place &a, const Place &b) {
            return std::tie(a.at.x, a.at.y, a.shape) < std::tie(b.at.x, b.at.y, b.shape);
        });
        std::size_t joined = 0;
        for (std::size_t k = 1; k < places_.size(); ++k) {
            joined += places_[k].at == places_[k - 1].at && places_[k].shape != places_[k - 1].shape ? 2 : 0;
        }
        return total_ - std::min(total_, joined);
    }

  private:
    struct Place {
        Vec2 at;
        std::uint32_t shape = 0;
    };

    void count(Role role, std::uint32_t index, std::size_t numbers = 1) {
        count_ += isReached_ && sketch_.find({shape_->id, role, index}) ? 0 : numbers;
    }

    void countNodes() {
        // The points on a circle and at the ends of semi-axes follow from other numbers.
        const bool onlyCentre = shape_->is<CircleForm>() || shape_->is<EllipseForm>();
        const auto nodes = static_cast<std::uint32_t>(onlyCentre ? 1 : shape_->nodes.size());
        for (std::uint32_t k = 0; k < nodes; ++k) {
            const std::size_t before = count_;
            count(Role::X, k);
            count(Role::Y, k);
            if (count_ == before + 2 && !formulas_.contains(shape_->id) &&
                (isPath(*shape_) || shape_->is<PointForm>())) {
                places_.push_back({shape_->nodes[k], shape_->id});
            }
        }
    }

    void countCurves(const PathForm &path) {
        for (std::uint32_t k = 0; k < path.curves.size(); ++k) {
            if (path.curves[k].kind() == CurveKind::Cubic) {
                count(Role::StartX, k, 4);
            } else if (path.curves[k].kind() == CurveKind::Arc && radiusOf(path.curves[k])) {
                count(Role::Radius, k); // its centre follows from its ends
            }
        }
    }

    /// Returns true if the axes of an ellipse are to stay at right angles: see DocumentSketch::ellipse().
    bool hasRightAngle() const {
        constexpr double kPerpendicular = 1e-9;
        const Vec2 u = shape_->nodes[1] - shape_->nodes[0], v = shape_->nodes[2] - shape_->nodes[0];
        return std::fabs(dot(u, v)) <= kPerpendicular * length(u) * length(v);
    }

    const DocumentSketch &sketch_;
    std::vector<std::uint32_t> reached_;                      ///< shapes of which the sketch has some unknown, in order
    std::unordered_map<std::uint32_t, std::size_t> formulas_; ///< numbers of formulas, by shape
    const Shape *shape_ = nullptr;
    bool isReached_ = false;
    std::size_t count_ = 0, total_ = 0;
    std::vector<Place> places_;
};

} // namespace

std::size_t freeNumbersBeside(const DocumentSketch &sketch, const Document &document) {
    FreeNumbers numbers(sketch, document);
    for (const std::shared_ptr<const Shape> &shape : document.shapes) {
        numbers.add(*shape);
    }
    return numbers.total();
}

} // namespace forefront
