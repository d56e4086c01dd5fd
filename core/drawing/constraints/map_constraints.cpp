#include "core/drawing/constraints/map_constraints.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using ConstraintList = std::vector<std::shared_ptr<const SketchConstraint>>;

/// Returns a kind with the axes exchanged.
ConstraintKind withOtherAxis(ConstraintKind kind) {
    switch (kind) {
    case ConstraintKind::Horizontal:
        return ConstraintKind::Vertical;
    case ConstraintKind::Vertical:
        return ConstraintKind::Horizontal;
    case ConstraintKind::HorizontalDistance:
        return ConstraintKind::VerticalDistance;
    case ConstraintKind::VerticalDistance:
        return ConstraintKind::HorizontalDistance;
    default:
        return kind;
    }
}

bool isLevel(ConstraintKind kind) {
    return kind == ConstraintKind::Horizontal || kind == ConstraintKind::Vertical;
}

/// Maps the constraints within some shapes.
class ConstraintMapper {
  public:
    ConstraintMapper(Document &document, const std::set<std::uint32_t> &shapes, const PlaneMap &map)
        : document_(document), shapes_(shapes), map_(map) {}

    void run() {
        ConstraintList mapped;
        for (const auto &pointer : document_.constraints) {
            if (!isInside(*pointer)) {
                mapped.push_back(turnedWithOthers(pointer));
            } else if (std::optional<SketchConstraint> image = imageOf(*pointer)) {
                mapped.push_back(*image == *pointer ? pointer
                                                    : std::make_shared<const SketchConstraint>(*std::move(image)));
            }
        }
        document_.constraints = std::move(mapped);
    }

  private:
    bool isInside(const SketchConstraint &constraint) const {
        return std::all_of(constraint.parts.begin(), constraint.parts.end(),
                           [&](const SketchPart &part) { return shapes_.contains(part.shape); });
    }

    /// Gives a constraint that also binds other shapes the sides and turns that it has in the image: what is inside a
    /// mirrored outline stays inside.
    std::shared_ptr<const SketchConstraint> turnedWithOthers(const std::shared_ptr<const SketchConstraint> &given) {
        const bool touches = std::any_of(given->parts.begin(), given->parts.end(),
                                         [&](const SketchPart &part) { return shapes_.contains(part.shape); });
        if (!touches || !partsFault(document_, given->kind, given->parts).empty()) {
            return given;
        }
        DocumentSketch sketch(document_);
        SketchConstraint image = oriented(sketch, *given);
        return image == *given ? given : std::make_shared<const SketchConstraint>(std::move(image));
    }

    std::optional<SketchConstraint> imageOf(SketchConstraint constraint) {
        if (!partsFault(document_, constraint.kind, constraint.parts).empty()) {
            return constraint; // its shapes became paths, which carryConstraints() follows
        }
        if (!map_.keepsAxes() && isLevel(constraint.kind)) {
            return turned(std::move(constraint));
        }
        const bool exchanged = map_.keepsAxes() && map_.u.x == 0.0;
        constraint.kind = exchanged ? withOtherAxis(constraint.kind) : constraint.kind;
        if (isDimension(constraint.kind)) {
            if (map_.isSimilarity() && constraint.kind != ConstraintKind::Angle) {
                constraint.value *= std::sqrt(std::fabs(map_.determinant()));
            }
            DocumentSketch sketch(document_);
            const SketchConstraint image = oriented(sketch, constraint);
            const double value = measured(sketch, image);
            if (!map_.isSimilarity() && value > 0.0) {
                constraint = image;
                constraint.value = value;
            }
        }
        constraint = reoriented(document_, std::move(constraint));
        mapLabel(constraint);
        return holdsIn(document_, constraint) ? std::optional(std::move(constraint)) : std::nullopt;
    }

    /// Maps the place of the text of a dimension: that of a length scales with the line and changes sides in a mirror.
    void mapLabel(SketchConstraint &constraint) const {
        if (!constraint.label) {
            return;
        }
        const Vec2 offset = *constraint.label;
        const bool central = constraint.kind == ConstraintKind::Angle || constraint.kind == ConstraintKind::Radius ||
                             constraint.kind == ConstraintKind::Diameter;
        const double scale = std::sqrt(std::fabs(map_.determinant()));
        const double side = map_.determinant() < 0.0 ? -scale : scale;
        constraint.label = central ? offset.x * map_.u + offset.y * map_.v : Vec2{scale * offset.x, side * offset.y};
    }

    /// Turns a horizontal or vertical line, whose direction is now that of the first such line.
    std::optional<SketchConstraint> turned(SketchConstraint constraint) {
        if (constraint.parts.size() != 1) {
            return std::nullopt;
        }
        if (!reference_) {
            reference_ = constraint;
            return std::nullopt;
        }
        const bool parallel = constraint.kind == reference_->kind;
        constraint.kind = parallel ? ConstraintKind::Parallel : ConstraintKind::Perpendicular;
        constraint.parts.insert(constraint.parts.begin(), reference_->parts.front());
        DocumentSketch sketch(document_);
        constraint = oriented(sketch, std::move(constraint));
        return holdsIn(document_, constraint) ? std::optional(std::move(constraint)) : std::nullopt;
    }

    Document &document_;
    const std::set<std::uint32_t> &shapes_;
    const PlaneMap &map_;
    std::optional<SketchConstraint> reference_; ///< the first horizontal or vertical line
};

} // namespace

void mapConstraints(Document &document, const std::set<std::uint32_t> &shapes, const PlaneMap &map) {
    if (!document.constraints.empty() && !map.isTranslation()) { // translations change no constraint
        ConstraintMapper(document, shapes, map).run();
    }
}

std::map<std::uint32_t, std::uint32_t> copyConstraints(Document &to, const Document &from,
                                                       const std::map<std::uint32_t, std::uint32_t> &copies) {
    std::map<std::uint32_t, std::uint32_t> ids;
    const ConstraintList list = from.constraints; // `from` may be `to`
    for (const auto &pointer : list) {
        if (!std::all_of(pointer->parts.begin(), pointer->parts.end(),
                         [&](const SketchPart &part) { return copies.contains(part.shape); })) {
            continue;
        }
        SketchConstraint copy = *pointer;
        copy.id = to.nextId++;
        copy.name = freeConstraintName(to, copy.kind);
        for (SketchPart &part : copy.parts) {
            part.shape = copies.at(part.shape);
        }
        ids.emplace(pointer->id, copy.id);
        to.constraints.push_back(std::make_shared<const SketchConstraint>(std::move(copy)));
    }
    return ids;
}

} // namespace forefront
