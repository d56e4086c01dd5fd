#include "app/python/source/derived.hpp"

#include "app/python/source/arrays.hpp"
#include "app/python/source/domain.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/job.hpp"
#include "app/python/source/progress_calls.hpp"
#include "app/reports/report.hpp"
#include "app/reports/second_order_notes.hpp"
#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/numbering.hpp"
#include "core/engine/mesh/second_order.hpp"
#include "core/engine/quads/recombine.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront::python {

namespace {

/// Returns a changed mesh with what is known of the one that it was made from. Its figures of the run no longer hold.
PythonMesh derivedFrom(const PythonMesh &self, Mesh mesh) {
    PythonMesh derived = pythonMesh(std::move(mesh));
    derived.spacing = self.spacing;
    derived.notes = self.notes;
    derived.unit = self.unit;
    derived.system = self.system;
    return derived;
}

PythonMesh recombinedMesh(const PythonMesh &self, const std::string &word, const py::object &callback) {
    const std::optional<ImproveLevel> improve = fromWord<ImproveLevel>(word);
    if (!improve) {
        throw py::value_error("improve: expected " + wordList<ImproveLevel>() + ", got '" + word + "'");
    }
    Mesh mesh = *self.mesh;
    const Progress progress = progressOf(callback);
    const QuadReport report = valueOrRaise(withoutGil([&] { return recombine(mesh, *improve, progress); }));
    PythonMesh result = derivedFrom(self, std::move(mesh));
    if (report.triangles > 0) {
        result.notes.push_back(noteOf("triangles-left", countText(report.triangles, "triangle") +
                                                            " left, where faces have odd numbers of edges, or "
                                                            "lines that must stay meet at flat angles"));
    }
    const Diagnostics concave = concavePlaces(report);
    result.notes.insert(result.notes.end(), concave.begin(), concave.end());
    return result;
}

PythonMesh raisedMesh(const PythonMesh &self, int quadNodes, const py::object &callback) {
    if (quadNodes != 8 && quadNodes != 9) {
        throw py::value_error("quad_nodes: expected 8 or 9, got " + std::to_string(quadNodes));
    }
    for (const CellBlock &block : self.mesh->blocks) {
        if (block.traits().order == 2 && block.size() > 0) {
            throw py::value_error("expected elements of first order, got " + countText(block.size(), "element") +
                                  " of second order; triangulated() makes elements of first order");
        }
    }
    Mesh mesh = *self.mesh;
    SecondOrderReport report;
    const Progress progress = progressOf(callback);
    const QuadNodes nodes = quadNodes == 9 ? QuadNodes::Nine : QuadNodes::Eight;
    if (!withoutGil([&] { return raiseOrder(mesh, {.quadNodes = nodes}, report, progress); })) {
        raiseFaults(cancelled("raising the order"));
    }
    PythonMesh result = derivedFrom(self, std::move(mesh));
    const Diagnostics notes = secondOrderNotes(report);
    result.notes.insert(result.notes.end(), notes.begin(), notes.end());
    return result;
}

py::array smallBandwidthNumbers(const PythonMesh &self) {
    std::vector<std::uint32_t> numbers;
    for (const NodeId number : withoutGil([&] { return reverseCuthillMcKee(*self.mesh); })) {
        numbers.push_back(static_cast<std::uint32_t>(index(number)));
    }
    return copyOfValues<std::uint32_t>(numbers);
}

/// Returns the mesh with other numbers. `numbers`: a permutation, the new number of each node.
PythonMesh renumberedMesh(const PythonMesh &self, const ArrayOf<std::uint32_t> &numbers) {
    const std::vector<std::uint32_t> given(numbers.data(), numbers.data() + numbers.size());
    std::vector<bool> seen(self.mesh->nodes.size());
    std::vector<NodeId> order;
    for (const std::uint32_t number : given) {
        if (number >= seen.size() || seen[number]) {
            throw py::value_error("expected each number of a node once");
        }
        seen[number] = true;
        order.push_back(NodeId{number});
    }
    if (order.size() != seen.size()) {
        throw py::value_error("expected a number for each node");
    }
    PythonMesh result = derivedFrom(self, withoutGil([&] { return renumbered(*self.mesh, order); }));
    result.made = self.made; // the same elements
    return result;
}

/// Returns the mesh with the spacing of a job, which its edges are compared with.
PythonMesh meshWithSpacing(const PythonMesh &self, const PythonDomain &domain, const SpacingSpec &sizes, bool replaces,
                           const MeshingOptions &options) {
    const MeshingJob job = jobOf(domain, sizes, replaces, options);
    const Progress progress = progressOf(py::none());
    PythonMesh result = self;
    result.spacing = valueOrRaise(withoutGil([&] { return SpacingField::build(job.spacing, job.domain, progress); }));
    return result;
}

} // namespace

void bindDerived(py::class_<PythonMesh> &mesh) {
    mesh.def("_recombined", &recombinedMesh)
        .def("_raised", &raisedMesh)
        .def("_small_bandwidth", &smallBandwidthNumbers)
        .def("_renumbered", &renumberedMesh)
        .def("_with_spacing", &meshWithSpacing);
}

} // namespace forefront::python
