#include "core/engine/mesher/mesher.hpp"

#include "core/engine/grid/all_grids.hpp"
#include "core/engine/mesher/classic_advancer.hpp"
#include "core/engine/mesher/fast_advancer.hpp"
#include "core/engine/mesher/strip_runner.hpp"
#include "core/engine/platform/large_pages.hpp"

#include <algorithm>
#include <type_traits>

namespace forefront {

namespace {

template <template <class, class> class Advancer, class Grid>
class GridMesher final : public Mesher {
  public:
    GridMesher(std::shared_ptr<const DiscreteDomain> boundary, std::shared_ptr<const SpacingField> spacing,
               const FrontCare &care, const FrontRules &rules, Grid grid)
        : Mesher(std::move(boundary), std::move(spacing), care, rules), grid_(std::move(grid)),
          advancer_(state_, grid_, *spacing_, NoTrace{}) {
        Advancer<Grid, NoTrace>::prepare(state_, *boundary_, *spacing_);
        insertFront();
    }

    std::uint64_t advance(std::uint64_t count, std::vector<AdvanceDelta> *deltas) override {
        AdvanceDelta delta;
        std::uint64_t done = 0;
        advancer_.keepLog(deltas != nullptr);
        // With Γ empty, another attempt would drop outdated entries of the order, and the state would depend on it.
        for (; done < count && !finished() && advancer_.advance(delta); ++done) {
            if (deltas != nullptr) {
                deltas->push_back(delta);
            }
        }
        return done;
    }

    bool advanceInParallel(unsigned threads, const Progress &progress, double estimatedElements,
                           std::uint64_t maxElements) override {
        if constexpr (std::is_same_v<Grid, HierarchicalGrid> &&
                      std::is_same_v<Advancer<Grid, NoTrace>, FastAdvancer<Grid, NoTrace>>) {
            if (state_.strips->boxes.size() > 1) {
                if (!runStrips(state_, *spacing_, threads, progress, estimatedElements, maxElements)) {
                    return false;
                }
                grid_ = HierarchicalGrid(boundary_->bounds(), Advancer<Grid, NoTrace>::kCellPerLength);
                insertFront();
            }
        } else {
            static_cast<void>(threads);
            static_cast<void>(progress);
            static_cast<void>(estimatedElements);
            static_cast<void>(maxElements);
        }
        return true;
    }

    void retreat(const AdvanceDelta &delta) override { advancer_.retreat(delta); }

    AdvanceExplanation explainNext() override {
        AdvanceExplanation explanation;
        Advancer<Grid, Recorder> recording(state_, grid_, *spacing_, Recorder{explanation});
        AdvanceDelta delta;
        recording.keepLog(true);
        if (recording.advance(delta)) {
            recording.retreat(delta);
        }
        return explanation;
    }

    void forEachCell(const std::function<void(const Box2 &, std::uint32_t)> &visit) const override {
        grid_.forEachCell(visit);
    }

    void restore(const Checkpoint &checkpoint, const MadeSoFar &made) override {
        state_.front.forEachSlot([this](SlotId id) { grid_.remove(state_.front, id); });
        restoreState(checkpoint, made);
        if constexpr (std::is_same_v<Advancer<Grid, NoTrace>, ClassicAdvancer<Grid, NoTrace>>) {
            state_.order.rebuild(state_.front);
        }
        insertFront();
    }

  private:
    void insertFront() {
        state_.front.forEachSlot([this](SlotId id) { grid_.insert(state_.front, id); });
    }

    Grid grid_;
    Advancer<Grid, NoTrace> advancer_;
};

template <class Grid>
std::unique_ptr<Mesher> createOn(std::shared_ptr<const DiscreteDomain> boundary,
                                 std::shared_ptr<const SpacingField> spacing, const MeshingOptions &options) {
    const auto create = [&]<template <class, class> class Advancer>() -> std::unique_ptr<Mesher> {
        Grid grid = Grid::create(
            {*boundary, *spacing, options.gridColumns, options.gridRows, Advancer<Grid, NoTrace>::kCellPerLength});
        return std::make_unique<GridMesher<Advancer, Grid>>(std::move(boundary), std::move(spacing),
                                                            careFor(options.improve), options.rules, std::move(grid));
    };
    return options.method == Method::Classic ? create.template operator()<ClassicAdvancer>()
                                             : create.template operator()<FastAdvancer>();
}

} // namespace

void addTags(TriMesh &mesh, const DiscreteDomain &boundary, const std::vector<std::uint32_t> &elementFaces) {
    if (!elementFaces.empty()) {
        mesh.regions.reserve(elementFaces.size());
        for (const std::uint32_t region : elementFaces) {
            mesh.regions.push_back(boundary.regions[region].tag);
        }
    } else { // all elements are in the only region
        mesh.regions.assign(mesh.elements.size(), boundary.regions.empty() ? 1 : boundary.regions.front().tag);
    }
    mesh.edges.reserve(boundary.segments.size());
    for (const DiscreteSegment &s : boundary.segments) {
        // The domain lies to the left of a boundary edge.
        const bool reversed = s.leftRegion == kOutside;
        mesh.edges.push_back({NodeId{reversed ? s.b : s.a}, NodeId{reversed ? s.a : s.b}, s.tag});
    }
    mesh.curves = boundary.curves;
    mesh.edgeStretches = boundary.stretches;
    for (std::size_t i = 0; i < mesh.edgeStretches.size(); ++i) {
        if (boundary.segments[i].leftRegion == kOutside) {
            mesh.edgeStretches[i] = mesh.edgeStretches[i].reversed();
        }
    }
    for (const ConstraintPoint &point : boundary.taggedPoints()) {
        mesh.points.push_back({NodeId{point.node}, point.tag});
    }
    mesh.boundaryNames = boundary.boundaryNames;
    mesh.regionNames = boundary.regionNames;
}

Mesher::Mesher(std::shared_ptr<const DiscreteDomain> boundary, std::shared_ptr<const SpacingField> spacing,
               const FrontCare &care, const FrontRules &rules)
    : boundary_(std::move(boundary)), spacing_(std::move(spacing)), state_(*boundary_, care, rules) {}

std::unique_ptr<Mesher> Mesher::create(std::shared_ptr<const DiscreteDomain> boundary,
                                       std::shared_ptr<const SpacingField> spacing, const MeshingOptions &options) {
#define FOREFRONT_CREATE_ON(unused, Grid)                                                                              \
    case Grid::kKind:                                                                                                  \
        return createOn<Grid>(std::move(boundary), std::move(spacing), options);
    switch (options.grid) { FOREFRONT_FOR_EACH_GRID(FOREFRONT_CREATE_ON, ) }
#undef FOREFRONT_CREATE_ON
    return nullptr;
}

namespace {

/// Makes `to` the first `count` entries of `from`, of which it already is a part.
template <class T>
void setPrefix(std::vector<T> &to, const std::vector<T> &from, std::size_t count) {
    to.resize(std::min(to.size(), count));
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(to.size()),
              from.begin() + static_cast<std::ptrdiff_t>(count));
}

template <class T>
void addRest(std::vector<T> &to, const std::vector<T> &from) {
    if (to.size() < from.size()) {
        to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(to.size()), from.end());
    }
}

} // namespace

void MadeSoFar::add(const FrontState &state) {
    addRest(nodes, state.nodes);
    addRest(elements, state.elements);
    addRest(elementFaces, state.elementFaces);
}

void Mesher::restoreState(const Checkpoint &checkpoint, const MadeSoFar &made) {
    state_.front = checkpoint.front;
    state_.walkOrder = checkpoint.walkOrder;
    state_.walk = checkpoint.walk;
    state_.strip = checkpoint.strip;
    state_.work = checkpoint.work;
    state_.smallNodesLeft = checkpoint.smallNodesLeft;
    setPrefix(state_.nodes, made.nodes, checkpoint.nodes);
    setPrefix(state_.elements, made.elements, checkpoint.elements);
    if (state_.manyFaces) {
        setPrefix(state_.elementFaces, made.elementFaces, checkpoint.elements);
    }
}

void Mesher::reserve(std::uint64_t elements) {
    state_.elements.reserve(elements);
    state_.nodes.reserve(state_.nodes.size() + elements / 2);
    if (state_.manyFaces) {
        state_.elementFaces.reserve(elements);
    }
    // Half of the reserved memory is certain to be used; large pages beyond it might be touched for nothing.
    preferLargePages(state_.elements.data(), elements / 2 * sizeof(Element));
    preferLargePages(state_.nodes.data(), elements / 4 * sizeof(Vec2));
}

TriMesh toMesh(const FrontState &state, const DiscreteDomain &boundary) {
    TriMesh mesh;
    mesh.nodes = state.nodes;
    mesh.elements = state.elements;
    addTags(mesh, boundary, state.elementFaces);
    return mesh;
}

TriMesh Mesher::takeMesh() && {
    TriMesh mesh;
    mesh.nodes = std::move(state_.nodes);
    mesh.elements = std::move(state_.elements);
    addTags(mesh, *boundary_, state_.elementFaces);
    return mesh;
}

} // namespace forefront
