#include "app/batch/part_options.hpp"

#include "app/batch/exit_code.hpp"
#include "app/batch/layers_option.hpp"
#include "app/batch/mapped_option.hpp"
#include "app/batch/open_boundaries.hpp"
#include "app/batch/periodic_option.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/pipeline/optional_periodic.hpp"

namespace forefront {

namespace {

/// Applies one kind of options after the other, up to the first faults.
Diagnostics applied(const MeshArguments &arguments, std::span<const PeriodicSpec> periodicOfMesh, MeshingJob &job) {
    Diagnostics faults = applyElements(arguments.elements, job);
    if (faults.empty()) {
        faults = applyLayers(arguments.layers, job);
    }
    if (faults.empty()) {
        faults = applyCracks(arguments.cracks, job.domain, job.cracks);
    }
    if (faults.empty()) {
        faults = applyStrips(arguments.strips, job.domain, job.strips);
    }
    if (faults.empty()) {
        const Diagnostics notes = leaveOutExcludedPeriodic(job, periodicOfMesh);
        if (!arguments.quiet) {
            printFaults(notes);
        }
        faults = applyPeriodic(arguments.periodic, job);
    }
    if (faults.empty()) {
        faults = applyMapped(arguments.mapped, job);
    }
    if (faults.empty()) {
        faults = checkOpenNames(arguments.form, job.domain);
    }
    return faults;
}

} // namespace

Diagnostics applyPartOptions(const MeshArguments &arguments, const Input &input,
                             std::span<const PeriodicSpec> periodicOfMesh, MeshingJob &job) {
    return allFormats().locateFaults(input.path, applied(arguments, periodicOfMesh, job), input.options);
}

} // namespace forefront
