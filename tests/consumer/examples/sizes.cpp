// Read a domain with the sizes that its file has, and set a region's, a node's and a boundary part's.
#include <forefront/forefront.hpp>

int main() {
    const char *text = "4 2\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n4 1\n1 1 2 5\n2 2 3 1\n3 3 4 1\n4 4 1 1\n0\n1\n1 1 1 7 0.1\n";
    const auto file = forefront::readDomain(forefront::MemoryFile{text, "poly"}).value(); // area of region 7: 0.1
    forefront::MeshingJob job{file.domain, file.spacing, {}};
    const std::size_t before = forefront::meshDomain(job).value().mesh.elementCount();
    job.spacing.placed.regions = {{.at = {1, 1}, .size = 0.3}};
    job.spacing.placed.nodes = {{.at = {4, 3}, .size = 0.02}};
    job.spacing.partSizes[5] = {.size = 0.05, .growth = 0.3};
    const auto outcome = forefront::meshDomain(job);
    return outcome && outcome->mesh.elementCount() > 2 * before ? 0 : 1;
}
