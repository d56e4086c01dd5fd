// Write a format of your own, and pass a mesh on in memory.
#include <cstdio>
#include <forefront/forefront.hpp>

int main() {
    forefront::MeshingJob job;
    forefront::addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    const forefront::Mesh mesh = forefront::meshDomain(job).value().mesh;
    std::printf("nodes %zu\n", mesh.nodes.size());
    for (const forefront::Vec2 node : mesh.nodes) {
        std::printf("%.17g %.17g\n", node.x, node.y);
    }
    forefront::StringSink sink;
    const bool written = !hasErrors(forefront::writeMesh(sink, mesh, "msh2"));
    const auto back = forefront::readMesh(forefront::MemoryFile{sink.text, "msh2"});
    return written && back && back->elementCount() == mesh.elementCount() ? 0 : 1;
}
