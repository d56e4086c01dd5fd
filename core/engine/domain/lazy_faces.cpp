#include "core/engine/domain/lazy_faces.hpp"

namespace forefront {

const DomainFaces *LazyFaces::get() const {
    if (!found_) {
        DomainFaces found;
        found.graph = graphOf(domain_, places_);
        found.sweep = sweepPlane(found.graph.points, found.graph.edges, stop_);
        if (stop_.stop_requested()) {
            return nullptr;
        }
        if (found.sweep.droppedCount == 0) {
            found.faces = findFaces(found.graph.points, found.graph.edges, found.sweep);
            found.labels = labelFaces(domain_, found.graph, found.faces);
        }
        found_ = std::move(found);
    }
    return found_->sweep.droppedCount == 0 ? &*found_ : nullptr;
}

const InsideTest *LazyFaces::inside() const {
    if (const DomainFaces *const found = inside_ ? nullptr : get()) {
        inside_.emplace(*found);
    }
    return inside_ && !inside_->empty() ? &*inside_ : nullptr;
}

} // namespace forefront
