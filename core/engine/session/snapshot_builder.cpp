#include "core/engine/session/snapshot_builder.hpp"

#include <algorithm>
#include <array>
#include <span>

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

/// `colours`: of the nodes; null: they have none.
std::shared_ptr<const std::vector<FrontSegmentView>> frontOf(const GenerationFront &front,
                                                             const std::vector<std::uint8_t> *colours) {
    auto view = std::make_shared<std::vector<FrontSegmentView>>();
    view->reserve(front.segments());
    front.forEachSlot([&](SlotId id) {
        if (!front.isolated(id)) {
            const NodeId node = front[id].node;
            view->push_back({front.start(id), front.end(id), node, front[front.next(id)].node,
                             colours == nullptr ? -1 : (*colours)[index(node)]});
        }
    });
    return view;
}

std::shared_ptr<const std::vector<GridCellView>> cellsOf(const Mesher &mesher) {
    auto view = std::make_shared<std::vector<GridCellView>>();
    mesher.forEachCell([&](const Box2 &box, std::uint32_t entries) { view->push_back({box, entries}); });
    return view;
}

bool has(const AdvanceDelta &delta, MarkKind kind) {
    using Kind = AdvanceDelta::Kind;
    switch (kind) {
    case MarkKind::NewNode:
        return delta.kind == Kind::NewNode || delta.kind == Kind::Two || delta.kind == Kind::Three ||
               delta.kind == Kind::Opening;
    case MarkKind::Rejection:
        return delta.rejected > 0;
    case MarkKind::Connection:
        return delta.kind == Kind::Connection;
    case MarkKind::Closure:
        return delta.kind == Kind::Loop;
    case MarkKind::Deferral:
        return delta.kind == Kind::Deferral;
    case MarkKind::Forced:
        return delta.forced;
    }
    return false;
}

/// Collects the advances of an interval into a sample of the curves.
class SampleSum {
  public:
    void add(std::size_t segments, const AdvanceDelta &delta, std::span<const float> alphas) {
        ++advances_;
        front_ += static_cast<double>(segments);
        tests_ += delta.tested;
        elements_ += alphas.size();
        for (const float alpha : alphas) {
            alphaSum_ += static_cast<double>(alpha);
            alphaMin_ = std::min(alphaMin_, alpha);
        }
    }
    std::uint64_t advances() const { return advances_; }
    RunCurves::Sample take() {
        const auto elements = static_cast<double>(elements_);
        const RunCurves::Sample sample{
            .front = static_cast<float>(front_ / static_cast<double>(advances_)),
            .tests = static_cast<float>(elements_ == 0 ? 0.0 : static_cast<double>(tests_) / elements),
            .alphaMean = static_cast<float>(elements_ == 0 ? 1.0 : alphaSum_ / elements),
            .alphaMin = alphaMin_};
        *this = {};
        return sample;
    }

  private:
    std::uint64_t advances_ = 0, tests_ = 0, elements_ = 0;
    double front_ = 0.0, alphaSum_ = 0.0;
    float alphaMin_ = 1.0F;
};

} // namespace

void SnapshotBuilder::fill(SessionSnapshot &snapshot, const Timeline &timeline, SnapshotLayers layers, bool resting) {
    const FrontState &state = timeline.mesher().state();
    snapshot.advance = timeline.position();
    snapshot.known = timeline.known();
    snapshot.complete = timeline.complete();
    snapshot.work = state.work;
    snapshot.frontSegments = state.front.segments();
    if (layers.front) {
        snapshot.front = frontOf(state.front, timeline.mesher().colours());
    }
    if (layers.cells) {
        snapshot.cells = cellsOf(timeline.mesher());
    }
    fillMesh(snapshot, timeline, layers.mesh, resting);
    if (resting) {
        snapshot.stateHash = timeline.mesher().stateHash();
        if (!marks_ || marksKnown_ != timeline.known()) {
            marks_ = marksOf(timeline);
            curves_ = curvesOf(timeline);
            marksKnown_ = timeline.known();
        }
    }
    snapshot.marks = marks_;
    snapshot.curves = curves_;
}

void SnapshotBuilder::fillMesh(SessionSnapshot &snapshot, const Timeline &timeline, bool include, bool resting) {
    const FrontState &state = timeline.mesher().state();
    growShapes(state);
    if (include && meshPosition_ != timeline.position()) {
        std::shared_ptr<MeshSnapshot> view;
        if (std::optional<Mesh> joined = timeline.mesher().joinedMesh()) {
            view = snapshotOf(*std::move(joined));
        } else {
            view = std::make_shared<MeshSnapshot>();
            view->mesh = toMesh(state, timeline.mesher().boundary());
            view->alpha.assign(alpha_.begin(), alpha_.begin() + static_cast<std::ptrdiff_t>(state.elements.size()));
        }
        view->version = ++version_;
        mesh_ = std::move(view);
        meshPosition_ = timeline.position();
    }
    if (include) {
        snapshot.mesh = mesh_;
    }
    // The shapes of halves of squares say nothing about the mesh: figures come from the joined mesh, or there are none.
    const bool halves = timeline.mesher().colours() != nullptr;
    const bool whole = (resting || halves) && include && state.elements.size() <= kMeasureUpTo;
    if (whole && qualityPosition_ != timeline.position()) {
        quality_ = measureQuality(mesh_->view(), &timeline.mesher().spacing());
        quality_.nodes = state.nodes.size();
        qualityPosition_ = timeline.position();
    }
    if (whole) {
        snapshot.quality = quality_;
    } else if (!halves) {
        snapshot.quality = quickQuality(state);
    } else {
        snapshot.quality = {};
        snapshot.quality.nodes = state.nodes.size();
        snapshot.quality.elements = include ? mesh_->view().elementCount() : 0;
    }
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

/// Returns the first mark of each kind in each interval of the timeline. New nodes are marked only if all of them fit.
std::shared_ptr<const std::vector<TimelineMark>> SnapshotBuilder::marksOf(const Timeline &timeline) {
    auto marks = std::make_shared<std::vector<TimelineMark>>();
    const std::uint64_t stretch = timeline.known() / kMaxMarks + 1;
    std::array<std::uint64_t, kMarkKinds> markedTo{}; ///< per kind: end of the interval marked last
    for (std::uint64_t p = 0; p < timeline.known(); ++p) {
        for (std::size_t k = stretch == 1 ? 0 : 1; k < kMarkKinds; ++k) {
            const auto kind = static_cast<MarkKind>(k);
            if (p >= markedTo[k] && has(timeline.delta(p), kind)) {
                marks->push_back({p + 1, kind});
                markedTo[k] = (p / stretch + 1) * stretch;
            }
        }
    }
    return marks;
}

std::shared_ptr<const RunCurves> SnapshotBuilder::curvesOf(const Timeline &timeline) const {
    auto curves = std::make_shared<RunCurves>();
    curves->advancesPerSample = timeline.known() / RunCurves::kSamples + 1;
    curves->samples.reserve(RunCurves::kSamples);
    SampleSum sum;
    std::size_t element = 0;
    std::size_t segments = timeline.segmentsAtStart();
    for (std::uint64_t p = 0; p < timeline.known(); ++p) {
        const AdvanceDelta &delta = timeline.delta(p);
        // Elements that no snapshot has shown yet have no α here.
        const std::size_t from = std::min(element, alpha_.size());
        element += delta.elements();
        sum.add(segments, delta, std::span(alpha_).subspan(from, std::min(element, alpha_.size()) - from));
        segments = static_cast<std::size_t>(static_cast<std::int64_t>(segments) + delta.growth());
        if (sum.advances() == curves->advancesPerSample || p + 1 == timeline.known()) {
            curves->samples.push_back(sum.take());
        }
    }
    return curves;
}

} // namespace forefront
