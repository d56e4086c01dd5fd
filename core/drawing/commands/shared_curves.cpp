#include "core/drawing/commands/shared_curves.hpp"

#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns the control points of a Bézier segment.
std::array<Vec2, 2> controlsOf(const Curve &curve) {
    const std::array<double, 8> n = curve.numbers();
    return {Vec2{n[2], n[3]}, Vec2{n[4], n[5]}};
}

std::array<Vec2, 2> turned(const std::array<Vec2, 2> &controls) {
    return {controls[1], controls[0]};
}

bool hasCurve(const Shape &shape, std::size_t k) {
    return isPath(shape) && k < shape.path().curves.size() && shape.path().curves[k].kind() == CurveKind::Cubic;
}

/// Bends what lies on bent segments.
class SharedCurves {
  public:
    SharedCurves(const JointIndex &index, Document after)
        : index_(index), before_(index.document()), document_(std::move(after)) {}

    Result<Document> run() {
        for (std::size_t s = 0; s < document_.shapes.size(); ++s) {
            const std::shared_ptr<const Shape> shape = document_.shapes[s];
            const bool same = s < before_.shapes.size() && before_.shapes[s] == shape;
            const Shape *const old = same || !isPath(*shape) ? nullptr : findShape(before_, shape->id);
            if (old == nullptr || !isPath(*old) || old->nodes != shape->nodes) {
                continue;
            }
            for (std::uint32_t k = 0; k < shape->path().curves.size(); ++k) {
                const bool bent =
                    hasCurve(*old, k) && hasCurve(*shape, k) && old->path().curves[k] != shape->path().curves[k];
                if (Status status = bent ? bendOthers(*old, *shape, k) : Status(); !status.empty()) {
                    return status;
                }
            }
        }
        return std::move(document_);
    }

  private:
    bool same(Vec2 a, Vec2 b) const { return distance(a, b) <= index_.tolerance(); }

    /// Bends segments of other shapes that lay on segment k.
    Status bendOthers(const Shape &old, const Shape &shape, std::uint32_t k) {
        std::vector<SegmentRef> found;
        index_.handlesAt(old.nodes[k], [&](const JointHandle &handle) {
            const Shape &other = *before_.shapes[handle.shape];
            const auto count = static_cast<std::uint32_t>(other.nodes.size());
            for (const std::uint32_t segment : {handle.handle, handle.handle == 0 ? count - 1 : handle.handle - 1}) {
                if (other.id != old.id && hasCurve(other, segment)) {
                    found.push_back({other.id, segment});
                }
            }
        });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        for (const SegmentRef segment : found) {
            if (Status status = bend(segment, old, shape, k); !status.empty()) {
                return status;
            }
        }
        return {};
    }

    /// Bends a segment, if it lay on segment k of another shape and its ends have stayed.
    Status bend(SegmentRef segment, const Shape &old, const Shape &shape, std::uint32_t k) {
        const Shape &then = *findShape(before_, segment.shape);
        const std::size_t at = positionOf(document_, segment.shape);
        if (at == document_.shapes.size() || !isPath(*document_.shapes[at]) ||
            document_.shapes[at]->nodes != then.nodes) {
            return {};
        }
        const std::size_t count = then.nodes.size(), end = (k + 1U) % old.nodes.size();
        const Vec2 a = then.nodes[segment.segment], b = then.nodes[(segment.segment + 1) % count];
        const bool along = same(a, old.nodes[k]) && same(b, old.nodes[end]);
        const bool against = same(b, old.nodes[k]) && same(a, old.nodes[end]);
        const std::array<Vec2, 2> was = controlsOf(old.path().curves[k]),
                                  its = controlsOf(then.path().curves[segment.segment]);
        const std::array<Vec2, 2> expected = along ? was : turned(was);
        if ((!along && !against) || !same(expected[0], its[0]) || !same(expected[1], its[1])) {
            return {};
        }
        const std::array<Vec2, 2> now = controlsOf(shape.path().curves[k]), controls = along ? now : turned(now);
        Shape bent = *document_.shapes[at];
        Curve &curve = bent.path().curves[segment.segment];
        const Curve next = Curve::cubic(a, controls[0], controls[1], b);
        if (curve == next) {
            return {};
        }
        if (bent.locked) {
            return error("joined-locked",
                         displayName(bent) + " is locked and has the same curve at " + placeText(curve.point(0.5)),
                         "unlock it, or drag with Alt to detach the curve from it");
        }
        curve = next;
        if (segment.segment < bent.cuts.size()) {
            bent.cuts[segment.segment].clear();
        }
        document_.shapes[at] = std::make_shared<const Shape>(std::move(bent));
        return {};
    }

    const JointIndex &index_;
    const Document &before_;
    Document document_;
};

} // namespace

Result<Document> bendSharedCurves(const JointIndex &index, Document after) {
    return SharedCurves(index, std::move(after)).run();
}

} // namespace forefront
