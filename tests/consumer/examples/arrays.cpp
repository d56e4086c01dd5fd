// Pass a mesh to code that wants plain arrays: coordinates x0 y0 x1 y1 ... and three node indices per triangle.
#include <cstdio>
#include <forefront/forefront.hpp>

int main() {
    forefront::MeshingJob job;
    forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    const forefront::Mesh mesh = forefront::meshDomain(job).value().mesh;
    const std::span<const double> xy = forefront::coordinates(mesh);
    const std::span<const std::uint32_t> corners = forefront::connectivity(mesh.blocks.front());
    double area = 0.0;
    for (std::size_t t = 0; t < corners.size(); t += 3) {
        const double *a = &xy[2 * corners[t]], *b = &xy[2 * corners[t + 1]], *c = &xy[2 * corners[t + 2]];
        area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    }
    std::printf("%zu triangles of area %g\n", corners.size() / 3, area);
    return area > 11.999 && area < 12.001 ? 0 : 1;
}
