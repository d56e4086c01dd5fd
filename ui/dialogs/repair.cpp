#include "ui/dialogs/repair.hpp"

#include "core/domain/validate.hpp"
#include "ui/parts/shell.hpp"

namespace forefront {

void repairDrawing(Shell &context) {
    const std::shared_ptr<const Document> before = context.document.current();
    Result<Repaired> repaired = repair(toDomain(*before));
    if (!repaired) {
        context.log.add(repaired.faults());
        return;
    }
    if (repaired->changes.empty()) {
        context.log.tell("Found nothing to repair");
        return;
    }
    const Document drawing = fromDomain(repaired->domain);
    Document next = *before;
    // Ids continue, so that no new shape is mistaken for an old one.
    next.shapes.clear();
    for (const auto &shape : drawing.shapes) {
        auto copy = std::make_shared<Shape>(*shape);
        copy->id = next.nextId++;
        next.shapes.push_back(std::move(copy));
    }
    next.regionMarkers = drawing.regionMarkers;
    next.boundaryNames = drawing.boundaryNames;
    next.regionNames = drawing.regionNames;
    context.document.apply(std::move(next), "Repair drawing");
    context.selection.clear();
    context.log.add(repaired->changes);
    const Diagnostics left = validate(repaired->domain);
    const auto counted = [](std::size_t count, const char *what) {
        return std::to_string(count) + what + (count == 1 ? "" : "s");
    };
    context.log.tell(counted(repaired->changes.size(), " repair") + ", " + counted(left.size(), " fault") + " left");
}

} // namespace forefront
