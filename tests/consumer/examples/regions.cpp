// Find the edges of a boundary part, and which regions lie on either side of an interface.
#include <cstdio>
#include <forefront/forefront.hpp>

int main() {
    forefront::MeshingJob job;
    job.domain.nodes = {{0, 0}, {2, 0}, {4, 0}, {4, 3}, {2, 3}, {0, 3}};
    job.domain.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 4, 1}, {4, 5, 1}, {5, 0, 1}};
    job.domain.segments.push_back({1, 4, 9, forefront::SegmentRole::Constraint});
    job.domain.regionMarkers = {{.at = {1, 1}, .tag = 10}, {.at = {3, 1}, .tag = 20}};
    const forefront::Mesh mesh = forefront::meshDomain(job).value().mesh;
    const std::vector<forefront::EdgeSides> sides = forefront::edgeSides(mesh);
    int wrong = mesh.blocks.front().regions.size() == mesh.elementCount() ? 0 : 1;
    for (const std::uint32_t edge : forefront::edgesWithTag(mesh, 9)) {
        std::printf("edge %u: %d | %d\n", edge, sides[edge].leftRegion, sides[edge].rightRegion);
        wrong += sides[edge].isInterface() ? 0 : 1;
    }
    return wrong;
}
