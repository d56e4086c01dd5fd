#include "ui/canvas/mesh_glide.hpp"

#include "core/engine/base/hash.hpp"

#include <utility>

namespace forefront {

bool MeshGlide::follow(const SessionSnapshot &run) {
    const bool changed = run_ != run.shownRun || position_ != run.improveStep || improving_ != run.frontDone() ||
                         step_ != run.improvement;
    const std::shared_ptr<const ImproveStep> last = std::exchange(step_, run.improvement);
    const std::size_t from = std::exchange(position_, run.improveStep);
    const bool sameRun = std::exchange(run_, run.shownRun) == run.shownRun;
    const bool wasImproving = std::exchange(improving_, run.frontDone());
    if (!changed && mesh_ == run.mesh) {
        return false;
    }
    mesh_ = run.mesh;
    if (changed) {
        moves_.clear();
        if (sameRun && wasImproving && position_ == from + 1 && step_) {
            moves_ = step_->moves;
        } else if (sameRun && improving_ && position_ + 1 == from && last) {
            for (const ImproveStep::Move &move : last->moves) {
                moves_.push_back({move.node, move.to, move.from});
            }
        }
    }
    return changed && (step_ != nullptr || !moves_.empty());
}

std::shared_ptr<const MeshSnapshot> MeshGlide::at(double left) {
    if (moves_.empty() || !mesh_ || mesh_->whole || mesh_->mesh.elements.size() > kMaxElements || !(left > 0.0)) {
        return nullptr;
    }
    auto picture = std::make_shared<MeshSnapshot>(*mesh_);
    for (const ImproveStep::Move &move : moves_) {
        // Where nodes come or go, others change their numbers; these do not glide.
        Vec2 *const node =
            index(move.node) < picture->mesh.nodes.size() ? &picture->mesh.nodes[index(move.node)] : nullptr;
        if (node != nullptr && *node == move.to) {
            *node = lerp(move.to, move.from, left * left * left); // slows down at the end
        }
    }
    Hash64 version;
    version.add(mesh_->version);
    version.add(++pictures_);
    picture->version = version.value();
    return picture;
}

} // namespace forefront
