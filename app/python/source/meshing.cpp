#include "app/python/source/meshing.hpp"

#include "app/python/source/arrays.hpp"
#include "app/python/source/faults.hpp"
#include "app/python/source/job.hpp"
#include "app/python/source/mesh.hpp"
#include "app/python/source/progress_calls.hpp"
#include "app/python/source/shared_object.hpp"
#include "app/reports/report.hpp"
#include "app/reports/second_order_notes.hpp"
#include "core/drawing/commands/mesh_within_limits.hpp"
#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/adapt/mesh_outline.hpp"
#include "core/engine/mesh/large_elements.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/triangulated.hpp"
#include "core/engine/pipeline/optional_periodic.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/pipeline/run_estimate.hpp"
#include "core/engine/pipeline/target_elements.hpp"
#include "core/engine/platform/process.hpp"
#include "core/engine/spacing/scaled_sizes.hpp"

#include <algorithm>
#include <map>
#include <pybind11/stl.h>
#include <set>
#include <string>
#include <utility>

namespace forefront::python {

namespace {

/// Returns everything that is to be said of a mesh, as the batch program prints it. `job`: as it was meshed.
Diagnostics notesOf(const MeshingOutcome &outcome, const MeshingJob &job) {
    Diagnostics notes = outcome.spacing->notes();
    for (const Diagnostics &more :
         {largeElements(outcome.mesh, job.domain, job.spacing.placed.regions), forcedAngles(outcome.leastAngle),
          flatElements(measureQuality(outcome.mesh, nullptr)), concavePlaces(outcome.quads),
          secondOrderNotes(outcome.order), shortenedLayers(outcome.layers, outcome.mesh.boundaryNames)}) {
        notes.insert(notes.end(), more.begin(), more.end());
    }
    return notes;
}

/// Meshes a job, with `fix` within its limits. Returns also the job of the mesh, and notes on what was changed.
Result<FixedMesh> meshJob(MeshingJob job, const MeshLimits &limits, bool fix, const Progress &progress) {
    if (fix) {
        return meshWithinLimits(std::move(job), limits, progress);
    }
    Result<MeshingOutcome> outcome = meshDomain(job, progress);
    if (!outcome) {
        return outcome.faults();
    }
    return FixedMesh{std::move(job), std::move(*outcome), {}};
}

PythonMesh meshDomainOf(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces,
                        const MeshingOptions &options, const std::map<std::string, double> &given, bool fix,
                        const py::object &callback) {
    MeshingJob asked = jobOf(domain, sizes, replaces, options);
    const Diagnostics leftOut = leaveOutExcludedPeriodic(asked, domain.periodicOfMesh);
    const MeshLimits limits = mergedLimits(domain.limits, limitsOf("limits", given));
    if (fix && !limits.any()) {
        throw py::value_error("fix: there are no limits; give limits={'max_growth': 2} or others");
    }
    const Progress progress = progressOf(callback);
    FixedMesh fixed = valueOrRaise(withoutGil([&] { return meshJob(std::move(asked), limits, fix, progress); }));
    auto &[job, outcome, changes] = fixed;
    MadeBy made{outcome.work,    outcome.quads,          options.leastAngle,  outcome.leastAngle,     options.elements,
                options.improve, outcome.secondsPrepare, outcome.secondsMesh, outcome.secondsImprove, peakMemory()};
    Diagnostics notes = domain.notes;
    for (const Diagnostics &more :
         {leftOut, changes, notesOf(outcome, job),
          limits.any() ? warningsOf(checkLimits(outcome.mesh, limits, outcome.spacing.get(), 1)) : Diagnostics()}) {
        notes.insert(notes.end(), more.begin(), more.end());
    }
    PythonMesh mesh = pythonMesh(std::move(outcome.mesh));
    mesh.spacing = std::move(outcome.spacing);
    mesh.made = made;
    mesh.notes = std::move(notes);
    mesh.unit = domain.unit;
    mesh.system = domain.system;
    return mesh;
}

/// Returns what a run will need: elements, nodes, edges of the boundary, bytes, CPU seconds, and the notes of the
/// domain.
py::tuple estimateOf(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces, const MeshingOptions &options,
                     const py::object &callback) {
    MeshingJob job = jobOf(domain, sizes, replaces, options);
    Diagnostics notes = domain.notes;
    const Diagnostics leftOut = leaveOutExcludedPeriodic(job, domain.periodicOfMesh);
    notes.insert(notes.end(), leftOut.begin(), leftOut.end());
    const Progress progress = progressOf(callback);
    const RunEstimate found = valueOrRaise(withoutGil([&] { return estimateRun(job, progress); }));
    return py::make_tuple(found.elements, found.nodes, found.boundaryEdges, found.bytes, found.seconds,
                          faultList(notes));
}

/// Returns a domain with all sizes of its job, scaled until the mesh has a number of elements.
PythonDomain scaledDomain(const PythonDomain &domain, const SpacingSpec &sizes, bool replaces,
                          const MeshingOptions &options, std::uint64_t target, const py::object &callback) {
    MeshingJob job = jobOf(domain, sizes, replaces, options);
    leaveOutExcludedPeriodic(job, domain.periodicOfMesh);
    const auto scaled = [&job](double factor) {
        MeshingJob next = job;
        next.spacing = scaledSizes(job.spacing, factor, job.domain);
        return next;
    };
    const Progress progress = progressOf(callback);
    const TargetSizes found = valueOrRaise(withoutGil([&] { return sizesForElements(scaled, target, progress); }));
    job = scaled(found.factor);
    PythonDomain result = domain;
    result.spacing = job.spacing;
    const Diagnostics missed = missedTarget(found, target, job);
    result.notes.insert(result.notes.end(), missed.begin(), missed.end());
    return result;
}

/// Numbers the faces of a mesh: the parts between its tagged edges.
class MeshFaces {
  public:
    explicit MeshFaces(const MeshView &mesh) : edges_(edgesOf(mesh)), faces_(mesh.elementCount(), kUnknown) {
        std::set<std::pair<NodeId, NodeId>> lines;
        for (const TaggedEdge &edge : mesh.edges) {
            lines.insert({std::min(edge.a, edge.b), std::max(edge.a, edge.b)});
        }
        for (const MeshEdge &edge : edges_.edges) {
            tagged_.push_back(lines.contains({edge.a, edge.b}) ? 1 : 0);
        }
        for (std::size_t e = 0, face = 0; e < faces_.size(); ++e) {
            if (faces_[e] == kUnknown) {
                fill(e, static_cast<std::int32_t>(face++));
            }
        }
    }

    /// Returns the face of each element, counted from 0 in their order.
    const std::vector<std::int32_t> &faces() const { return faces_; }

  private:
    static constexpr std::int32_t kUnknown = -1;

    void fill(std::size_t first, std::int32_t face) {
        std::vector<std::size_t> pending{first};
        faces_[first] = face;
        while (!pending.empty()) {
            const std::size_t e = pending.back();
            pending.pop_back();
            for (const std::uint32_t edge : edges_.of(e)) {
                for (const ElementId other : edges_.edges[edge].elements) {
                    if (tagged_[edge] == 0 && other != kNoElement && faces_[index(other)] == kUnknown) {
                        faces_[index(other)] = face;
                        pending.push_back(index(other));
                    }
                }
            }
        }
    }

    MeshEdges edges_;
    std::vector<std::uint8_t> tagged_; ///< per edge
    std::vector<std::int32_t> faces_;
};

/// The field of adapt(): an expression, or a function of Python that takes a mesh and returns nodal values.
NodalField fieldOf(const py::object &values, const py::object &wrap) {
    if (py::isinstance<py::str>(values)) {
        return valueOrRaise(expressionField(values.cast<std::string>()));
    }
    return [field = sharedObject(values), make = sharedObject(wrap)](const TriMesh &mesh,
                                                                     const Progress &) -> Result<std::vector<double>> {
        const py::gil_scoped_acquire gil;
        const ArrayOf<double> found((*field)((*make)(py::cast(pythonMesh(TriMesh(mesh))))));
        if (static_cast<std::size_t>(found.size()) != mesh.nodes.size()) {
            throw py::value_error("values: expected one for each of the " + std::to_string(mesh.nodes.size()) +
                                  " nodes, got " + std::to_string(found.size()));
        }
        return std::vector<double>(found.data(), found.data() + found.size());
    };
}

py::tuple adaptedMesh(AdaptOutcome outcome) {
    py::list rounds;
    for (const AdaptRound &round : outcome.rounds) {
        rounds.append(py::make_tuple(round.nodes, round.elements, round.error));
    }
    return py::make_tuple(pythonMesh(std::move(outcome.mesh)), rounds, outcome.met, outcome.stalled);
}

py::tuple adapt(const PythonMesh &self, const PythonDomain *domain, const py::object &values,
                const MeshingOptions &options, const std::map<std::string, double> &target, int rounds,
                const py::object &wrap, const py::object &callback) {
    AdaptTarget goal;
    goal.error = target.at("error");
    goal.gradation = target.at("gradation");
    goal.sizeMin = target.contains("size_min") ? target.at("size_min") : goal.sizeMin;
    goal.sizeMax = target.contains("size_max") ? target.at("size_max") : goal.sizeMax;
    const Progress progress = progressOf(callback);
    MeshingJob job{{}, {}, options};
    if (domain != nullptr) {
        job.domain = domain->domain;
        job.spacing = domain->spacing;
        job.cracks = domain->cracks;
        job.periodic = domain->periodic;
        job.mapped = domain->mapped;
        job.strips = domain->strips;
    } else {
        MeshDomain outline = valueOrRaise(outlineOf(*self.mesh));
        job.domain = std::move(outline.domain);
        job.cracks = std::move(outline.cracks);
        job.periodic = std::move(outline.periodic);
    }
    TriMesh triangles = triangulated(*self.mesh).mesh;
    if (py::isinstance<py::str>(values) || PyCallable_Check(values.ptr()) != 0) {
        const NodalField field = fieldOf(values, wrap);
        return adaptedMesh(valueOrRaise(
            withoutGil([&] { return adaptMesh(job, std::move(triangles), field, goal, rounds, progress); })));
    }
    const ArrayOf<double> given(values);
    if (static_cast<std::size_t>(given.size()) != triangles.nodes.size()) {
        throw py::value_error("values: expected one for each of the " + std::to_string(triangles.nodes.size()) +
                              " nodes, got " + std::to_string(given.size()));
    }
    const std::vector<double> field(given.data(), given.data() + given.size());
    return adaptedMesh(valueOrRaise(withoutGil([&] { return adaptMeshOnce(job, triangles, field, goal, progress); })));
}

} // namespace

void bindMeshing(py::module_ &module) {
    module.def("mesh", &meshDomainOf);
    module.def("estimate", &estimateOf);
    module.def("scaled_domain", &scaledDomain);
    module.def("mesh_faces", [](const PythonMesh &self) {
        return copyOfValues<std::int32_t>(withoutGil([&] { return MeshFaces(*self.mesh).faces(); }));
    });
    module.def("adapt", &adapt);
    module.def("outline", [](const PythonMesh &self) {
        MeshDomain outline = valueOrRaise(withoutGil([&] { return outlineOf(*self.mesh); }));
        PythonDomain domain{std::move(outline.domain), {}, {}, std::move(outline.cracks), std::move(outline.periodic)};
        domain.periodicOfMesh = domain.periodic;
        return domain;
    });
}

} // namespace forefront::python
