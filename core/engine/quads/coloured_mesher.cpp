#include "core/engine/quads/coloured_mesher.hpp"

#include "core/engine/base/hash.hpp"
#include "core/engine/grid/all_grids.hpp"
#include "core/engine/quads/coloured_advancer.hpp"
#include "core/engine/quads/pairing.hpp"
#include "core/engine/quads/quad_blocks.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

/// What a checkpoint keeps of the two-coloured front. Colours follow from the number of nodes.
struct ColouredPart final : CheckpointPart {
    std::vector<NodeId> opposite;
    FrontLayers layers;
    ColouredWork work;
    std::uint64_t advances;

    explicit ColouredPart(const ColouredState &state)
        : opposite(state.opposite), layers(state.layers.withoutHistory()), work(state.work), advances(state.advances) {}
    std::size_t bytes() const override { return sizeof *this + opposite.size() * sizeof(NodeId) + layers.bytes(); }
};

template <class Grid>
class ColouredGridMesher final : public ColouredMesher {
  public:
    ColouredGridMesher(std::shared_ptr<const ColouredBoundary> boundary, std::shared_ptr<const SpacingField> spacing,
                       std::uint32_t rows, Grid grid)
        : ColouredMesher(std::move(boundary), std::move(spacing), rows), grid_(std::move(grid)),
          advancer_(state_, coloured_, grid_, *spacing_, NoSquareTrace{}, fixedNodes()) {
        ColouredAdvancer<Grid, NoSquareTrace>::prepare(state_, coloured_, *spacing_);
        insertFront();
    }

    std::uint64_t advance(std::uint64_t count, std::vector<AdvanceDelta> *deltas) override {
        AdvanceDelta delta;
        std::uint64_t done = 0;
        coloured_.keepLog(deltas != nullptr);
        for (; done < count && !finished() && advancer_.advance(delta); ++done) {
            if (deltas != nullptr) {
                deltas->push_back(delta);
            }
        }
        if (deltas != nullptr) {
            keepColours();
        }
        return done;
    }

    void retreat(const AdvanceDelta &delta) override { advancer_.retreat(delta); }

    AdvanceExplanation explainNext() override {
        AdvanceExplanation explanation;
        ColouredAdvancer<Grid, SquareRecorder> recording(state_, coloured_, grid_, *spacing_,
                                                         SquareRecorder{explanation}, fixedNodes());
        AdvanceDelta delta;
        coloured_.keepLog(true);
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
        restoreColoured(checkpoint, made);
        insertFront();
    }

  private:
    std::size_t fixedNodes() const { return boundary_->nodes.size(); }
    void insertFront() {
        state_.front.forEachSlot([this](SlotId id) { grid_.insert(state_.front, id); });
    }

    Grid grid_;
    ColouredAdvancer<Grid, NoSquareTrace> advancer_;
};

template <class Grid>
std::unique_ptr<ColouredMesher> createColoured(std::shared_ptr<const ColouredBoundary> boundary,
                                               std::shared_ptr<const SpacingField> spacing,
                                               const MeshingOptions &options, std::uint32_t rows) {
    Grid grid = Grid::create({boundary->domain, *spacing, options.gridColumns, options.gridRows,
                              ColouredAdvancer<Grid, NoSquareTrace>::kCellPerLength});
    return std::make_unique<ColouredGridMesher<Grid>>(std::move(boundary), std::move(spacing), rows, std::move(grid));
}

} // namespace

ColouredMesher::ColouredMesher(std::shared_ptr<const ColouredBoundary> boundary,
                               std::shared_ptr<const SpacingField> spacing, std::uint32_t rows)
    : Mesher(std::shared_ptr<const DiscreteDomain>(boundary, &boundary->domain), std::move(spacing), FrontCare{},
             FrontRules{}),
      colouredBoundary_(std::move(boundary)), coloured_(colouredBoundary_->colours, rows),
      everyColour_(colouredBoundary_->colours) {}

std::unique_ptr<ColouredMesher> ColouredMesher::create(std::shared_ptr<const ColouredBoundary> boundary,
                                                       std::shared_ptr<const SpacingField> spacing,
                                                       const MeshingOptions &options, std::uint32_t rows) {
#define FOREFRONT_CREATE_COLOURED(unused, Grid)                                                                        \
    case Grid::kKind:                                                                                                  \
        return createColoured<Grid>(std::move(boundary), std::move(spacing), options, rows);
    switch (options.grid) { FOREFRONT_FOR_EACH_GRID(FOREFRONT_CREATE_COLOURED, ) }
#undef FOREFRONT_CREATE_COLOURED
    return nullptr;
}

void ColouredMesher::keepColours() {
    const std::vector<std::uint8_t> &now = coloured_.colours;
    if (everyColour_.size() < now.size()) {
        everyColour_.insert(everyColour_.end(), now.begin() + static_cast<std::ptrdiff_t>(everyColour_.size()),
                            now.end());
    }
}

Checkpoint ColouredMesher::checkpoint() const {
    Checkpoint checkpoint(state_);
    checkpoint.part = std::make_shared<const ColouredPart>(coloured_);
    return checkpoint;
}

void ColouredMesher::restoreColoured(const Checkpoint &checkpoint, const MadeSoFar &made) {
    restoreState(checkpoint, made);
    const auto &part = static_cast<const ColouredPart &>(*checkpoint.part);
    coloured_.colours.assign(everyColour_.begin(),
                             everyColour_.begin() + static_cast<std::ptrdiff_t>(checkpoint.nodes));
    coloured_.opposite = part.opposite;
    coloured_.layers = part.layers;
    coloured_.work = part.work;
    coloured_.advances = part.advances;
    coloured_.clearLog();
}

std::uint64_t ColouredMesher::stateHash() const {
    Hash64 hash;
    hash.add(state_.hash());
    for (const std::uint8_t colour : coloured_.colours) {
        hash.add(std::uint64_t{colour});
    }
    const GenerationFront &front = state_.front;
    front.forEachSlot([&](SlotId id) {
        if (!front.isolated(id)) {
            const NodeId opposite = index(id) < coloured_.opposite.size() ? coloured_.opposite[index(id)] : kNoNode;
            hash.add((static_cast<std::uint64_t>(index(opposite)) << 32U) | coloured_.layers.layerOf(id));
        }
    });
    coloured_.layers.addTo(hash);
    const ColouredWork &work = coloured_.work;
    for (const std::uint64_t value :
         {work.rows, work.openings, work.closings, work.searched, work.forced, coloured_.advances}) {
        hash.add(value);
    }
    return hash.value();
}

ColouredTriangles ColouredMesher::triangles() const {
    ColouredTriangles result{{}, coloured_.colours, state_.elementFaces};
    result.mesh.nodes = state_.nodes;
    result.mesh.elements = state_.elements;
    return result;
}

ColouredTriangles ColouredMesher::takeTriangles() {
    ColouredTriangles result{{}, std::move(coloured_.colours), std::move(state_.elementFaces)};
    result.mesh.nodes = std::move(state_.nodes);
    result.mesh.elements = std::move(state_.elements);
    return result;
}

PairedCells ColouredMesher::joinedCells() const {
    return pairTriangles(triangles(), oneColouredEdges(*colouredBoundary_), OneColoured::Leave);
}

std::optional<Mesh> ColouredMesher::joinedMesh() const {
    const PairedCells cells = joinedCells();
    return meshOfCells({cells.nodes, cells.cells, cells.faces}, *boundary_);
}

} // namespace forefront
