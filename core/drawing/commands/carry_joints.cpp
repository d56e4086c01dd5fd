#include "core/drawing/commands/carry_joints.hpp"

#include "core/drawing/commands/carry_corners.hpp"
#include "core/drawing/commands/joint_mover.hpp"
#include "core/drawing/commands/shared_curves.hpp"
#include "core/drawing/commands/shared_segments.hpp"
#include "core/drawing/constraints/joint_correction.hpp"
#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/picking/selected_handles.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace forefront {
namespace {

/// Returns the first fault of a shape that joints have changed after a command; empty if there is none.
Diagnostics faultOfFollower(const Document &after, const Document &next) {
    for (std::size_t k = 0; k < next.shapes.size(); ++k) {
        const Shape &shape = *next.shapes[k];
        const bool same = k < after.shapes.size() && after.shapes[k] == next.shapes[k];
        const Diagnostics faults = same ? Diagnostics() : checkShape(shape);
        if (!faults.empty()) {
            return error("joint-conflict",
                         "the joints would make " + displayName(shape) + " invalid: " + faults.front().message,
                         "move less, or drag with Alt to detach the node");
        }
    }
    return {};
}

Result<Document> carryThrough(const JointIndex &index, JointCorrection &correction, const Document &after) {
    Result<Document> next = editSharedSegments(index, after);
    next = next ? bendSharedCurves(index, *std::move(next)) : std::move(next);
    Result<FollowedMove> followed = next ? followJoints(index, *std::move(next)) : Result<FollowedMove>(next.faults());
    if (!followed) {
        return followed.faults();
    }
    next = correction.correct(std::move(followed->document), followed->given, followed->turned);
    const Diagnostics faults = next ? faultOfFollower(after, *next) : Diagnostics();
    if (!faults.empty()) {
        return faults;
    }
    return next ? carryCorners(index.document(), *std::move(next), index.tolerance()) : std::move(next);
}

} // namespace

Result<Document> carryJoints(const Document &before, const Document &after) {
    JointCorrection correction(std::make_shared<const Document>(before));
    return carryThrough(JointIndex(before), correction, after);
}

Joints::Joints(std::shared_ptr<const Document> document)
    : document_(std::move(document)), index_(std::make_shared<const JointIndex>(*document_)),
      correction_(std::make_shared<JointCorrection>(document_)) {}

Result<Document> Joints::carry(const Document &after) const {
    return carryThrough(*index_, *correction_, after);
}

std::vector<bool> Joints::joinedHandles(std::uint32_t shape) const {
    const std::size_t position = positionOf(*document_, shape);
    if (position == document_->shapes.size() || !canJoin(*document_->shapes[position])) {
        return {};
    }
    const std::vector<Vec2> handles = handlesOf(*document_->shapes[position]);
    std::vector<bool> joined;
    joined.reserve(handles.size());
    for (std::uint32_t k = 0; k < handles.size(); ++k) {
        bool shared = false;
        index_->handlesAt(handles[k], [&](const JointHandle &other) {
            shared = shared || other.shape != position || other.handle != k;
        });
        joined.push_back(shared || index_->segmentAt(handles[k], [](const JointSegment &) { return true; }) != nullptr);
    }
    return joined;
}

Selection Joints::withJoined(const Selection &selection) const {
    Selection all = selection;
    const auto addAt = [&](Vec2 place) {
        index_->handlesAt(place, [&](const JointHandle &handle) {
            const std::uint32_t id = document_->shapes[handle.shape]->id;
            if (!selection.shapes.contains(id)) {
                all.nodes.insert({id, handle.handle});
            }
        });
    };
    for (const std::uint32_t id : selection.shapes) {
        const Shape *const shape = findShape(*document_, id);
        if (shape != nullptr && canJoin(*shape)) {
            const std::vector<Vec2> handles = handlesOf(*shape);
            std::for_each(handles.begin(), handles.end(), addAt);
        }
    }
    for (const auto &[id, moving] : handlesToMove(*document_, selection)) {
        const Shape *const shape = findShape(*document_, id);
        const std::vector<Vec2> handles = shape != nullptr && canJoin(*shape) ? handlesOf(*shape) : std::vector<Vec2>();
        for (const std::uint32_t k : moving) {
            if (k < handles.size()) {
                addAt(handles[k]);
            }
        }
    }
    return all;
}

} // namespace forefront
