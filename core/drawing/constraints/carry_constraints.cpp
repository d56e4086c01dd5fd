#include "core/drawing/constraints/carry_constraints.hpp"

#include "core/drawing/constraints/carried_parts.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace forefront {
namespace {

/// Moves the references of constraints, and adds constraints that keep forms.
class ConstraintCarrier {
  public:
    ConstraintCarrier(const Document &before, Document &next) : before_(before), next_(next), parts_(before, next) {}

    void run() {
        std::vector<std::shared_ptr<const SketchConstraint>> kept;
        for (const auto &pointer : next_.constraints) {
            if (std::none_of(pointer->parts.begin(), pointer->parts.end(),
                             [&](const SketchPart &part) { return parts_.changed(part.shape); })) {
                if (stillFits(*pointer)) {
                    kept.push_back(pointer);
                }
            } else if (std::optional<SketchConstraint> carried = carry(*pointer)) {
                kept.push_back(*carried == *pointer ? pointer
                                                    : std::make_shared<const SketchConstraint>(*std::move(carried)));
            }
        }
        next_.constraints = std::move(kept);
        for (const std::uint32_t id : turned_) {
            keepForm(*findShape(before_, id));
        }
        for (const auto &[first, second] : divided_) {
            keepTogether(first, second);
        }
    }

  private:
    std::optional<SketchConstraint> carry(const SketchConstraint &constraint) {
        SketchConstraint carried = constraint;
        carried.parts.clear();
        for (const SketchPart &part : constraint.parts) {
            const std::vector<SketchPart> images = parts_.images(part);
            const bool ofLength =
                constraint.kind == ConstraintKind::Equal || constraint.kind == ConstraintKind::Midpoint;
            if (images.empty() && part.kind == SketchPartKind::Node) {
                return measuredFromSide(constraint);
            }
            if (images.empty() || (ofLength && parts_.isShortened(part))) {
                return std::nullopt;
            }
            noteForm(part.shape);
            if (images.size() > 1 && constraint.kind == ConstraintKind::Midpoint) {
                carried.parts.push_back(parts_.image({part.shape, SketchPartKind::Node, part.index}));
                carried.parts.push_back(parts_.image(parts_.endOf(part)));
                continue;
            }
            if (images.size() > 1 && constraint.kind == ConstraintKind::Equal &&
                formOfPart(before_, part) == PartForm::Line) {
                return std::nullopt; // it was about the whole length
            }
            noteDivision(images);
            carried.parts.push_back(images.front());
        }
        if (!partsFault(next_, carried.kind, carried.parts).empty()) {
            return std::nullopt;
        }
        return reoriented(next_, std::move(carried));
    }

    /// Carries a length between nodes one of which was a corner that a fillet or chamfer has cut off: it is measured
    /// from the rest of the side across it, on which the corner was. None if there is no such side.
    std::optional<SketchConstraint> measuredFromSide(const SketchConstraint &constraint) const {
        const std::optional<Vec2> way = wayOf(constraint);
        if (!way) {
            return std::nullopt;
        }
        SketchConstraint carried = constraint;
        carried.kind = ConstraintKind::Distance;
        carried.label.reset();
        for (SketchPart &part : carried.parts) {
            const std::vector<SketchPart> images = parts_.images(part);
            const std::optional<SketchPart> image =
                !images.empty() ? std::optional(images.front()) : sideAcross(part, *way);
            if (!image) {
                return std::nullopt;
            }
            part = *image;
        }
        if (carried.parts[0].kind != SketchPartKind::Node) { // a point comes first
            std::swap(carried.parts[0], carried.parts[1]);
        }
        if (!partsFault(next_, carried.kind, carried.parts).empty()) {
            return std::nullopt;
        }
        carried = reoriented(next_, std::move(carried));
        return holdsIn(next_, carried) ? std::optional(std::move(carried)) : std::nullopt;
    }

    /// Returns the direction in which a dimension between two nodes measures; none for other constraints.
    std::optional<Vec2> wayOf(const SketchConstraint &constraint) const {
        if (constraint.kind == ConstraintKind::HorizontalDistance) {
            return Vec2{1.0, 0.0};
        }
        if (constraint.kind == ConstraintKind::VerticalDistance) {
            return Vec2{0.0, 1.0};
        }
        const bool ofNodes = std::all_of(constraint.parts.begin(), constraint.parts.end(),
                                         [](const SketchPart &part) { return part.kind == SketchPartKind::Node; });
        const bool measures = constraint.kind == ConstraintKind::Length || constraint.kind == ConstraintKind::Distance;
        if (!measures || !ofNodes || constraint.parts.size() != 2) {
            return std::nullopt;
        }
        const std::optional<Vec2> from = placeOfPart(before_, constraint.parts[0]);
        const std::optional<Vec2> to = placeOfPart(before_, constraint.parts[1]);
        return from && to ? std::optional(*to - *from) : std::nullopt;
    }

    /// Returns what is left of the straight segment at a lost node that is perpendicular to a direction.
    std::optional<SketchPart> sideAcross(const SketchPart &node, Vec2 way) const {
        const Shape *const shape = findShape(before_, node.shape);
        if (shape == nullptr || !(isPath(*shape) || shape->is<RectangleForm>())) {
            return std::nullopt;
        }
        const Outline outline = outlineOf(*shape);
        const auto count = static_cast<std::uint32_t>(handleCount(*shape));
        for (const std::uint32_t k : {node.index, (node.index + count - 1) % count}) {
            if (k >= outline.segmentCount() || outline.isCurved(k)) {
                continue;
            }
            constexpr double kPerpendicular = 1e-9;
            const Vec2 along = outline.to(k) - outline.from(k);
            const std::vector<SketchPart> images = parts_.images({node.shape, SketchPartKind::Segment, k});
            if (!images.empty() && std::fabs(dot(along, way)) <= kPerpendicular * length(along) * length(way)) {
                return images.front();
            }
        }
        return std::nullopt;
    }

    /// Returns true unless a part of a constraint has become something that the constraint cannot have, such as a line
    /// that became a curve or an arc of a circle that was stretched.
    bool stillFits(const SketchConstraint &constraint) const {
        const bool same = std::all_of(constraint.parts.begin(), constraint.parts.end(), [&](const SketchPart &part) {
            return findShape(before_, part.shape) == findShape(next_, part.shape);
        });
        return same || partsFault(next_, constraint.kind, constraint.parts).empty();
    }

    /// Notes a rectangle, circle or slot that became a path.
    void noteForm(std::uint32_t id) {
        const Shape *const old = findShape(before_, id), *const now = findShape(next_, id);
        if (old != nullptr && now != nullptr && !isPath(*old) && isPath(*now)) {
            turned_.insert(id);
        }
    }

    void noteDivision(const std::vector<SketchPart> &images) {
        for (std::size_t k = 1; k < images.size(); ++k) {
            divided_.insert({images[k - 1], images[k]});
        }
    }

    void add(ConstraintKind kind, std::vector<SketchPart> parts) {
        Result<SketchConstraint> made = makeConstraint(next_, kind, std::move(parts));
        if (made && holdsIn(next_, *made)) {
            next_.nextId = made->id + 1;
            next_.constraints.push_back(std::make_shared<const SketchConstraint>(*std::move(made)));
        }
    }

    void keepTogether(const SketchPart &first, const SketchPart &second) {
        const PartForm form = formOfPart(next_, first);
        if (form == formOfPart(next_, second) && (form == PartForm::Line || form == PartForm::Circle)) {
            add(form == PartForm::Line ? ConstraintKind::Collinear : ConstraintKind::Concentric, {first, second});
        }
    }

    bool isLevel(const std::vector<SketchPart> &side) const {
        const Result<SketchConstraint> level = makeConstraint(next_, ConstraintKind::Horizontal, side);
        return level && holdsIn(next_, *level);
    }

    /// Adds the constraints that the form of a shape implied before it became a path.
    void keepForm(const Shape &old) {
        const auto segment = [&](std::uint32_t k) {
            const std::vector<SketchPart> images = parts_.images({old.id, SketchPartKind::Segment, k});
            noteDivision(images);
            return images.empty() ? std::vector<SketchPart>() : std::vector<SketchPart>{images.front()};
        };
        if (old.is<RectangleForm>()) {
            const bool level = isLevel(segment(0));
            for (std::uint32_t k = 0; k < 4; ++k) {
                std::vector<SketchPart> side = segment(k);
                if (level) {
                    add(k % 2 == 0 ? ConstraintKind::Horizontal : ConstraintKind::Vertical, std::move(side));
                } else if (k > 0) { // it was turned
                    const std::vector<SketchPart> last = segment(k - 1);
                    side.insert(side.end(), last.begin(), last.end());
                    add(ConstraintKind::Perpendicular, std::move(side));
                }
            }
        } else if (old.is<CircleForm>()) {
            for (std::uint32_t k = 1; k < 4; ++k) {
                add(ConstraintKind::Concentric,
                    {{old.id, SketchPartKind::Segment, 0}, {old.id, SketchPartKind::Segment, k}});
            }
        } else if (old.is<SlotForm>()) {
            for (std::uint32_t k = 0; k < 4; ++k) {
                std::vector<SketchPart> pair = segment(k), other = segment((k + 1) % 4);
                pair.insert(pair.end(), other.begin(), other.end());
                add(ConstraintKind::Tangent, std::move(pair));
            }
            std::vector<SketchPart> ends = segment(1), other = segment(3);
            ends.insert(ends.end(), other.begin(), other.end());
            add(ConstraintKind::Equal, std::move(ends));
        }
    }

    const Document &before_;
    Document &next_;
    CarriedParts parts_;
    std::set<std::uint32_t> turned_; ///< shapes that became paths
    std::set<std::pair<SketchPart, SketchPart>> divided_;
};

} // namespace

void carryConstraints(const Document &before, Document &next) {
    if (!next.constraints.empty() && before.shapes != next.shapes) {
        ConstraintCarrier(before, next).run();
    }
}

std::vector<std::string> lostConstraints(const Document &before, const Document &after) {
    std::vector<std::string> names;
    if (before.constraints != after.constraints) {
        for (const auto &constraint : before.constraints) {
            if (findConstraint(after, constraint->id) == nullptr) {
                names.push_back(constraint->name);
            }
        }
    }
    return names;
}

} // namespace forefront
