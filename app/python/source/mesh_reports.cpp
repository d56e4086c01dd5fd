#include "app/python/source/arrays.hpp"
#include "app/python/source/domain.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/job.hpp"
#include "app/python/source/mesh.hpp"
#include "app/python/source/progress_calls.hpp"
#include "app/reports/report.hpp"
#include "core/engine/mesh/large_elements.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/verify.hpp"

#include <map>
#include <optional>
#include <pybind11/stl.h>
#include <string>

namespace forefront::python {

namespace {

py::array measureArray(const PythonMesh &self, const std::string &word) {
    const std::optional<Measure> measure = fromWord<Measure>(word);
    if (!measure) {
        throw py::value_error("measure: expected " + wordList<Measure>() + ", got '" + word + "'");
    }
    const std::vector<double> values =
        withoutGil([&] { return measureValues(*measure, *self.mesh, edgesOf(*self.mesh), self.spacing.get()); });
    if (values.empty() && self.mesh->elementCount() > 0) {
        throw py::value_error("measure: '" + word +
                              "' compares with the node spacing, which is known only for a mesh that was made here; "
                              "with_size() gives one to any mesh");
    }
    return copyOfValues<double>(values);
}

std::string summaryJson(const PythonMesh &self) {
    return withoutGil([&] {
        const bool valid = !hasErrors(verify(*self.mesh, 1));
        const MeshReport figures = reportOf(*self.mesh, self.spacing.get(), valid);
        if (!self.made) {
            return statisticsJson(figures, valid, {});
        }
        RunReport report;
        static_cast<MeshReport &>(report) = figures;
        report.work = self.made->work;
        report.quads = self.made->quads;
        report.leastAngle = self.made->leastAngle;
        report.angles = self.made->angles;
        report.elements = self.made->elements;
        report.improve = self.made->improve;
        report.secondsPrepare = self.made->secondsPrepare;
        report.secondsMesh = self.made->secondsMesh;
        report.secondsImprove = self.made->secondsImprove;
        report.peakBytes = self.made->peakBytes;
        return statisticsJson(report);
    });
}

py::list checkMesh(const PythonMesh &self, const PythonDomain *checked, const std::map<std::string, double> &given) {
    // A copy: another thread may change the domain meanwhile.
    std::optional<PythonDomain> domain = checked != nullptr ? std::optional(*checked) : std::nullopt;
    const MeshLimits limits = limitsOf("check", given);
    return faultList(withoutGil([&] {
        if (domain) {
            PlacedSizes &placed = domain->spacing.placed;
            if (Diagnostics wrong =
                    widenStrips(domain->strips, domain->cracks, {}, domain->domain, placed.elements, placed.biases);
                !wrong.empty()) {
                return wrong;
            }
        }
        Diagnostics faults = domain ? verifyAgainst(*self.mesh, domain->domain, domain->spacing.placed.counts(),
                                                    kMaxListedFaults, {}, true, domain->cracks)
                                    : verify(*self.mesh);
        if (hasErrors(faults)) {
            return faults;
        }
        if (domain) {
            const Diagnostics large = largeElements(*self.mesh, domain->domain, domain->spacing.placed.regions);
            faults.insert(faults.end(), large.begin(), large.end());
        }
        for (const LimitVerdict &verdict : checkLimits(*self.mesh, limits, self.spacing.get())) {
            if (verdict.judged == 0 && verdict.limit == MeshLimit::MinDelta) {
                const Diagnostics none =
                    error("no-spacing", "min-delta needs a node spacing, and the mesh has none",
                          "check the mesh that mesh() returned, or give it a spacing by with_size()");
                faults.insert(faults.end(), none.begin(), none.end());
            }
            const Diagnostics broken = faultsOf(verdict);
            faults.insert(faults.end(), broken.begin(), broken.end());
        }
        return faults;
    }));
}

} // namespace

void bindMeshReports(py::class_<PythonMesh> &mesh) {
    mesh.def("quality", &measureArray, py::arg("measure") = "alpha")
        .def("_summary", &summaryJson)
        .def("_check", &checkMesh);
}

} // namespace forefront::python
