#include "core/drawing/formulas/unchanged_numbers.hpp"

#include "core/drawing/formulas/document_numbers.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace forefront {
namespace {

using ShapeList = std::vector<std::shared_ptr<const Shape>>;

/// Adds the ids of the shapes of a list that are not the same objects at the same places of another one.
void addChanged(const ShapeList &shapes, const ShapeList &others, std::unordered_set<std::uint32_t> &changed) {
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        if (k >= others.size() || shapes[k] != others[k]) {
            changed.insert(shapes[k]->id);
        }
    }
}

} // namespace

UnchangedNumbers::UnchangedNumbers(const Document &before, const Document &next)
    : before_(before), next_(next), sameSources_(before.spacing.sources == next.spacing.sources),
      sameMarkers_(before.regionMarkers == next.regionMarkers) {
    addChanged(before.shapes, next.shapes, changedShapes_);
    addChanged(next.shapes, before.shapes, changedShapes_);
}

bool UnchangedNumbers::contains(const NumberAddress &address) const {
    switch (address.owner.kind) {
    case NumberOwner::Kind::Shape:
        return !changedShapes_.contains(address.owner.id);
    case NumberOwner::Kind::Source:
        return sameSources_;
    case NumberOwner::Kind::Region:
        return sameMarkers_;
    case NumberOwner::Kind::Constraint:
    case NumberOwner::Kind::Part:
    case NumberOwner::Kind::Spacing:
        break;
    }
    const std::optional<double> now = readNumber(next_, address);
    return now && now == readNumber(before_, address);
}

} // namespace forefront
