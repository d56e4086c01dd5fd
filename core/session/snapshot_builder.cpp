#include "core/session/snapshot_builder.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Maximum size of meshes whose full quality is measured whenever the run rests; larger ones only at the end.
constexpr std::size_t kMeasureUpTo = 200'000;
constexpr std::uint64_t kMaxMarks = 2000;
/// Number of elements between stored tallies, the maximum to count again for the figures of a position.
constexpr std::size_t kTallyStride = 1024;

void count(ShapeTally &tally, const FrontState &state, std::size_t element) {
    const Element &n = state.elements[element];
    tally.add(state.nodes[index(n[0])], state.nodes[index(n[1])], state.nodes[index(n[2])]);
}

std::shared_ptr<const std::vector<FrontSegmentView>> frontOf(const GenerationFront &front) {
    auto view = std::make_shared<std::vector<FrontSegmentView>>();
    view->reserve(front.segments());
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        if (front[id].alive && !front.isolated(id)) {
            view->push_back({front.start(id), front.end(id), front[id].node, front[front.next(id)].node});
        }
    }
    return view;
}

std::shared_ptr<const std::vector<GridCellView>> cellsOf(const Mesher &mesher) {
    auto view = std::make_shared<std::vector<GridCellView>>();
    mesher.forEachCell([&](const Box2 &box, std::uint32_t entries) { view->push_back({box, entries}); });
    return view;
}

std::optional<MarkKind> markOf(const AdvanceDelta &delta) {
    if (delta.forced) {
        return MarkKind::Forced;
    }
    switch (delta.kind) {
    case AdvanceDelta::Kind::Deferral:
        return MarkKind::Deferral;
    case AdvanceDelta::Kind::Loop:
        return MarkKind::Closure;
    case AdvanceDelta::Kind::NewNode:
        return MarkKind::NewNode;
    default:
        return std::nullopt;
    }
}

} // namespace

void SnapshotBuilder::fill(SessionSnapshot &snapshot, const Timeline &timeline, SnapshotLayers layers, bool resting) {
    const FrontState &state = timeline.mesher().state();
    snapshot.advance = timeline.position();
    snapshot.known = timeline.known();
    snapshot.complete = timeline.complete();
    snapshot.work = state.work;
    snapshot.frontSegments = state.front.segments();
    if (layers.front) {
        snapshot.front = frontOf(state.front);
    }
    if (layers.cells) {
        snapshot.cells = cellsOf(timeline.mesher());
    }
    fillMesh(snapshot, timeline, layers.mesh, resting);
    if (resting) {
        snapshot.stateHash = state.hash();
        if (!marks_ || marksKnown_ != timeline.known()) {
            marks_ = marksOf(timeline);
            marksKnown_ = timeline.known();
        }
    }
    snapshot.marks = marks_;
}

void SnapshotBuilder::fillMesh(SessionSnapshot &snapshot, const Timeline &timeline, bool include, bool resting) {
    const FrontState &state = timeline.mesher().state();
    growShapes(state);
    if (include && meshPosition_ != timeline.position()) {
        auto view = std::make_shared<MeshView>();
        view->mesh = toMesh(state, timeline.mesher().boundary());
        view->alpha.assign(alpha_.begin(), alpha_.begin() + static_cast<std::ptrdiff_t>(state.elements.size()));
        view->version = ++version_;
        mesh_ = std::move(view);
        meshPosition_ = timeline.position();
    }
    if (include) {
        snapshot.mesh = mesh_;
    }
    const bool whole = resting && include && state.elements.size() <= kMeasureUpTo;
    if (whole && qualityPosition_ != timeline.position()) {
        quality_ = measure(mesh_->mesh, &timeline.mesher().spacing());
        quality_.nodes = state.nodes.size();
        qualityPosition_ = timeline.position();
    }
    snapshot.quality = whole ? quality_ : quickQuality(state);
}

void SnapshotBuilder::growShapes(const FrontState &state) {
    for (std::size_t e = alpha_.size(); e < state.elements.size(); ++e) {
        if (e % kTallyStride == 0) {
            tallies_.push_back(growing_);
        }
        count(growing_, state, e);
        const Element &n = state.elements[e];
        alpha_.push_back(static_cast<float>(
            shapeFactor(state.nodes[index(n[0])], state.nodes[index(n[1])], state.nodes[index(n[2])])));
    }
}

/// Returns the figures that follow from the shapes alone, which is fast at any position and size.
MeshQuality SnapshotBuilder::quickQuality(const FrontState &state) const {
    MeshQuality quality;
    quality.nodes = state.nodes.size();
    if (state.elements.empty()) {
        return quality;
    }
    ShapeTally tally = tallies_[(state.elements.size() - 1) / kTallyStride];
    for (std::size_t e = tally.count(); e < state.elements.size(); ++e) {
        count(tally, state, e);
    }
    tally.into(quality);
    return quality;
}

/// Returns the rarest kind of mark of each stretch of the timeline. New nodes are marked only if all of them fit.
std::shared_ptr<const std::vector<TimelineMark>> SnapshotBuilder::marksOf(const Timeline &timeline) {
    auto marks = std::make_shared<std::vector<TimelineMark>>();
    const std::uint64_t stretch = timeline.known() / kMaxMarks + 1;
    std::optional<TimelineMark> pending;
    for (std::uint64_t p = 0; p < timeline.known(); ++p) {
        const std::optional<MarkKind> kind = markOf(timeline.delta(p));
        if (kind && (stretch == 1 || *kind != MarkKind::NewNode) && (!pending || *kind > pending->kind)) {
            pending = TimelineMark{p + 1, *kind};
        }
        if ((p + 1) % stretch == 0 || p + 1 == timeline.known()) {
            if (pending) {
                marks->push_back(*pending);
            }
            pending.reset();
        }
    }
    return marks;
}

} // namespace forefront
