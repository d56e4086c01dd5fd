#include "core/engine/domain/add_loop.hpp"
#include "core/engine/layers/layer_rows.hpp"
#include "core/engine/pipeline/layer_plan.hpp"
#include "core/engine/pipeline/pipeline.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <set>
#include <stop_token>
#include <tuple>
#include <vector>

namespace forefront {

namespace planned_layers {

/// A channel with a narrow throat, so that some rays are shortened and others slide along the open ends.
MeshingJob channel() {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {6, 0}, {6, 3}, {3.4, 3}, {3, 0.3}, {2.6, 3}, {0, 3}}, 1);
    job.spacing.size = 0.3;
    LayerSpec spec;
    spec.tag = 1;
    spec.first = 0.01;
    spec.growth = 1.3;
    spec.count = 8;
    job.layers = {spec};
    return job;
}

using Line = std::tuple<double, double, double, double>;

/// Returns a line in either direction as the same value.
Line lineOf(Vec2 a, Vec2 b) {
    const bool turned = std::tie(b.x, b.y) < std::tie(a.x, a.y);
    return turned ? Line{b.x, b.y, a.x, a.y} : Line{a.x, a.y, b.x, b.y};
}

} // namespace planned_layers

TEST_CASE("Rows of layers: planned ones are those of the mesh, bit for bit") {
    for (const LayerCells cells : {LayerCells::Quads, LayerCells::Triangles}) {
        MeshingJob job = planned_layers::channel();
        job.layers.front().cells = cells;
        const Result<LayerRows> planned = planLayerRows(job);
        const Result<PreparedJob> made = prepare(job);
        REQUIRE(planned);
        REQUIRE(made);
        REQUIRE(made->layers);
        const LayerReport &report = made->layers->report;
        CHECK_FALSE(report.shortened.empty());
        REQUIRE(planned->report.lines.size() == report.lines.size());
        for (std::size_t k = 0; k < report.lines.size(); ++k) {
            CHECK(planned->report.lines[k].base == report.lines[k].base);
            CHECK(planned->report.lines[k].end == report.lines[k].end);
            CHECK(planned->report.lines[k].layers == report.lines[k].layers);
        }
        REQUIRE(planned->report.shortened.size() == report.shortened.size());
        for (std::size_t k = 0; k < report.shortened.size(); ++k) {
            CHECK(planned->report.shortened[k].made == report.shortened[k].made);
            CHECK(planned->report.shortened[k].stop == report.shortened[k].stop);
        }
        // Every piece of a row is an edge of an element.
        std::vector<Vec2> nodes = made->layers->outer->nodes;
        nodes.insert(nodes.end(), made->layers->inner.begin(), made->layers->inner.end());
        std::set<planned_layers::Line> edges;
        for (const LayerCell &cell : made->layers->cells) {
            const std::size_t corners = cell.nodes[3] == kNoIndex ? 3 : 4;
            for (std::size_t k = 0; k < corners; ++k) {
                edges.insert(planned_layers::lineOf(nodes[cell.nodes[k]], nodes[cell.nodes[(k + 1) % corners]]));
            }
        }
        CHECK(planned->pieces.size() > report.lines.size());
        for (const std::array<Vec2, 2> &piece : planned->pieces) {
            CHECK(edges.contains(planned_layers::lineOf(piece[0], piece[1])));
        }
    }
}

TEST_CASE("Rows of layers: of very many only the tops are kept, and a cancelled plan is none") {
    MeshingJob job = planned_layers::channel();
    job.spacing.size = 0.01;
    job.layers.front().first = 1e-5;
    job.layers.front().growth = 1.0;
    job.layers.front().count = 200;
    const Result<LayerRows> planned = planLayerRows(job);
    REQUIRE(planned);
    CHECK(planned->report.most == 200);
    CHECK(planned->pieces.size() <= planned->report.lines.size());
    CHECK(planned->pieces.size() > 100);
    Progress cancelled;
    std::stop_source source;
    source.request_stop();
    cancelled.stop = source.get_token();
    const Result<LayerRows> none = planLayerRows(job, cancelled);
    REQUIRE_FALSE(none);
    CHECK(none.faults().front().code == "cancelled");
    job.layers.clear();
    const Result<LayerRows> empty = planLayerRows(job);
    REQUIRE(empty);
    CHECK(empty->pieces.empty());
}

} // namespace forefront
