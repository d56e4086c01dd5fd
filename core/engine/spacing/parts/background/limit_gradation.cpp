#include "core/engine/spacing/parts/background/limit_gradation.hpp"

#include "core/engine/base/paced_progress.hpp"
#include "core/engine/base/rows.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns the nodes that share an edge with each node; those of inner edges are listed twice.
Rows<std::uint32_t> neighboursOf(const BackgroundMesh &mesh) {
    return {
        mesh.nodes.size(), [&](const auto &add) {
            for (const auto &[a, b, c] : mesh.elements) {
                for (const auto &[node, one, other] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
                    add(node, one);
                    add(node, other);
                }
            }
        }};
}

} // namespace

bool limitGradation(BackgroundMesh &mesh, double gradation, const Progress &progress) {
    const Rows<std::uint32_t> around = neighboursOf(mesh);
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
        for (const std::uint32_t next : around[node]) {
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
