// Reads meshes with MFEM and prints what MFEM makes of them: elements, area, the length of each boundary attribute, and
// the least Jacobian at the points of integration, which is positive only if the nodes are in the order that MFEM
// expects.
//
//   g++ -std=c++17 -I MFEM tests/readers/check_mfem.cpp MFEM/libmfem.a -o check_mfem && ./check_mfem FILE.mesh...
#include <algorithm>
#include <cstdio>
#include <map>
#include <mfem.hpp>

namespace {

double areaOf(mfem::Mesh &mesh, double &least) {
    double area = 0.0;
    for (int e = 0; e < mesh.GetNE(); ++e) {
        mfem::ElementTransformation &map = *mesh.GetElementTransformation(e);
        const mfem::IntegrationRule &rule = mfem::IntRules.Get(map.GetGeometryType(), 4);
        for (int k = 0; k < rule.GetNPoints(); ++k) {
            map.SetIntPoint(&rule.IntPoint(k));
            const double jacobian = map.Jacobian().Det();
            least = std::min(least, jacobian);
            area += rule.IntPoint(k).weight * jacobian;
        }
    }
    return area;
}

std::map<int, double> lengthsOf(mfem::Mesh &mesh) {
    std::map<int, double> lengths;
    for (int e = 0; e < mesh.GetNBE(); ++e) {
        mfem::ElementTransformation &map = *mesh.GetBdrElementTransformation(e);
        const mfem::IntegrationRule &rule = mfem::IntRules.Get(map.GetGeometryType(), 8);
        for (int k = 0; k < rule.GetNPoints(); ++k) {
            map.SetIntPoint(&rule.IntPoint(k));
            lengths[mesh.GetBdrAttribute(e)] += rule.IntPoint(k).weight * map.Weight();
        }
    }
    return lengths;
}

} // namespace

int main(int count, char **words) {
    for (int k = 1; k < count; ++k) {
        mfem::Mesh mesh(words[k], 1, 1);
        const bool curved = mesh.GetNodes() != nullptr;
        double least = mfem::infinity();
        const double area = areaOf(mesh, least);
        std::printf("%s: %d elements, %d vertices, %s, area %.9g, least Jacobian %.3g, lengths", words[k], mesh.GetNE(),
                    mesh.GetNV(), curved ? mesh.GetNodes()->FESpace()->FEColl()->Name() : "straight", area, least);
        for (const auto &[attribute, length] : lengthsOf(mesh)) {
            std::printf(" %d:%.9g", attribute, length);
        }
        std::printf("\n");
    }
}
