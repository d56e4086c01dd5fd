#include "core/engine/spacing/parts/background/limit_gradation.hpp"

#include "core/engine/base/paced_progress.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// The nodes that share an edge with each node, in rows; those of inner edges are listed twice.
struct NodeNeighbours {
    explicit NodeNeighbours(const BackgroundMesh &mesh) : offsets(mesh.nodes.size() + 1, 0) {
        for (const auto &corners : mesh.elements) {
            for (const std::uint32_t node : corners) {
                offsets[node + 1] += 2;
            }
        }
        std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
        nodes.resize(offsets.back());
        std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
        for (const auto &[a, b, c] : mesh.elements) {
            for (const auto &[node, one, other] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
                nodes[next[node]++] = one;
                nodes[next[node]++] = other;
            }
        }
    }
    std::vector<std::uint32_t> offsets, nodes;
};

} // namespace

bool limitGradation(BackgroundMesh &mesh, double gradation, const Progress &progress) {
    const NodeNeighbours around(mesh);
    std::vector<double> &values = mesh.values;
    using Entry = std::pair<double, std::uint32_t>;
    std::vector<Entry> entries;
    entries.reserve(values.size());
    for (std::uint32_t n = 0; n < values.size(); ++n) {
        entries.emplace_back(values[n], n);
    }
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue({}, std::move(entries));
    // Most nodes leave the queue once, some of them again after being lowered further.
    PacedProgress pace(progress, "limiting the gradation", values.size());
    while (!queue.empty()) {
        if (!pace.next()) {
            return false;
        }
        const auto [value, node] = queue.top();
        queue.pop();
        if (value > values[node]) {
            continue; // lowered since it was queued
        }
        for (std::uint32_t i = around.offsets[node]; i < around.offsets[node + 1]; ++i) {
            const std::uint32_t next = around.nodes[i];
            const double limit = value + gradation * distance(mesh.nodes[node], mesh.nodes[next]);
            if (limit < values[next]) {
                values[next] = limit;
                queue.emplace(limit, next);
            }
        }
    }
    return true;
}

std::shared_ptr<const BackgroundMesh> withoutSteepEdges(const BackgroundMesh &mesh, double minimum, double gradation,
                                                        const Progress &progress) {
    const auto value = [&](std::uint32_t node) { return std::max(mesh.values[node], minimum); };
    const auto isSteep = [&](std::uint32_t a, std::uint32_t b) {
        constexpr double kSlack = 1.0 + 1e-9; // values that were limited before must pass
        return std::fabs(value(a) - value(b)) > kSlack * gradation * distance(mesh.nodes[a], mesh.nodes[b]);
    };
    if (std::none_of(mesh.elements.begin(), mesh.elements.end(), [&](const auto &corners) {
            const auto &[a, b, c] = corners;
            return isSteep(a, b) || isSteep(b, c) || isSteep(c, a);
        })) {
        return nullptr;
    }
    auto gentle = std::make_shared<BackgroundMesh>(mesh);
    for (double &size : gentle->values) {
        size = std::max(size, minimum);
    }
    return limitGradation(*gentle, gradation, progress) ? gentle : nullptr;
}

} // namespace forefront
